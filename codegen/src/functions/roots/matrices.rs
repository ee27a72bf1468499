//! The root expressions of functions of the mass matrix: its products, solutions, inverse and factors.

use super::dynamics::{applied, at, factors};
use crate::{
    expr::{Expr, ExprGraph},
    functions::formulation::Way,
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

pub(in crate::functions) fn product(graph: &mut ExprGraph, tree: &Tree, way: Way<'_>) -> Vec<Expr> {
    let mut tau = match way {
        Way::Notes => dynamics::mass_matrix_product(graph, tree),
        Way::Recursive(plan) => product::mass_matrix_product(graph, tree, plan),
    };
    mechanics::add_rotor_forces(graph, tree, &mut tau);
    tau
}

pub(in crate::functions) fn solution(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
) -> Vec<Expr> {
    match way {
        Way::Notes => {
            let factors = factors(graph, tree, way);
            let tau = applied(graph, tree);
            factors.solve(graph, tau)
        }
        Way::Recursive(plan) => {
            let tau = applied(graph, tree);
            inverse_mass::solution(graph, tree, plan, tau)
        }
    }
}

pub(in crate::functions) fn inverse(graph: &mut ExprGraph, tree: &Tree, way: Way<'_>) -> Vec<Expr> {
    inverted(graph, tree, way).concat()
}

pub(in crate::functions) fn inverse_packed(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
) -> Vec<Expr> {
    let inverse = inverted(graph, tree, way);
    at(solve::inverse_places(tree), &inverse)
}

fn inverted(graph: &mut ExprGraph, tree: &Tree, way: Way<'_>) -> SpeedMatrix {
    match way {
        Way::Notes => {
            let factors = factors(graph, tree, way);
            factors.inverse(graph, tree, Inversion::by(&Carriers::default()))
        }
        Way::Recursive(plan) => inverse_mass::inverse(graph, tree, plan),
    }
}

pub(in crate::functions) fn mass_matrix_factors(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
) -> Vec<Expr> {
    let entries = factors(graph, tree, way).entries(graph);
    at(solve::factor_places(tree), &entries)
}
