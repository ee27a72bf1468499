//! What a description comes to in a state, put together from its own frames, masses and joints in plain numbers.
//!
//! In: the description as read, and from the generator's tree no more than which coordinate and speed stand where. Out:
//! where every frame is, what every body weighs with all that is fixed to it, and what acts in its joints. None of the
//! generator's own axes, origins, merging or tracing of what follows what is used.

use kane_codegen::{
    description::{Description, JointKind, Scalar, WrittenBody, WrittenJoint, toml},
    diagnostic::{Source, Spanned},
    id::BodyId,
    tree::{CoordinateKind, Frame, Tree},
};

use crate::{
    compare::{larger, largest, relative, relative_to},
    rotation::{
        IDENTITY, Rotation, Vector, about, angles_123, cross, of_quaternion, product, scaled, sum,
        times, transposed, unit,
    },
};

/// A description, and where its coordinates and speeds stand.
#[derive(Clone, Debug)]
pub struct Composition {
    pub(super) description: Description,
    /// For each body of the description the one of the tree that moves with its joint, if that moves.
    pub(super) moving: Vec<Option<BodyId>>,
    pub(super) tree: Tree,
}

/// A body of the description in a state.
#[derive(Clone, Copy, Debug)]
pub struct Placed {
    /// Inertial components to the body's.
    pub rotation: Rotation,
    /// From the inertial origin to the body's, inertial components.
    pub origin: Vector,
}

const INERTIAL: Placed = Placed {
    rotation: IDENTITY,
    origin: [0.0; 3],
};

/// A coordinate by another: `multiplier` times that one plus `offset`.
#[derive(Clone, Copy, Debug)]
pub struct Link {
    /// The places in `q` and `u`; none for a constant, which is `offset`.
    pub places: Option<[usize; 2]>,
    pub multiplier: f64,
    pub offset: f64,
}

impl Composition {
    pub fn new(text: &str, tree: &Tree) -> Self {
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

    pub(super) fn lower(&self, place: usize) -> Option<usize> {
        let numbers = &self.description.lower_bodies.as_ref().expect("accepted");
        let lower = numbers.value[place].as_ref().expect("accepted").value;
        usize::try_from(lower).expect("accepted").checked_sub(1)
    }

    pub(super) fn joint(&self, place: usize) -> &WrittenJoint {
        &self.description.bodies[place].joint
    }

    pub(super) fn kind(&self, place: usize) -> &JointKind {
        &self.joint(place).kind.as_ref().expect("accepted").value
    }

    /// The place in the description of the joint with this name.
    fn named(&self, name: &str) -> usize {
        let is_named = |body: &WrittenBody| {
            let own = body.joint.name.as_ref().or(body.name.as_ref());
            own.is_some_and(|own| own.value == name)
        };
        let found = self.description.bodies.iter().position(is_named);
        found.expect("a leader is known")
    }

    /// The only coordinate of a joint, by the free one that it follows in the end.
    pub fn link(&self, place: usize) -> Link {
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
        self.kind(place).is_fixed()
    }

    pub fn follows(&self, place: usize) -> bool {
        self.joint(place).mimic.is_some() && !self.is_held(place)
    }

    /// The places of the bodies that follow others and move.
    pub fn followers(&self) -> impl Iterator<Item = (usize, BodyId)> + '_ {
        let moving = self.moving.iter().enumerate();
        moving.filter_map(|(place, body)| Some((place, (*body)?)).filter(|_| self.follows(place)))
    }

    /// Where a body's joint sits, from its origin, along its axes.
    pub fn joint_point(&self, place: usize) -> Vector {
        let attachment = self.joint(place).body_attachment.as_ref();
        attachment.map_or([0.0; 3], vector)
    }

    /// Every body of the description.
    pub fn placed(&self, q: &[f64]) -> Vec<Placed> {
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
                let value = q[coordinate.index()];
                match kind {
                    CoordinateKind::Angle(i) => values[i] = value,
                    CoordinateKind::EulerParameter(_) => parameters.push(value),
                    CoordinateKind::Translation(i) => values[3 + i] = value,
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
    pub fn frame_error(&self, frame: &Frame, placed: &[Placed]) -> f64 {
        let bodies = &self.description.bodies;
        let is_named = |body: &WrittenBody| {
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
        let scale = larger(largest(&own.origin), largest(&host.origin));
        larger(
            relative(frame.rotation.as_flattened(), rotation.as_flattened()),
            relative_to(scale, &frame.position, &position),
        )
    }

    /// The tree, with the numbering of all arrays, and the nominal values of its parameters.
    pub fn tree(&self) -> &Tree {
        &self.tree
    }
}

impl Link {
    pub fn value(&self, q: &[f64]) -> f64 {
        self.offset
            + self
                .places
                .map_or(0.0, |[place, _]| self.multiplier * q[place])
    }
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
fn held(joint: &WrittenJoint) -> f64 {
    let values = joint.locked.iter();
    let mut values: Vec<_> = values
        .map(|(axis, value)| (axis.value, value.as_ref().expect("accepted").value))
        .collect();
    values.sort_by_key(|(axis, _)| *axis);
    let off_zero = values.into_iter().find(|(_, value)| *value != 0.0);
    off_zero.map_or(0.0, |(_, value)| value)
}

pub(super) fn rotation(given: Option<&Spanned<Rotation>>) -> Rotation {
    given.map_or(IDENTITY, |rotation| rotation.value)
}

pub(super) fn nominal(given: Option<&Spanned<Scalar>>) -> f64 {
    given.expect("accepted").value.nominal()
}

pub(super) fn vector(given: &[Option<Spanned<Scalar>>; 3]) -> Vector {
    given.each_ref().map(|part| nominal(part.as_ref()))
}
