//! A column of the Coriolis matrix on its way inward: what the masses that a speed moves need.

use super::velocities::Velocity;
use crate::{
    expr::{Axis, ExprGraph, Vector},
    id::BodyId,
    recursive::{
        links::{rotation::Turn, wrench::Wrench},
        matrices::{
            lever::Levered,
            moments::{Moments, Rates},
            shortcut::{Next, Sent, Shortcut},
        },
    },
    tree::{Motion, Tree},
};

/// What a speed's unit value makes of the masses that it moves, about the origin and along the axes that have been reached.
#[derive(Clone, Copy, Debug)]
pub(in crate::recursive) struct CoriolisColumn {
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

impl CoriolisColumn {
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

    /// That of a turn about an axis; velocities and rates are of one side of the rotation.
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
        self.turn_in(graph, Some(self.body), rotation);
    }

    /// The same in another scope.
    pub(in crate::recursive) fn turn_in(
        &mut self,
        graph: &mut ExprGraph,
        scope: Option<BodyId>,
        rotation: &dyn Turn,
    ) {
        graph.enter(scope);
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
impl Sent for CoriolisColumn {
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
