//! The root expressions of the functions of the mass centre of all bodies.

use crate::{
    expr::{Expr, ExprGraph, Vector},
    kane::{
        self,
        center::{self, Momentum},
    },
    recursive::{self, Plan},
    tree::Tree,
};

fn matrices(columns: &[Momentum]) -> Vec<Expr> {
    center::rows(columns).concat()
}

fn matrix(columns: &[Vector]) -> Vec<Expr> {
    let row = |axis: usize| columns.iter().map(move |column| column[axis]);
    (0..3).flat_map(row).collect()
}

fn vectors(Momentum { linear, angular }: Momentum) -> Vec<Expr> {
    [linear, angular].concat()
}

pub(in crate::functions) fn center_of_mass(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    kane::center::position(graph, tree).to_vec()
}

pub(in crate::functions) fn center_of_mass_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Vec<Expr> {
    recursive::totals::center::position(graph, tree, plan).to_vec()
}

pub(in crate::functions) fn center_of_mass_velocity(
    graph: &mut ExprGraph,
    tree: &Tree,
) -> Vec<Expr> {
    kane::center::velocity(graph, tree).to_vec()
}

pub(in crate::functions) fn center_of_mass_velocity_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Vec<Expr> {
    recursive::totals::center::velocity(graph, tree, plan).to_vec()
}

pub(in crate::functions) fn center_of_mass_jacobian(
    graph: &mut ExprGraph,
    tree: &Tree,
) -> Vec<Expr> {
    matrix(&kane::center::jacobian(graph, tree))
}

pub(in crate::functions) fn center_of_mass_jacobian_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Vec<Expr> {
    matrix(&recursive::totals::momentum_matrix::center_jacobian(
        graph, tree, plan,
    ))
}

pub(in crate::functions) fn center_of_mass_jacobian_dot_u(
    graph: &mut ExprGraph,
    tree: &Tree,
) -> Vec<Expr> {
    kane::center::jacobian_dot_u(graph, tree).to_vec()
}

pub(in crate::functions) fn center_of_mass_jacobian_dot_u_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Vec<Expr> {
    recursive::totals::center::jacobian_dot_u(graph, tree, plan).to_vec()
}

pub(in crate::functions) fn centroidal_momentum_matrix(
    graph: &mut ExprGraph,
    tree: &Tree,
) -> Vec<Expr> {
    matrices(&kane::center::momentum_matrix(graph, tree))
}

pub(in crate::functions) fn centroidal_momentum_matrix_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Vec<Expr> {
    matrices(&recursive::totals::momentum_matrix::momentum_matrix(
        graph, tree, plan,
    ))
}

pub(in crate::functions) fn centroidal_momentum_matrix_dot_u(
    graph: &mut ExprGraph,
    tree: &Tree,
) -> Vec<Expr> {
    vectors(kane::center::momentum_matrix_dot_u(graph, tree))
}

pub(in crate::functions) fn centroidal_momentum_matrix_dot_u_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Vec<Expr> {
    vectors(recursive::totals::center::momentum_matrix_dot_u(
        graph, tree, plan,
    ))
}
