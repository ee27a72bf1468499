//! The root expressions of the functions that are given loads beside motion or forces.

use super::{
    dynamics::{accelerated, accelerated_recursive, with_forces},
    user_axes,
};
use crate::{
    expr::{Expr, ExprGraph, Vector},
    given::{Accelerations, Loads},
    id::BodyMap,
    kane::{self, dynamics},
    recursive::{self, Plan, forces::inverse_dynamics},
    tree::Tree,
};

pub(in crate::functions) fn loaded_inverse_dynamics(
    graph: &mut ExprGraph,
    tree: &Tree,
) -> Vec<Expr> {
    let tau = dynamics::loaded_inverse_dynamics(graph, tree, Accelerations::Given);
    with_forces(graph, tree, None, Accelerations::Given, tau)
}

pub(in crate::functions) fn loaded_inverse_dynamics_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Vec<Expr> {
    let given = Accelerations::Given;
    let tau = inverse_dynamics::loaded_inverse_dynamics(graph, tree, plan, given);
    with_forces(graph, tree, Some(plan), Accelerations::Given, tau)
}

pub(in crate::functions) fn loaded_forward_dynamics(
    graph: &mut ExprGraph,
    tree: &Tree,
) -> Vec<Expr> {
    let needed = dynamics::loaded_inverse_dynamics(graph, tree, Accelerations::Zero);
    let needed = with_forces(graph, tree, None, Accelerations::Zero, needed);
    accelerated(graph, tree, &needed)
}

pub(in crate::functions) fn loaded_forward_dynamics_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Vec<Expr> {
    accelerated_recursive(graph, tree, plan, Loads::Given)
}

pub(in crate::functions) fn joint_wrenches(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let wrenches = kane::joint_wrench::joint_wrenches(graph, tree);
    let forces = BodyMap::outward(tree.bodies.len(), |body, _| wrenches[body].force);
    let moments = BodyMap::outward(tree.bodies.len(), |body, _| wrenches[body].moment);
    in_user_axes(graph, tree, [forces, moments])
}

pub(in crate::functions) fn joint_wrenches_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Vec<Expr> {
    let wrenches = recursive::forces::joint_wrench::joint_wrenches(graph, tree, plan);
    let parts =
        [0, 1].map(|part| BodyMap::outward(tree.bodies.len(), |body, _| wrenches[body][part]));
    in_user_axes(graph, tree, parts)
}

/// Vectors of all bodies, one list after the other.
fn in_user_axes(graph: &mut ExprGraph, tree: &Tree, parts: [BodyMap<Vector>; 2]) -> Vec<Expr> {
    let parts = parts.map(|vectors| user_axes::vectors(graph, tree, &vectors));
    let parts = parts.into_iter().flat_map(BodyMap::into_values);
    parts.flatten().collect()
}
