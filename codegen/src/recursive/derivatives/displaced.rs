//! What masses at `r` need where their accelerations change by `D × r + 2 u × (w × r)`: a turn displaces them, and their relative
//! motions turn with them.

use crate::{
    expr::{ExprGraph, Vector},
    recursive::{links::link_motion::LinkMotion, matrices::moments::Moments},
};

/// With more off-diagonal second moments than this, the moment `sum m r × Q r` needs more operations than the terms one by one.
const MOST_MIXED: usize = 1;

/// Moment and force, where the angular velocity before the turn is another one than after it.
pub(super) fn by_turn(
    graph: &mut ExprGraph,
    moments: &Moments,
    d: Vector,
    [w, u]: [Vector; 2],
) -> [Vector; 2] {
    let w = graph.doubled(w);
    let moving = graph.cross(w, moments.first);
    let (moved, passing) = (graph.cross(d, moments.first), graph.cross(u, moving));
    let spread = graph.mul_symmetric(&moments.second, u);
    let swept = graph.cross(w, spread);
    let spun = moments.spinning(graph, d);
    [
        graph.sub_vectors(spun, swept),
        graph.add_vectors(moved, passing),
    ]
}

/// The same by an angle, about whose axis both are alike: then it is `Q r`, with Q the change of the field of accelerations.
pub(super) fn by_angle(
    graph: &mut ExprGraph,
    moments: &Moments,
    axis: usize,
    motion: &LinkMotion,
) -> [Vector; 2] {
    let q = motion.turned_field(graph, axis);
    let force = graph.mul_vector(&q, moments.first);
    let mixed = moments.second.mixed.into_iter();
    let n_mixed = mixed.filter(|mixed| !graph.is_zero(*mixed)).count();
    if n_mixed <= MOST_MIXED {
        return [moments.moment_of_field(graph, &q, axis), force];
    }
    // What is spread of `2 w × e` is there for the couple.
    let (e, twice) = (graph.unit_vector(axis), graph.doubled(motion.w));
    let twice = graph.cross(twice, e);
    let spread = graph.mul_symmetric(&moments.second, twice);
    let swept = graph.cross(motion.w, spread);
    let spun = moments.spinning(graph, motion.u.map(|row| row[axis]));
    [graph.sub_vectors(spun, swept), force]
}
