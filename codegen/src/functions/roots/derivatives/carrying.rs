//! Which motions carry the axes of which others.

use crate::{
    expr::{Expr, ExprGraph},
    id::{BodyId, SpeedId},
    solve::SpeedMatrix,
    tree::Tree,
};

/// Of columns with so many rows, one a speed, how each changes by the motion of each: what is `changed` of the first of two speeds by the
/// second; nothing where that is empty.
pub(super) fn changes(
    graph: &mut ExprGraph,
    tree: &Tree,
    n_rows: usize,
    changed: impl Fn(&mut ExprGraph, &Carrying<'_>, [SpeedId; 2]) -> Vec<Expr>,
) -> SpeedMatrix {
    let carrying = Carrying::new(tree);
    let n = tree.n_speeds;
    let mut rows = vec![vec![graph.zero(); n]; n_rows * n];
    graph.enter(None);
    let speeds = || (0..n).map(SpeedId::new);
    let pairs = speeds().flat_map(|own| speeds().map(move |by| [own, by]));
    for [own, by] in pairs {
        let entries = changed(graph, &carrying, [own, by]);
        for (row, entry) in entries.into_iter().enumerate() {
            rows[row * n + own.index()][by.index()] = entry;
        }
    }
    rows
}

/// Of a tree in which each speed moves one joint.
pub(super) struct Carrying<'a> {
    tree: &'a Tree,
    /// Of each speed the body that it moves, and its motion's place among the six of the joint.
    places: Vec<(BodyId, usize)>,
}

impl<'a> Carrying<'a> {
    pub(super) fn new(tree: &'a Tree) -> Self {
        let mut places = vec![(BodyId::new(0), 0); tree.n_speeds];
        for body in tree.body_ids() {
            let motions = tree.body(body).joint.motions();
            for (place, motion) in motions.into_iter().enumerate() {
                if let Some(motion) = motion {
                    places[motion.speed.index()] = (body, place);
                }
            }
        }
        Self { tree, places }
    }

    /// True where the motion of one speed carries the axis of another's. Inside a joint translations carry all others, each angle the axes of
    /// those after it, an angular velocity its own three, and neither those of translations.
    pub(super) fn carries(&self, cause: SpeedId, speed: SpeedId) -> bool {
        let (below, own) = (self.places[cause.index()], self.places[speed.index()]);
        if below.0 != own.0 {
            let mut below_own = self.tree.path(own.0).skip(1);
            return below_own.any(|body| body == below.0);
        }
        let joint = &self.tree.body(own.0).joint;
        let is_before = joint.angular_velocity().is_some() || below.1 <= own.1;
        below.1 >= 3 || own.1 < 3 && is_before
    }

    /// Speeds that move bodies on one path, outward: a motion that carries others stands before them.
    pub(super) fn outward(&self, mut speeds: Vec<SpeedId>) -> Vec<SpeedId> {
        speeds.sort_by_key(|speed| {
            let (body, place) = self.places[speed.index()];
            (body, (place + 3) % 6)
        });
        speeds
    }
}
