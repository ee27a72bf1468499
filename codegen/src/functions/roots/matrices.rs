//! The root expressions of functions of the mass matrix: its products, solutions, inverse and factors.

use super::dynamics::{applied, at, factors, factors_recursive};
use crate::{
    expr::{Expr, ExprGraph},
    given::mechanics,
    kane::dynamics,
    recursive::{Plan, accelerations::inverse_mass, forces::product},
    solve::{self, Carriers, Inversion, SpeedMatrix},
    tree::Tree,
};

/// All entries of a matrix over speeds that is known.
pub(in crate::functions) fn whole(
    _: &mut ExprGraph,
    _: &Tree,
    _: &Plan,
    matrix: &SpeedMatrix,
) -> Vec<Expr> {
    matrix.concat()
}

pub(in crate::functions) fn packed_of_inverse(
    _: &mut ExprGraph,
    tree: &Tree,
    _: &Plan,
    inverse: &SpeedMatrix,
) -> Vec<Expr> {
    at(solve::inverse_places(tree), inverse)
}

pub(in crate::functions) fn product(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let mut tau = dynamics::mass_matrix_product(graph, tree);
    mechanics::add_rotor_forces(graph, tree, &mut tau);
    tau
}

pub(in crate::functions) fn product_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Vec<Expr> {
    let mut tau = product::mass_matrix_product(graph, tree, plan);
    mechanics::add_rotor_forces(graph, tree, &mut tau);
    tau
}

pub(in crate::functions) fn solution(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let factors = factors(graph, tree);
    let tau = applied(graph, tree);
    factors.solve(graph, tau)
}

pub(in crate::functions) fn solution_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Vec<Expr> {
    let tau = applied(graph, tree);
    inverse_mass::solution(graph, tree, plan, tau)
}

pub(in crate::functions) fn inverse(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    factors(graph, tree)
        .inverse(graph, tree, Inversion::by(&Carriers::default()))
        .concat()
}

pub(in crate::functions) fn inverse_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Vec<Expr> {
    inverse_mass::inverse(graph, tree, plan).concat()
}

pub(in crate::functions) fn inverse_packed(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let inverse = factors(graph, tree).inverse(graph, tree, Inversion::by(&Carriers::default()));
    at(solve::inverse_places(tree), &inverse)
}

pub(in crate::functions) fn inverse_packed_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Vec<Expr> {
    let inverse = inverse_mass::inverse(graph, tree, plan);
    at(solve::inverse_places(tree), &inverse)
}

pub(in crate::functions) fn mass_matrix_factors(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let entries = factors(graph, tree).entries(graph);
    at(solve::factor_places(tree), &entries)
}

pub(in crate::functions) fn mass_matrix_factors_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Vec<Expr> {
    let entries = factors_recursive(graph, tree, plan).entries(graph);
    at(solve::factor_places(tree), &entries)
}
