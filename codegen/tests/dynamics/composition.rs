//! What a description comes to in a state, put together from its own frames, masses and joints in plain numbers.
//!
//! In: the description as read, and from the generator's tree no more than which coordinate and speed stand where. Out:
//! where every frame is, what every body weighs with all that is fixed to it, and what acts in its joints. None of the
//! generator's own axes, origins, merging or tracing of what follows what is used.

use kane_codegen::{
    description::{
        Description, JointKind, PerCoordinate, Scalar, WrittenBody as Body, WrittenJoint as Joint,
        toml,
    },
    diagnostic::{Source, Spanned},
    id::BodyId,
    tree::{ChartCoordinates as Chart, Frame, Orientation, Tree},
};

use super::{
    State,
    numeric::{largest, relative, relative_to},
    random::rotation::{
        IDENTITY, Rotation, Vector, about, angles_123, cross, dot, hamilton, of_quaternion,
        product, rate_columns, scaled, sum, times, transposed, unit,
    },
};

/// A description, and where its coordinates and speeds stand.
#[derive(Clone, Debug)]
pub(crate) struct Composition {
    description: Description,
    /// For each body of the description the one of the tree that moves with its joint, if that moves.
    moving: Vec<Option<BodyId>>,
    tree: Tree,
}

/// A body of the description in a state.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Placed {
    /// Inertial components to the body's.
    pub(crate) rotation: Rotation,
    /// From the inertial origin to the body's, inertial components.
    pub(crate) origin: Vector,
}

const INERTIAL: Placed = Placed {
    rotation: IDENTITY,
    origin: [0.0; 3],
};

/// A body of the tree with all that is fixed to it, in the user's axes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Solid {
    pub(crate) mass: f64,
    /// From the body's origin.
    pub(crate) center: Vector,
    /// About the mass centre.
    pub(crate) inertia: Rotation,
}

/// A coordinate by another: `multiplier` times that one plus `offset`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Link {
    /// The places in `q` and `u`; none for a constant, which is `offset`.
    pub(crate) places: Option<[usize; 2]>,
    pub(crate) multiplier: f64,
    pub(crate) offset: f64,
}

/// What acts along a motion of a joint.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Acting {
    /// Where the motion's coordinate is; none for a component of an angular velocity.
    coordinate: Option<Link>,
    /// The place of its speed in `u`, and the motion's own speed for a unit of that.
    speed: usize,
    factor: f64,
    stiffness: f64,
    rest: f64,
    damping: f64,
    armature: f64,
}

impl Composition {
    pub(crate) fn new(text: &str, tree: &Tree) -> Self {
        let description = toml::parse(&Source::new("model.toml", text));
        let mut moving = vec![None; description.bodies.len()];
        for body in tree.body_ids() {
            moving[tree.body(body).user_number - 1] = Some(body);
        }
        Self {
            description,
            moving,
            tree: tree.clone(),
        }
    }

    fn lower(&self, place: usize) -> Option<usize> {
        let numbers = &self.description.lower_bodies.as_ref().expect("accepted");
        let lower = numbers.value[place].as_ref().expect("accepted").value;
        usize::try_from(lower).expect("accepted").checked_sub(1)
    }

    fn joint(&self, place: usize) -> &Joint {
        &self.description.bodies[place].joint
    }

    fn kind(&self, place: usize) -> &JointKind {
        &self.joint(place).kind.as_ref().expect("accepted").value
    }

    /// The place in the description of the joint with this name.
    fn named(&self, name: &str) -> usize {
        let is_named = |body: &Body| {
            let own = body.joint.name.as_ref().or(body.name.as_ref());
            own.is_some_and(|own| own.value == name)
        };
        let found = self.description.bodies.iter().position(is_named);
        found.expect("a leader is known")
    }

    /// The only coordinate of a joint, by the free one that it follows in the end.
    pub(crate) fn link(&self, place: usize) -> Link {
        let own = |multiplier, offset, places| Link {
            places,
            multiplier,
            offset,
        };
        if let Some(mimic) = self
            .joint(place)
            .mimic
            .as_ref()
            .filter(|_| !self.is_held(place))
        {
            let mimic = &mimic.value;
            let leader = self.link(self.named(&mimic.joint.value));
            let offset = mimic.multiplier * leader.offset + mimic.offset;
            return own(mimic.multiplier * leader.multiplier, offset, leader.places);
        }
        match self.moving[place] {
            Some(body) => {
                let joint = &self.tree.body(body).joint;
                let places = [
                    joint.coordinates()[0].1.index(),
                    joint.speeds()[0].1.index(),
                ];
                own(1.0, 0.0, Some(places))
            }
            None => own(0.0, held(self.joint(place)), None),
        }
    }

    /// True for a joint without free coordinates as it is written.
    fn is_held(&self, place: usize) -> bool {
        match self.kind(place) {
            JointKind::Fixed => true,
            JointKind::List(axes) => axes.is_empty(),
            _ => false,
        }
    }

    pub(crate) fn follows(&self, place: usize) -> bool {
        self.joint(place).mimic.is_some() && !self.is_held(place)
    }

    /// The places of the bodies that follow others and move.
    pub(crate) fn followers(&self) -> impl Iterator<Item = (usize, BodyId)> + '_ {
        let moving = self.moving.iter().enumerate();
        moving.filter_map(|(place, body)| Some((place, (*body)?)).filter(|_| self.follows(place)))
    }

    /// Every body of the description.
    pub(crate) fn placed(&self, q: &[f64]) -> Vec<Placed> {
        let mut placed = vec![None; self.moving.len()];
        (0..placed.len())
            .map(|place| self.place(q, place, &mut placed))
            .collect()
    }

    fn place(&self, q: &[f64], place: usize, placed: &mut [Option<Placed>]) -> Placed {
        if let Some(known) = placed[place] {
            return known;
        }
        let below = self
            .lower(place)
            .map_or(INERTIAL, |lower| self.place(q, lower, placed));
        let joint = self.joint(place);
        let to_joint = rotation(joint.attachment_rotation.as_ref());
        let to_body = rotation(joint.body_rotation.as_ref());
        let (turned, shift) = self.motion(q, place);
        let step = product(&to_body, &product(&turned, &to_joint));
        let rotation = product(&step, &below.rotation);
        let out = sum(
            vector(&joint.attachment),
            times(&transposed(&to_joint), shift),
        );
        let back = joint.body_attachment.as_ref().map_or([0.0; 3], vector);
        let own = Placed {
            rotation,
            origin: sum(
                below.origin,
                sum(
                    times(&transposed(&below.rotation), out),
                    times(&transposed(&rotation), scaled(-1.0, back)),
                ),
            ),
        };
        placed[place] = Some(own);
        own
    }

    /// What a joint does: joint axes to the same, moved; and the translation, joint axes.
    fn motion(&self, q: &[f64], place: usize) -> (Rotation, Vector) {
        let joint = self.joint(place);
        if self.kind(place).has_axis() {
            return self.motion_along(q, place);
        }
        let mut values = [0.0; 6];
        for (axis, value) in &joint.locked {
            values[axis.value.index()] = value.as_ref().expect("accepted").value;
        }
        let mut parameters = Vec::new();
        if self.follows(place) {
            let JointKind::List(axes) = self.kind(place) else {
                unreachable!("all others have several coordinates")
            };
            values[axes[0].value.index()] = self.link(place).value(q);
        } else if let Some(body) = self.moving[place] {
            for (kind, coordinate) in self.tree.body(body).joint.coordinates() {
                let named = ["theta1", "theta2", "theta3", "s1", "s2", "s3"];
                match named.iter().position(|name| *name == kind) {
                    Some(motion) => values[motion] = q[coordinate.index()],
                    None => parameters.push(q[coordinate.index()]),
                }
            }
        }
        let [a, b, c, x, y, z] = values;
        let turned = match parameters[..] {
            [e0, e1, e2, e3] => of_quaternion([e0, e1, e2, e3]),
            _ => angles_123([a, b, c]),
        };
        (turned, [x, y, z])
    }

    /// As [`Self::motion`], of a joint with an axis of its own.
    fn motion_along(&self, q: &[f64], place: usize) -> (Rotation, Vector) {
        let axis = unit(self.joint(place).axis.as_ref().expect("accepted").value);
        let only = || self.link(place).value(q);
        let values = || -> Vec<f64> {
            let body = self.moving[place].expect("several coordinates follow none");
            let coordinates = self.tree.body(body).joint.coordinates();
            coordinates
                .iter()
                .map(|(_, place)| q[place.index()])
                .collect()
        };
        match self.kind(place) {
            JointKind::Revolute | JointKind::Continuous => (about(axis, only()), [0.0; 3]),
            JointKind::Prismatic => (IDENTITY, scaled(only(), axis)),
            JointKind::Cylindrical => {
                let values = values();
                (about(axis, values[0]), scaled(values[1], axis))
            }
            JointKind::Planar => {
                let values = values();
                let [first, second] = in_plane(axis);
                let shift = sum(scaled(values[1], first), scaled(values[2], second));
                (about(axis, values[0]), shift)
            }
            other => unreachable!("{other:?} has no axis"),
        }
    }

    /// By how much the tree's frame of a fixed body is off, in a state in which the bodies are `placed`.
    pub(crate) fn frame_error(&self, frame: &Frame, placed: &[Placed]) -> f64 {
        let bodies = &self.description.bodies;
        let is_named = |body: &Body| {
            body.name
                .as_ref()
                .is_some_and(|name| name.value == frame.name)
        };
        let own = placed[bodies.iter().position(is_named).expect("a frame is a body")];
        let host = frame.body.map_or(INERTIAL, |body| {
            placed[self.tree.body(body).user_number - 1]
        });
        let rotation = product(&own.rotation, &transposed(&host.rotation));
        let apart = sum(own.origin, scaled(-1.0, host.origin));
        let position = times(&host.rotation, apart);
        let scale = largest(&own.origin).max(largest(&host.origin));
        relative(frame.rotation.as_flattened(), rotation.as_flattened()).max(relative_to(
            scale,
            &frame.position,
            &position,
        ))
    }

    /// The bodies of the tree with all that is fixed to them.
    pub(crate) fn solids(&self) -> Vec<Solid> {
        // Where the coordinates are does not matter between frames that are fixed to one another.
        let placed = self.placed(&vec![0.5; self.tree.n_coordinates]);
        let mut parts: Vec<Vec<usize>> = vec![Vec::new(); self.tree.bodies.len()];
        for place in 0..placed.len() {
            let mut host = Some(place);
            while let Some(fixed) = host.filter(|host| self.moving[*host].is_none()) {
                host = self.lower(fixed);
            }
            if let Some(body) = host.and_then(|host| self.moving[host]) {
                parts[body.index()].push(place);
            }
        }
        self.tree
            .body_ids()
            .map(|body| {
                let own = placed[self.tree.body(body).user_number - 1];
                self.solid(&own, &parts[body.index()], &placed)
            })
            .collect()
    }

    fn solid(&self, own: &Placed, parts: &[usize], placed: &[Placed]) -> Solid {
        let mut solid = Solid {
            mass: 0.0,
            center: [0.0; 3],
            inertia: [[0.0; 3]; 3],
        };
        let of_part = |&place: &usize| {
            let body = &self.description.bodies[place];
            let turn = product(&own.rotation, &transposed(&placed[place].rotation));
            let apart = sum(placed[place].origin, scaled(-1.0, own.origin));
            let center = sum(
                times(&own.rotation, apart),
                times(&turn, vector(&body.mass_center)),
            );
            (nominal(body.mass.as_ref()), center, turn)
        };
        for (mass, center, _) in parts.iter().map(of_part) {
            solid.mass += mass;
            solid.center = sum(solid.center, scaled(mass, center));
        }
        solid.center = if solid.mass > 0.0 {
            scaled(1.0 / solid.mass, solid.center)
        } else {
            // What weighs nothing is as if alone.
            vector(&self.description.bodies[parts[0]].mass_center)
        };
        for place in parts {
            let (mass, center, turn) = of_part(place);
            let body = &self.description.bodies[*place];
            let [xx, yy, zz, xy, xz, yz] =
                body.inertia.each_ref().map(|part| nominal(part.as_ref()));
            let tensor = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
            // From the axes of the tensor to the body's.
            let turn = product(
                &turn,
                &transposed(&rotation(body.inertia_rotation.as_ref())),
            );
            let turned = product(&product(&turn, &tensor), &transposed(&turn));
            let d = sum(center, scaled(-1.0, solid.center));
            for i in 0..3 {
                for j in 0..3 {
                    let around = if i == j { dot(d, d) } else { 0.0 };
                    solid.inertia[i][j] += turned[i][j] + mass * (around - d[i] * d[j]);
                }
            }
        }
        solid
    }

    /// What acts in the joints.
    pub(crate) fn acting(&self) -> Vec<Acting> {
        let mut all = Vec::new();
        for (place, body) in self.moving.iter().enumerate() {
            let Some(body) = *body else { continue };
            let (own, joint) = (self.joint(place), &self.tree.body(body).joint);
            let quantities = [&own.stiffness, &own.rest, &own.damping, &own.armature];
            let mut add = |motion: usize, coordinate: Option<Link>, speed: usize, factor: f64| {
                let [stiffness, rest, damping, armature] =
                    quantities.map(|quantity| at(quantity, motion));
                all.push(Acting {
                    coordinate,
                    speed,
                    factor,
                    stiffness,
                    rest,
                    damping,
                    armature,
                });
            };
            if self.follows(place) {
                let link = self.link(place);
                let [_, speed] = link.places.expect("what moves follows what moves");
                let motion = match self.kind(place) {
                    JointKind::List(axes) => axes[0].value.index(),
                    _ => 0,
                };
                add(motion, Some(link), speed, link.multiplier);
                continue;
            }
            let is_rate =
                |motion: usize| motion > 2 || matches!(joint.orientation, Orientation::Rates(_));
            let mut coordinates = joint.coordinates();
            let n_rates = joint
                .speeds()
                .iter()
                .filter(|(motion, _)| is_rate(*motion))
                .count();
            let mut coordinates = coordinates
                .split_off(coordinates.len() - n_rates)
                .into_iter();
            for (motion, speed) in joint.speeds() {
                let coordinate = is_rate(motion).then(|| {
                    let (_, coordinate) = coordinates.next().expect("a rate has a coordinate");
                    Link {
                        places: Some([coordinate.index(), speed.index()]),
                        multiplier: 1.0,
                        offset: 0.0,
                    }
                });
                add(motion, coordinate, speed.index(), 1.0);
            }
        }
        all
    }

    /// The tree, with the numbering of all arrays, and the nominal values of its parameters.
    pub(crate) fn tree(&self) -> &Tree {
        &self.tree
    }
}

impl Link {
    pub(crate) fn value(&self, q: &[f64]) -> f64 {
        self.offset
            + self
                .places
                .map_or(0.0, |[place, _]| self.multiplier * q[place])
    }
}

impl Acting {
    fn stretch(&self, q: &[f64]) -> f64 {
        self.coordinate
            .map_or(0.0, |link| link.value(q) - self.rest)
    }

    /// Energies of rotor and spring.
    pub(crate) fn energies(&self, state: &State) -> [f64; 2] {
        let (rate, stretch) = (self.factor * state.u[self.speed], self.stretch(&state.q));
        [
            0.5 * self.armature * rate * rate,
            0.5 * self.stiffness * stretch * stretch,
        ]
    }

    /// The speed, and the generalized forces there that rotor, damper and spring need.
    pub(crate) fn needed(&self, state: &State) -> (usize, [f64; 3]) {
        let rate = self.factor * state.u[self.speed];
        let second = self.factor * state.u_dot[self.speed];
        let needed = [
            self.armature * second,
            self.damping * rate,
            self.stiffness * self.stretch(&state.q),
        ];
        (self.speed, needed.map(|force| self.factor * force))
    }

    pub(crate) fn has_rotor(&self) -> bool {
        self.armature != 0.0
    }

    pub(crate) fn speed(&self) -> usize {
        self.speed
    }
}

/// The rates of all coordinates.
pub(crate) fn q_dot(tree: &Tree, q: &[f64], u: &[f64]) -> Vec<f64> {
    let mut rates = vec![0.0; q.len()];
    for body in &tree.bodies {
        let joint = &body.joint;
        let mut coordinates: Vec<usize> = joint
            .coordinates()
            .iter()
            .map(|(_, at)| at.index())
            .collect();
        let mut speeds: Vec<usize> = joint.speeds().iter().map(|(_, at)| at.index()).collect();
        if let Orientation::AngularVelocity {
            chart,
            speeds: turns,
        } = joint.orientation
        {
            let w = turns.map(|turn| u[turn.index()]);
            speeds.drain(..3);
            match chart {
                Chart::EulerParameters(places) => {
                    let e = places.map(|place| q[place.index()]);
                    let e_dot = hamilton(e, [0.0, w[0], w[1], w[2]]);
                    for (place, rate) in places.into_iter().zip(e_dot) {
                        rates[place.index()] = 0.5 * rate;
                    }
                    coordinates.drain(..4);
                }
                Chart::Angles(places) => {
                    let columns = rate_columns(places.map(|place| q[place.index()]));
                    for (place, rate) in places.into_iter().zip(solved(&columns, w)) {
                        rates[place.index()] = rate;
                    }
                    coordinates.drain(..3);
                }
            }
        }
        for (coordinate, speed) in coordinates.into_iter().zip(speeds) {
            rates[coordinate] = u[speed];
        }
    }
    rates
}

/// `x` with `x_1 a + x_2 b + x_3 c = v`: Cramer's rule.
fn solved(&[a, b, c]: &[Vector; 3], v: Vector) -> Vector {
    let volume = |a, b, c| dot(a, cross(b, c));
    let whole = volume(a, b, c);
    [volume(v, b, c), volume(a, v, c), volume(a, b, v)].map(|part| part / whole)
}

/// The two directions of a planar joint: from the axis in cyclic order where it is a coordinate axis or the opposite of
/// one, the frame then turned by half a turn about the next; otherwise first the one normal to the coordinate axis along
/// which the axis has least.
fn in_plane(axis: Vector) -> [Vector; 2] {
    if let Some(place) = (0..3).find(|&i| axis[i].abs() == 1.0) {
        let (next, last) = ((place + 1) % 3, (place + 2) % 3);
        let mut directions = [IDENTITY[next], scaled(axis[place], IDENTITY[last])];
        // Coordinates go by the numbers of their axes.
        if next > last {
            directions.reverse();
        }
        return directions;
    }
    let magnitudes = axis.map(f64::abs);
    let least = (0..3).fold(0, |least, i| {
        if magnitudes[i] < magnitudes[least] {
            i
        } else {
            least
        }
    });
    let first = unit(cross(IDENTITY[least], axis));
    [first, cross(axis, first)]
}

/// The one value that a joint without free coordinates is held at.
fn held(joint: &Joint) -> f64 {
    let values = joint.locked.iter();
    let mut values: Vec<_> = values
        .map(|(axis, value)| (axis.value, value.as_ref().expect("accepted").value))
        .collect();
    values.sort_by_key(|(axis, _)| *axis);
    let off_zero = values.into_iter().find(|(_, value)| *value != 0.0);
    off_zero.map_or(0.0, |(_, value)| value)
}

fn at(quantity: &PerCoordinate<Scalar>, motion: usize) -> f64 {
    match quantity {
        PerCoordinate::Absent => 0.0,
        PerCoordinate::Same(value) => value.value.nominal(),
        PerCoordinate::Each(values) => values
            .iter()
            .find(|(axis, _)| axis.value.index() == motion)
            .map_or(0.0, |(_, value)| value.value.nominal()),
    }
}

fn rotation(given: Option<&Spanned<Rotation>>) -> Rotation {
    given.map_or(IDENTITY, |rotation| rotation.value)
}

fn nominal(given: Option<&Spanned<Scalar>>) -> f64 {
    given.expect("accepted").value.nominal()
}

fn vector(given: &[Option<Spanned<Scalar>>; 3]) -> Vector {
    given.each_ref().map(|part| nominal(part.as_ref()))
}
