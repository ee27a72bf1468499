//! The root expressions of the functions of the mass centre of all bodies.

use crate::{
    expr::{Expr, ExprGraph, Vector},
    functions::formulation::Way,
    kane::center::{self as notes, Momentum},
    recursive::totals::{center as recursive, momentum_matrix},
    tree::Tree,
};

fn matrix(columns: &[Vector]) -> Vec<Expr> {
    let row = |axis: usize| columns.iter().map(move |column| column[axis]);
    (0..3).flat_map(row).collect()
}

pub(in crate::functions) fn center_of_mass(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
) -> Vec<Expr> {
    let position = match way {
        Way::Notes => notes::position(graph, tree),
        Way::Recursive(plan) => recursive::position(graph, tree, plan),
    };
    position.to_vec()
}

pub(in crate::functions) fn center_of_mass_velocity(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
) -> Vec<Expr> {
    let velocity = match way {
        Way::Notes => notes::velocity(graph, tree),
        Way::Recursive(plan) => recursive::velocity(graph, tree, plan),
    };
    velocity.to_vec()
}

pub(in crate::functions) fn center_of_mass_jacobian(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
) -> Vec<Expr> {
    matrix(&match way {
        Way::Notes => notes::jacobian(graph, tree),
        Way::Recursive(plan) => momentum_matrix::center_jacobian(graph, tree, plan),
    })
}

pub(in crate::functions) fn center_of_mass_jacobian_dot_u(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
) -> Vec<Expr> {
    let acceleration = match way {
        Way::Notes => notes::jacobian_dot_u(graph, tree),
        Way::Recursive(plan) => recursive::jacobian_dot_u(graph, tree, plan),
    };
    acceleration.to_vec()
}

pub(in crate::functions) fn centroidal_momentum_matrix(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
) -> Vec<Expr> {
    let columns = match way {
        Way::Notes => notes::momentum_matrix(graph, tree),
        Way::Recursive(plan) => momentum_matrix::momentum_matrix(graph, tree, plan),
    };
    notes::rows(&columns).concat()
}

pub(in crate::functions) fn centroidal_momentum_matrix_dot_u(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
) -> Vec<Expr> {
    let Momentum { linear, angular } = match way {
        Way::Notes => notes::momentum_matrix_dot_u(graph, tree),
        Way::Recursive(plan) => recursive::momentum_matrix_dot_u(graph, tree, plan),
    };
    [linear, angular].concat()
}
