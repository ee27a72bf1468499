//! The root expressions of matrices, forces and accelerations.

use crate::{
    expr::{Expr, ExprGraph, Input},
    given::{Accelerations, Loads, mechanics},
    kane::dynamics,
    recursive::{
        self, Plan,
        forces::{gravity, inverse_dynamics},
        matrices::composite,
    },
    solve::{self, Factors, SpeedMatrix},
    tree::Tree,
};

pub(super) fn with_rotors(graph: &mut ExprGraph, tree: &Tree, mut a: SpeedMatrix) -> SpeedMatrix {
    mechanics::add_rotors(graph, tree, &mut a);
    a
}

/// With what is needed beside the motion of bodies: for springs, dampers and rotors, less what lifts bodies, which is found by the
/// notes' equations where there is no plan.
pub(super) fn with_forces(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: Option<&Plan>,
    accelerations: Accelerations<'_>,
    mut tau: Vec<Expr>,
) -> Vec<Expr> {
    mechanics::add_forces(graph, tree, accelerations, &mut tau);
    if tree.lifts_some() {
        let lifting = match plan {
            None => dynamics::lifting_forces(graph, tree),
            Some(plan) => gravity::lifting_forces(graph, tree, plan),
        };
        solve::subtract(graph, tree, &mut tau, &lifting);
    }
    tau
}

pub(in crate::functions) fn matrix(graph: &mut ExprGraph, tree: &Tree) -> SpeedMatrix {
    let a = dynamics::mass_matrix(graph, tree);
    with_rotors(graph, tree, a)
}

fn matrix_recursive(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> SpeedMatrix {
    let a = composite::mass_matrix(graph, tree, plan);
    with_rotors(graph, tree, a)
}

pub(in crate::functions) fn mass_matrix(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    matrix(graph, tree).concat()
}

pub(in crate::functions) fn mass_matrix_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Vec<Expr> {
    matrix_recursive(graph, tree, plan).concat()
}

pub(in crate::functions) fn mass_matrix_packed(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    packed(tree, &matrix(graph, tree))
}

pub(in crate::functions) fn mass_matrix_packed_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Vec<Expr> {
    packed(tree, &matrix_recursive(graph, tree, plan))
}

fn packed(tree: &Tree, a: &SpeedMatrix) -> Vec<Expr> {
    at(tree.coupled_speeds(), a)
}

pub(in crate::functions) fn packed_of_mass(
    _: &mut ExprGraph,
    tree: &Tree,
    _: &Plan,
    mass: &SpeedMatrix,
) -> Vec<Expr> {
    packed(tree, mass)
}

/// The entries of a matrix at these places.
pub(super) fn at(places: impl IntoIterator<Item = [usize; 2]>, matrix: &SpeedMatrix) -> Vec<Expr> {
    let places = places.into_iter();
    places.map(|[row, column]| matrix[row][column]).collect()
}

pub(in crate::functions) fn generalized_forces(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    dynamics::generalized_forces(graph, tree)
}

pub(in crate::functions) fn generalized_forces_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Vec<Expr> {
    inverse_dynamics::generalized_forces(graph, tree, plan)
}

pub(in crate::functions) fn forcing(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let f = dynamics::forcing(graph, tree);
    less_forces(graph, tree, None, f)
}

pub(in crate::functions) fn forcing_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Vec<Expr> {
    let f = inverse_dynamics::forcing(graph, tree, plan);
    less_forces(graph, tree, Some(plan), f)
}

fn less_forces(graph: &mut ExprGraph, tree: &Tree, plan: Option<&Plan>, f: Vec<Expr>) -> Vec<Expr> {
    let minus = f.into_iter().map(|entry| -entry).collect();
    let sum = with_forces(graph, tree, plan, Accelerations::Zero, minus);
    sum.into_iter().map(|entry| -entry).collect()
}

pub(in crate::functions) fn bias(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let tau = dynamics::inverse_dynamics(graph, tree, Accelerations::Zero);
    with_forces(graph, tree, None, Accelerations::Zero, tau)
}

pub(in crate::functions) fn bias_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Vec<Expr> {
    let tau = inverse_dynamics::inverse_dynamics(graph, tree, plan, Accelerations::Zero);
    with_forces(graph, tree, Some(plan), Accelerations::Zero, tau)
}

pub(in crate::functions) fn gravity_forces(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    dynamics::gravity_forces(graph, tree)
}

pub(in crate::functions) fn gravity_forces_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Vec<Expr> {
    gravity::gravity_forces(graph, tree, plan)
}

pub(in crate::functions) fn inverse_dynamics(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let tau = dynamics::inverse_dynamics(graph, tree, Accelerations::Given);
    with_forces(graph, tree, None, Accelerations::Given, tau)
}

pub(in crate::functions) fn inverse_dynamics_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Vec<Expr> {
    let tau = inverse_dynamics::inverse_dynamics(graph, tree, plan, Accelerations::Given);
    with_forces(graph, tree, Some(plan), Accelerations::Given, tau)
}

pub(in crate::functions) fn forward_dynamics(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let bias = bias(graph, tree);
    accelerated(graph, tree, &bias)
}

/// The accelerations by what is left of `tau` beside what a motion without any needs.
pub(super) fn accelerated(graph: &mut ExprGraph, tree: &Tree, needed: &[Expr]) -> Vec<Expr> {
    let factors = factors(graph, tree);
    let mut net = applied(graph, tree);
    solve::subtract(graph, tree, &mut net, needed);
    factors.solve(graph, net)
}

pub(in crate::functions) fn forward_dynamics_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Vec<Expr> {
    accelerated_recursive(graph, tree, plan, Loads::Absent)
}

pub(super) fn accelerated_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    loads: Loads,
) -> Vec<Expr> {
    let mut net = applied(graph, tree);
    let zero = vec![graph.zero(); net.len()];
    let taken = with_forces(graph, tree, Some(plan), Accelerations::Zero, zero);
    solve::subtract(graph, tree, &mut net, &taken);
    recursive::accelerations::forward_dynamics::forward_dynamics(graph, tree, plan, net, loads)
}

/// `tau`, each entry in the scope of its body.
pub(in crate::functions) fn applied(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let mut tau = vec![graph.zero(); tree.n_speeds];
    for body in tree.body_ids() {
        graph.enter(body);
        for (_, speed) in tree.body(body).joint.speeds() {
            tau[speed.index()] = graph.input(Input::Tau(speed));
        }
    }
    tau
}

pub(in crate::functions) fn factors(graph: &mut ExprGraph, tree: &Tree) -> Factors {
    let a = matrix(graph, tree);
    solve::factorise(graph, tree, a)
}

pub(super) fn factors_recursive(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Factors {
    let a = matrix_recursive(graph, tree, plan);
    solve::factorise(graph, tree, a)
}

pub(in crate::functions) fn pivots(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    factors(graph, tree).pivots
}

pub(in crate::functions) fn pivots_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Vec<Expr> {
    factors_recursive(graph, tree, plan).pivots
}
