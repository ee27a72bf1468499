//! Derivatives of functions of a frame's origin alone: those rows of the frame's that belong to it.

use super::{acceleration, columns, velocity};
use crate::{
    expr::ExprGraph,
    functions::{function::ByArguments, subject::Subject},
    recursive::Plan,
    tree::Tree,
};

pub(in crate::functions) fn jacobian(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    subject: &Subject,
) -> ByArguments {
    linear(columns::jacobian(graph, tree, plan, subject))
}

pub(in crate::functions) fn jacobian_packed(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    subject: &Subject,
) -> ByArguments {
    linear(columns::jacobian_packed(graph, tree, plan, subject))
}

pub(in crate::functions) fn velocity(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    subject: &Subject,
) -> ByArguments {
    linear(velocity::velocity(graph, tree, plan, subject))
}

pub(in crate::functions) fn acceleration(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    subject: &Subject,
) -> ByArguments {
    linear(acceleration::acceleration(graph, tree, plan, subject))
}

pub(in crate::functions) fn jacobian_dot_u(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    subject: &Subject,
) -> ByArguments {
    linear(acceleration::jacobian_dot_u(graph, tree, plan, subject))
}

/// Without the half that is angular.
fn linear(mut whole: ByArguments) -> ByArguments {
    for (_, rows) in &mut whole.by {
        rows.truncate(rows.len() / 2);
    }
    if let Some(values) = &mut whole.values {
        values.truncate(values.len() / 2);
    }
    whole
}
