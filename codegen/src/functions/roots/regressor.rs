//! The root expressions of regressors.

use crate::{
    base_parameters,
    expr::{Expr, ExprGraph},
    functions::formulation::Way,
    given::{self, mechanics},
    kane, recursive,
    tree::{N_INERTIAL, Tree, regressor_place, regressor_places, user_parts},
};

pub(in crate::functions) fn inertial_parameters(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let bodies = tree.body_ids();
    let parameters = bodies.flat_map(|body| {
        graph.enter(body);
        given::inertial_parameters(graph, &user_parts(tree.body(body)))
    });
    parameters.collect()
}

pub(in crate::functions) fn base_parameters(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let inertial = inertial_parameters(graph, tree);
    let sums = base_parameters::of(tree).iter().map(|parameter| {
        graph.enter(parameter.terms[0].0.body);
        let terms = parameter.terms.iter();
        terms.fold(graph.zero(), |sum, (own, factor)| {
            let factor = graph.number(*factor);
            let term = graph.mul(factor, inertial[own.column()]);
            graph.add(sum, term)
        })
    });
    sums.collect()
}

pub(in crate::functions) fn regressor(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
) -> Vec<Expr> {
    match way {
        Way::Notes => kane::regressor::regressor(graph, tree),
        Way::Recursive(plan) => recursive::regressor::regressor(graph, tree, plan),
    }
}

pub(in crate::functions) fn regressor_packed(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
) -> Vec<Expr> {
    let y = regressor(graph, tree, way);
    let columns = N_INERTIAL * tree.bodies.len();
    let places = regressor_places(tree).into_iter();
    places
        .map(|[row, column]| y[row * columns + column])
        .collect()
}

/// The columns of base parameters among all.
pub(in crate::functions) fn base_regressor(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
) -> Vec<Expr> {
    let y = &regressor(graph, tree, way);
    let speeds = 0..tree.n_speeds;
    let entries = speeds.flat_map(|speed| {
        let parameters = base_parameters::of(tree).iter();
        let columns = parameters.map(|parameter| parameter.terms[0].0);
        columns.map(move |own| y[regressor_place(tree, speed, own.body, own.place)])
    });
    entries.collect()
}

pub(in crate::functions) fn joint_regressor(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    mechanics::unit_forces(graph, tree).concat()
}
