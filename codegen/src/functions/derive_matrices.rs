//! The root expressions of functions of the mass matrix: its products, solutions, inverse and factors.

use super::derive::{applied, factors, factors_recursive};
use crate::{
    expr::{Expr, ExprGraph},
    given::mechanics,
    kane::dynamics,
    recursive::{Plan, inverse_mass, product},
    solve::{self, Carriers, Inversion, SpeedMatrix},
    tree::Tree,
};

fn at(places: impl IntoIterator<Item = [usize; 2]>, matrix: &SpeedMatrix) -> Vec<Expr> {
    let places = places.into_iter();
    places.map(|[row, column]| matrix[row][column]).collect()
}

pub(super) fn product(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let mut tau = dynamics::mass_matrix_product(graph, tree);
    mechanics::add_rotor_forces(graph, tree, &mut tau);
    tau
}

pub(super) fn product_recursive(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Vec<Expr> {
    let mut tau = product::mass_matrix_product(graph, tree, plan);
    mechanics::add_rotor_forces(graph, tree, &mut tau);
    tau
}

pub(super) fn solution(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let factors = factors(graph, tree);
    let tau = applied(graph, tree);
    factors.solve(graph, tau)
}

pub(super) fn solution_recursive(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Vec<Expr> {
    let tau = applied(graph, tree);
    inverse_mass::solution(graph, tree, plan, tau)
}

pub(super) fn inverse(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    factors(graph, tree)
        .inverse(graph, tree, Inversion::by(&Carriers::default()))
        .concat()
}

pub(super) fn inverse_recursive(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Vec<Expr> {
    inverse_mass::inverse(graph, tree, plan).concat()
}

pub(super) fn inverse_packed(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let inverse = factors(graph, tree).inverse(graph, tree, Inversion::by(&Carriers::default()));
    at(solve::inverse_places(tree), &inverse)
}

pub(super) fn inverse_packed_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Vec<Expr> {
    let inverse = inverse_mass::inverse(graph, tree, plan);
    at(solve::inverse_places(tree), &inverse)
}

pub(super) fn mass_matrix_factors(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let entries = factors(graph, tree).entries(graph);
    at(solve::factor_places(tree), &entries)
}

pub(super) fn mass_matrix_factors_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Vec<Expr> {
    let entries = factors_recursive(graph, tree, plan).entries(graph);
    at(solve::factor_places(tree), &entries)
}
