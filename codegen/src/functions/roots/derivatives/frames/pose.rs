//! Derivatives of where frames are: what the frame's own motion turns.

use super::columns::by_rows;
use crate::{
    expr::{Expr, ExprGraph, Vector},
    functions::{
        argument::Argument, formulation::Way, function::ByArguments, roots::frames,
        subject::Subject,
    },
    recursive::Plan,
    tree::Tree,
};

/// The rotation's rows are the frame's axes, which turn with it; the position moves as its Jacobian says.
pub(in crate::functions) fn pose(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    subject: &Subject,
) -> ByArguments {
    let way = Way::Recursive(plan);
    let pose = frames::pose(graph, tree, way, subject);
    let motion = frames::jacobian(graph, tree, way, subject);
    let motion = by_rows(&motion, tree.n_speeds);
    let (linear, angular) = motion.split_at(3);
    let mut by_q = turned(graph, &pose[..9], angular);
    by_q.extend_from_slice(linear);
    ByArguments {
        by: vec![(Argument::Q, by_q)],
        values: Some(pose),
        mass: None,
    }
}

/// How the entries of a rotation change, row after row, with the columns of its frame's angular velocity.
fn turned(graph: &mut ExprGraph, rotation: &[Expr], angular: &[Vec<Expr>]) -> Vec<Vec<Expr>> {
    graph.enter(None);
    let mut rows = Vec::with_capacity(rotation.len());
    for axis in rotation.chunks(3) {
        let axis: Vector = std::array::from_fn(|i| axis[i]);
        let columns = 0..angular[0].len();
        let columns = columns.map(|column| {
            let w = std::array::from_fn(|i| angular[i][column]);
            graph.cross(w, axis)
        });
        let columns: Vec<Vector> = columns.collect();
        rows.extend((0..3).map(|i| columns.iter().map(|own| own[i]).collect::<Vec<Expr>>()));
    }
    rows
}
