//! The root expressions of the Coriolis matrix, and of the rate of the mass matrix.

use crate::{
    expr::{Expr, ExprGraph},
    functions::formulation::Way,
    kane::coriolis as notes,
    recursive::matrices as recursive,
    tree::Tree,
};

pub(in crate::functions) fn coriolis_matrix(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
) -> Vec<Expr> {
    let matrix = match way {
        Way::Notes => notes::coriolis_matrix(graph, tree),
        Way::Recursive(plan) => recursive::coriolis::coriolis_matrix(graph, tree, plan),
    };
    matrix.concat()
}

pub(in crate::functions) fn mass_matrix_dot(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
) -> Vec<Expr> {
    let matrix = match way {
        Way::Notes => notes::mass_matrix_dot(graph, tree),
        Way::Recursive(plan) => recursive::mass_matrix_dot::mass_matrix_dot(graph, tree, plan),
    };
    matrix.concat()
}
