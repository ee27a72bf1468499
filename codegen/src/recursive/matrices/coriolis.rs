//! The Coriolis matrix from composite bodies, as the mass matrix is made of them (Echeandia and Wensing 2021).
//!
//! Of all masses `C_ij = sum m J_i · J_dot_j`: J are the velocities for a unit speed. A column's masses need a force and moment
//! `(sum m J_dot_j, sum m r × J_dot_j)`, which every motion farther in reads off: row i, column j. The mirrored entry is read off
//! the column's momentum, for the axis of motion i turns, and off the couple `sum m r_dot × J_j`. All three pass inward.
//! With rates seen from the link, `B = tr(N) 1 - N`, second moments S, and `w` and `v` of the link, they begin for a turn
//! about `e` as `B e - e × S w` and `e × f + w × (e × h)`, and `B^T e + S (w × e) + v × (e × h)`.
//!
//! How fast a whole tree is translated does not matter: of `v` only what joints beyond the root add is there.

use super::{
    ahead::{About, Ahead},
    gathered::Gathered,
    lever::Levered,
    moments::{Changing, Moments, Rates},
    shortcut::{Next, Sent, Shortcut, Shortcuts},
    speed_matrix,
};
use crate::{
    expr::{Axis, ExprGraph, Purpose, Vector},
    id::{BodyId, BodyMap},
    recursive::{
        links::{
            linkage::Linkage,
            passage::{Drive, Passenger, speeds},
            rotation::Turn,
            wrench::Wrench,
        },
        plan::Plan,
    },
    solve::SpeedMatrix,
    tree::{Motion, Tree},
};

/// `C`, with `C u` the bias of a system without weight, springs and dampers, and `M_dot = C + C^T`.
pub fn coriolis_matrix(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> SpeedMatrix {
    let linkage = Linkage::of_speeds(graph, tree, plan);
    let velocities = velocities(graph, &linkage);
    graph.begin(Purpose::Composite);
    let mut gathered = Gathered::<Rates>::new(graph, &linkage);
    let mut columns = BodyMap::outward(tree.bodies.len(), |_, _| Vec::<Column>::new());
    let mut shortcuts = Shortcuts::new(graph, &linkage);
    let angular = BodyMap::outward(tree.bodies.len(), |body, _| velocities[body].velocity[0]);
    let mut ahead = Ahead::new(graph, &linkage, angular);
    let mut c = vec![vec![graph.zero(); tree.n_speeds]; tree.n_speeds];
    for body in tree.body_ids().rev() {
        graph.enter(body);
        let mut carried = Carried {
            body,
            moments: gathered.moments[body],
            rates: gathered.rates[body],
            velocities: &velocities[body].at_motions,
            columns: std::mem::take(&mut columns[body]),
            shortcuts: &mut shortcuts,
            ahead: &mut ahead,
            c: &mut c,
        };
        linkage.passages[body].inward(graph, &mut carried);
        let Carried {
            moments: arrived,
            rates: changing,
            columns: others,
            ..
        } = carried;
        if let Some(lower) = tree.lower(body) {
            let come = (&arrived, &changing);
            Gathered::hint(graph, come);
            for column in &others {
                column.hint(graph, tree, lower);
            }
            gathered.add(graph, lower, come);
            columns[lower].extend(others);
        }
    }
    c
}

/// Angular velocity, and velocity of the origin.
pub(in crate::recursive) type Velocity = [Vector; 2];

/// A link's velocity on its way outward through a joint.
#[derive(Clone, Debug)]
struct Moving {
    velocity: Velocity,
    is_root: bool,
    /// The same wherever motions enter, in the order of the way.
    at_motions: Vec<Velocity>,
}

fn velocities(graph: &mut ExprGraph, linkage: &Linkage<'_>) -> BodyMap<Moving> {
    graph.begin(Purpose::Outward);
    let tree = linkage.tree;
    BodyMap::outward(tree.bodies.len(), |body, moving: &BodyMap<Moving>| {
        graph.enter(body);
        let lower = tree.lower(body);
        let below = lower.map(|lower| moving[lower].velocity);
        let mut passing = Moving {
            velocity: below.unwrap_or([graph.zero_vector(); 2]),
            is_root: lower.is_none(),
            at_motions: Vec::new(),
        };
        linkage.passages[body].outward(graph, &mut passing);
        graph.name_vector(passing.velocity[0], "w");
        graph.name_vector(passing.velocity[1], "v_o");
        passing
    })
}

impl Passenger for Moving {
    fn shift(&mut self, graph: &mut ExprGraph, _: BodyId, offset: Vector) {
        let [w, v] = self.velocity;
        let swept = graph.cross(w, offset);
        self.velocity = [w, graph.add_vectors(v, swept)];
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive) {
        let [w, v] = self.velocity.map(|v| rotation.forward(graph, v));
        let own = drive.speeds(graph);
        self.velocity = [graph.add_vectors(w, own), v];
        self.at_motions.push(self.velocity);
    }

    fn along(&mut self, graph: &mut ExprGraph, motions: [Option<Motion>; 3]) {
        if !self.is_root {
            let own = speeds(graph, motions);
            self.velocity[1] = graph.add_vectors(self.velocity[1], own);
        }
        self.at_motions.push(self.velocity);
    }
}

/// What a speed's unit value makes of the masses that it moves, about the origin and along the axes that have been reached.
#[derive(Clone, Copy, Debug)]
pub(in crate::recursive) struct Column {
    /// The body that moves with the speed: the column's operations belong to it, wherever they are carried.
    pub(in crate::recursive) body: BodyId,
    pub(in crate::recursive) motion: Motion,
    /// Of the motion among the six of the joint.
    place: usize,
    /// What the change of J needs.
    pub(in crate::recursive) needed: Levered,
    pub(in crate::recursive) momentum: Levered,
    pub(in crate::recursive) couple: Vector,
}

/// What a composite body is made of, and how fast that changes.
#[derive(Clone, Copy, Debug)]
pub(in crate::recursive) struct Masses<'a> {
    pub(in crate::recursive) body: BodyId,
    pub(in crate::recursive) moments: &'a Moments,
    pub(in crate::recursive) rates: &'a Rates,
}

impl Column {
    /// That of a motion, by its place among the six, where what is needed, momentum and couple are known.
    pub(in crate::recursive) fn known(
        graph: &mut ExprGraph,
        body: BodyId,
        (motion, place): (Motion, usize),
        [needed, momentum]: [Wrench; 2],
        couple: Vector,
    ) -> Self {
        Self {
            body,
            motion,
            place,
            needed: Levered::new(graph, needed),
            momentum: Levered::new(graph, momentum),
            couple,
        }
    }

    /// That of a turn about an axis of a link that moves so.
    pub(in crate::recursive) fn of_turn(
        graph: &mut ExprGraph,
        Masses {
            body,
            moments,
            rates,
        }: Masses<'_>,
        motion: Motion,
        axis: usize,
        [w, v]: Velocity,
    ) -> Self {
        let unit = graph.unit_vector(axis);
        let momentum = graph.cross(unit, moments.first);
        let (seen, seen_back) = (rates.column(graph, axis), rates.row(graph, axis));
        let spread = graph.mul_symmetric(&moments.second, w);
        let turned = graph.cross(unit, spread);
        let axis_rate = graph.cross(w, unit);
        let swept = graph.mul_symmetric(&moments.second, axis_rate);
        let carried = graph.cross(v, momentum);
        let couple = graph.add_vectors(seen_back, swept);
        let (moving, turning) = (graph.cross(unit, rates.first), graph.cross(w, momentum));
        let own = Wrench {
            force: momentum,
            moment: moments.about(graph, axis),
        };
        let needed = Wrench {
            moment: graph.sub_vectors(seen, turned),
            force: graph.add_vectors(moving, turning),
        };
        let couple = graph.add_vectors(couple, carried);
        Self::known(graph, body, (motion, axis), [needed, own], couple)
    }

    /// That of a translation along an axis.
    pub(in crate::recursive) fn of_shift(
        graph: &mut ExprGraph,
        Masses {
            body,
            moments,
            rates,
        }: Masses<'_>,
        motion: Motion,
        axis: usize,
        [w, v]: Velocity,
    ) -> Self {
        let unit = graph.unit_vector(axis);
        let axis_rate = graph.cross(w, unit);
        let force = graph.scale(moments.mass, axis_rate);
        let (carried, turned) = (graph.scale(moments.mass, v), graph.cross(w, moments.first));
        let own = Wrench {
            force: graph.scale(moments.mass, unit),
            moment: graph.cross(moments.first, unit),
        };
        let needed = Wrench {
            moment: graph.cross(moments.first, axis_rate),
            force,
        };
        let whole = graph.add_vectors(rates.first, carried);
        let whole = graph.add_vectors(whole, turned);
        let couple = graph.cross(whole, unit);
        Self::known(graph, body, (motion, 3 + axis), [needed, own], couple)
    }

    /// Of another column's motion with the numbers of this one.
    pub(in crate::recursive) fn of_motion(&self, other: &Self) -> Self {
        let Self {
            needed,
            momentum,
            couple,
            ..
        } = *self;
        Self {
            needed,
            momentum,
            couple,
            ..*other
        }
    }

    /// The name of its motion.
    pub(in crate::recursive) fn name(&self, tree: &Tree) -> &'static str {
        tree.body(self.body).joint.motion_names()[self.place]
    }

    /// Names by hints what has come to a link: moment and force that are needed `n`, `f`, angular and linear momentum `l`, `p`, and
    /// the couple `c`.
    pub(in crate::recursive) fn hint(&self, graph: &mut ExprGraph, tree: &Tree, at: BodyId) {
        let (name, at) = (self.name(tree), &tree.body(at).identifier);
        graph.enter(self.body);
        graph.hint(|graph| {
            let Wrench { moment, force } = self.needed.wrench;
            let Wrench {
                moment: angular,
                force: linear,
            } = self.momentum.wrench;
            let vectors = [moment, force, angular, linear, self.couple];
            for (vector, letter) in vectors.into_iter().zip(["n", "f", "l", "p", "c"]) {
                graph.name_vector(vector, &format!("{name}_{letter}_{at}"));
            }
        });
    }

    pub(in crate::recursive) fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn) {
        graph.enter(self.body);
        self.needed.turn(graph, rotation);
        self.momentum.turn(graph, rotation);
        self.couple = rotation.backward(graph, self.couple);
    }

    /// To the link that comes next, from whose origin the last one lies at `offset`. Mirrored entries read all of momentum.
    pub(in crate::recursive) fn reach(
        &mut self,
        graph: &mut ExprGraph,
        offset: Vector,
        next: Next,
    ) {
        graph.enter(self.body);
        self.needed.reach(graph, offset, next);
        self.momentum.reach(graph, offset, Next::UNKNOWN);
    }

    /// Gets ready for a turn about an axis, where there is a shortcut for the force that is needed.
    pub(in crate::recursive) fn before_turn(
        &mut self,
        graph: &mut ExprGraph,
        axis: Axis,
        shortcut: Option<Shortcut>,
    ) {
        graph.enter(self.body);
        self.needed.before_turn(graph, axis, shortcut);
        self.momentum.before_turn(graph, axis, shortcut);
    }
}

/// The root's translations are along axes that do not turn, so that there is no mirrored entry to be read.
impl Sent for Column {
    const N_FORCES: usize = 2;

    fn stays(&self, _: &ExprGraph) -> bool {
        !self.needed.has_left()
    }

    fn depart(&mut self, graph: &mut ExprGraph, shortcut: &Shortcut, axis: Axis) {
        graph.enter(self.body);
        self.needed.depart(graph, shortcut, axis);
        self.momentum.depart(graph, shortcut, axis);
    }
}

/// A composite body and the columns of what it carries, on their way inward through a joint: where a speed moves the body, its
/// column begins, and row and column are read off all columns.
struct Carried<'a, 'b> {
    body: BodyId,
    moments: Moments,
    rates: Rates,
    /// The link's velocity wherever motions of the rest of the way enter.
    velocities: &'a [Velocity],
    columns: Vec<Column>,
    shortcuts: &'a mut Shortcuts<'b>,
    ahead: &'a mut Ahead<'b>,
    c: &'a mut SpeedMatrix,
}

impl Carried<'_, '_> {
    /// The velocity where the next motions enter.
    fn next(&mut self) -> Velocity {
        let (velocity, rest) = self
            .velocities
            .split_last()
            .expect("coriolis: the way inward is the way outward");
        self.velocities = rest;
        *velocity
    }

    fn masses(&self) -> Masses<'_> {
        Masses {
            body: self.body,
            moments: &self.moments,
            rates: &self.rates,
        }
    }

    /// Reads off what joints below make of columns of which moments alone are left, if that is cheaper than to carry them there.
    fn read_ahead(&mut self, graph: &mut ExprGraph, axis: Axis, shortcut: Option<Shortcut>) {
        if !self.ahead.may(self.body) {
            return;
        }
        let no_force = self.ahead.is_still(self.body);
        let is_left = |graph: &ExprGraph, own: &Column| {
            let is_left = |part: &Levered| part.has_left() || !part.has_force(graph);
            no_force || is_left(&own.needed) && is_left(&own.momentum)
        };
        let columns = std::mem::take(&mut self.columns);
        let (mut moments, others): (Vec<_>, Vec<_>) =
            columns.into_iter().partition(|own| is_left(graph, own));
        self.columns = others;
        let Some(axes) = self.ahead.from(graph, self.body, 3 * moments.len()) else {
            self.columns.extend(moments);
            return;
        };
        for column in &mut moments {
            graph.enter(column.body);
            column.needed.settle_past(graph, shortcut, axis);
            column.momentum.settle_past(graph, shortcut, axis);
            for &About {
                motion,
                axis,
                crossed: rate,
            } in &axes
            {
                let row = graph.dot(axis, column.needed.wrench.moment);
                speed_matrix::add(graph, self.c, [motion, column.motion], row);
                let turned = graph.dot(rate, column.momentum.wrench.moment);
                let couple = graph.dot(axis, column.couple);
                let mirrored = graph.add(turned, couple);
                speed_matrix::add(graph, self.c, [column.motion, motion], mirrored);
            }
        }
    }

    /// Row and column of the motion that began last, about (0 to 2) or along (3 to 5) an axis.
    fn read(&mut self, graph: &mut ExprGraph, motion: Motion, place: usize, [w, v]: Velocity) {
        let unit = graph.unit_vector(place % 3);
        let last = self.columns.len() - 1;
        for (i, column) in self.columns.iter().enumerate() {
            let row = column.needed.read(place);
            speed_matrix::add(graph, self.c, [motion, column.motion], row);
            if i == last {
                continue;
            }
            let axis_rate = graph.cross(w, unit);
            let Wrench { moment, force } = column.momentum.wrench;
            let momentum = if place < 3 { moment } else { force };
            let mut mirrored = graph.dot(axis_rate, momentum);
            if place < 3 {
                let origin_rate = graph.cross(v, unit);
                let lever = graph.dot(origin_rate, force);
                mirrored = graph.add(mirrored, lever);
                mirrored = graph.add(mirrored, column.couple[place]);
            }
            speed_matrix::add(graph, self.c, [column.motion, motion], mirrored);
        }
    }
}

impl Passenger for Carried<'_, '_> {
    fn shift(&mut self, graph: &mut ExprGraph, lower: BodyId, offset: Vector) {
        let next = self.shortcuts.next(graph, lower);
        for column in &mut self.columns {
            column.reach(graph, offset, next);
        }
        graph.enter(self.body);
        self.rates = self.rates.moved(graph, offset);
        self.moments = self.moments.moved(graph, offset);
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive) {
        let velocity = self.next();
        for (axis, motion) in drive.motions().into_iter().enumerate() {
            if let Some(motion) = motion {
                let column = Column::of_turn(graph, self.masses(), motion, axis, velocity);
                self.columns.push(column);
                self.read(graph, motion, axis, velocity);
            }
        }
        if let Drive::Angle(axis, _) = drive {
            let at = (self.body, axis);
            let shortcut = self.shortcuts.send(graph, at, self.columns.iter_mut());
            self.read_ahead(graph, axis, shortcut);
            for column in &mut self.columns {
                column.before_turn(graph, axis, shortcut);
            }
        }
        for column in &mut self.columns {
            column.turn(graph, rotation);
        }
        graph.enter(self.body);
        let w = drive.speeds(graph);
        self.rates = self
            .rates
            .undriven(graph, &mut self.moments, rotation, (drive, w));
    }

    fn along(&mut self, graph: &mut ExprGraph, motions: [Option<Motion>; 3]) {
        let velocity = self.next();
        for (axis, motion) in motions.into_iter().enumerate() {
            if let Some(motion) = motion {
                let column = Column::of_shift(graph, self.masses(), motion, axis, velocity);
                self.columns.push(column);
                self.read(graph, motion, 3 + axis, velocity);
            }
        }
        let own = speeds(graph, motions);
        self.rates = self.rates.carried(graph, &self.moments, own);
    }
}
