//! Columns: what a motion makes of the masses that it moves.

use crate::{
    expr::{Axis, Expr, ExprGraph, Vector},
    id::BodyId,
    recursive::{
        links::{rotation::Turn, wrench::Wrench},
        matrices::{
            coriolis::column::CoriolisColumn,
            lever::Levered,
            shortcut::{Next, Sent, Shortcut},
        },
    },
    tree::Tree,
};

/// What the masses that a motion moves need and have, about the origin and along the axes that have been reached.
#[derive(Clone, Copy, Debug)]
pub(super) struct DerivativeColumn {
    /// For its speed: what is needed of a change of it, momentum and couple.
    pub(super) carrying: CoriolisColumn,
    /// What is needed of a change of its coordinate.
    pub(super) displaced: Levered,
}

impl DerivativeColumn {
    /// All of its numbers.
    pub(super) fn parts_mut(&mut self) -> impl Iterator<Item = &mut Expr> {
        let CoriolisColumn {
            needed,
            momentum,
            couple,
            ..
        } = &mut self.carrying;
        let levered = [needed, momentum, &mut self.displaced].into_iter();
        levered.flat_map(Levered::parts_mut).chain(couple)
    }

    /// Of another column's motion with the numbers of this one.
    pub(super) fn of_motion(&self, other: &Self) -> Self {
        Self {
            carrying: self.carrying.of_motion(&other.carrying),
            displaced: self.displaced,
        }
    }

    /// True for columns of which the same has left.
    pub(super) fn is_like(&self, other: &Self) -> bool {
        let has_left = |own: &Self| {
            [own.carrying.needed, own.carrying.momentum, own.displaced].map(|part| part.has_left())
        };
        has_left(self) == has_left(other)
    }

    /// What is needed by the speed and by the coordinate, about (0 to 2) or along (3 to 5) an axis.
    pub(super) fn needed(&self, place: usize) -> [Expr; 2] {
        [self.carrying.needed, self.displaced].map(|part| part.read(place))
    }

    /// To the link that comes next, from whose origin the last one lies at `offset`.
    pub(super) fn reach(&mut self, graph: &mut ExprGraph, offset: Vector, next: Next) {
        self.carrying.reach(graph, offset, next);
        self.displaced.reach(graph, offset, next);
    }

    /// Names by hints what has come to a link, of a change of the coordinate `n_by_q`, `f_by_q`.
    pub(super) fn hint(&self, graph: &mut ExprGraph, tree: &Tree, at: BodyId) {
        self.carrying.hint(graph, tree, at);
        let (name, at) = (self.carrying.name(tree), &tree.body(at).identifier);
        graph.hint(|graph| {
            let Wrench { moment, force } = self.displaced.wrench;
            graph.name_vector(moment, &format!("{name}_n_by_q_{at}"));
            graph.name_vector(force, &format!("{name}_f_by_q_{at}"));
        });
    }

    pub(super) fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn) {
        self.turn_in(graph, Some(self.carrying.body), rotation);
    }

    /// The same in another scope.
    pub(super) fn turn_in(
        &mut self,
        graph: &mut ExprGraph,
        scope: Option<BodyId>,
        rotation: &dyn Turn,
    ) {
        self.carrying.turn_in(graph, scope, rotation);
        self.displaced.turn(graph, rotation);
    }

    /// Gets ready for a turn about an axis.
    pub(super) fn before_turn(
        &mut self,
        graph: &mut ExprGraph,
        axis: Axis,
        shortcut: Option<Shortcut>,
    ) {
        self.carrying.before_turn(graph, axis, shortcut);
        self.displaced.before_turn(graph, axis, shortcut);
    }
}

/// Momentum stays: it is read off for rows on the way.
impl Sent for DerivativeColumn {
    const N_FORCES: usize = 2;

    fn stays(&self, _: &ExprGraph) -> bool {
        !self.displaced.has_left()
    }

    fn depart(&mut self, graph: &mut ExprGraph, shortcut: &Shortcut, axis: Axis) {
        graph.enter(self.carrying.body);
        self.carrying.needed.depart(graph, shortcut, axis);
        self.displaced.depart(graph, shortcut, axis);
    }
}
