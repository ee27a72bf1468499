//! The root expressions of the functions that are given loads beside motion or forces.

use super::{
    dynamics::{accelerated, needed},
    user_axes,
};
use crate::{
    expr::{Expr, ExprGraph},
    functions::formulation::Way,
    given::{Accelerations, Loads},
    id::BodyMap,
    kane::joint_wrench as notes,
    recursive::forces::joint_wrench as recursive,
    tree::Tree,
};

pub(in crate::functions) fn loaded_inverse_dynamics(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
) -> Vec<Expr> {
    needed(graph, tree, way, Accelerations::Given, Loads::Given)
}

pub(in crate::functions) fn loaded_forward_dynamics(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
) -> Vec<Expr> {
    accelerated(graph, tree, way, Loads::Given)
}

/// The forces of all bodies, then the moments.
pub(in crate::functions) fn joint_wrenches(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
) -> Vec<Expr> {
    let parts = match way {
        Way::Notes => {
            let wrenches = notes::joint_wrenches(graph, tree);
            let forces = BodyMap::outward(tree.bodies.len(), |body, _| wrenches[body].force);
            let moments = BodyMap::outward(tree.bodies.len(), |body, _| wrenches[body].moment);
            [forces, moments]
        }
        Way::Recursive(plan) => {
            let wrenches = recursive::joint_wrenches(graph, tree, plan);
            [0, 1].map(|part| BodyMap::outward(tree.bodies.len(), |body, _| wrenches[body][part]))
        }
    };
    let parts = parts.map(|vectors| user_axes::vectors(graph, tree, &vectors));
    let parts = parts.into_iter().flat_map(BodyMap::into_values);
    parts.flatten().collect()
}
