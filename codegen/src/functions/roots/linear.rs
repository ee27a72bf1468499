//! The root expressions of each function of a frame's origin alone: those that belong to it of what the frame has.

use super::frames;
use crate::{
    expr::{Expr, ExprGraph},
    functions::{formulation::Way, subject::Subject},
    given::frame_force,
    tree::Tree,
};

pub(in crate::functions) fn position(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
    subject: &Subject,
) -> Vec<Expr> {
    // It stands after the rotation.
    frames::pose(graph, tree, way, subject).split_off(9)
}

pub(in crate::functions) fn velocity(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
    subject: &Subject,
) -> Vec<Expr> {
    linear(frames::velocity(graph, tree, way, subject))
}

pub(in crate::functions) fn acceleration(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
    subject: &Subject,
) -> Vec<Expr> {
    linear(frames::acceleration(graph, tree, way, subject))
}

pub(in crate::functions) fn jacobian(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
    subject: &Subject,
) -> Vec<Expr> {
    linear(frames::jacobian(graph, tree, way, subject))
}

pub(in crate::functions) fn jacobian_packed(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
    subject: &Subject,
) -> Vec<Expr> {
    linear(frames::jacobian_packed(graph, tree, way, subject))
}

pub(in crate::functions) fn jacobian_dot_u(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
    subject: &Subject,
) -> Vec<Expr> {
    linear(frames::jacobian_dot_u(graph, tree, way, subject))
}

pub(in crate::functions) fn generalized_force(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
    subject: &Subject,
) -> Vec<Expr> {
    let force = frame_force(graph);
    frames::of_wrench(graph, tree, way, subject, force)
}

pub(in crate::functions) fn operational_inverse_inertia(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
    subject: &Subject,
) -> Vec<Expr> {
    frames::projected(graph, tree, way, subject, 3)
}

/// What stands before the angular half.
fn linear(mut entries: Vec<Expr>) -> Vec<Expr> {
    entries.truncate(entries.len() / 2);
    entries
}
