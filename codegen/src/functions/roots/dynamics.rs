//! The root expressions of matrices, forces and accelerations.

use crate::{
    expr::{Expr, ExprGraph, Input},
    functions::formulation::Way,
    given::{Accelerations, Loads, mechanics},
    kane::dynamics as notes,
    recursive::{
        Plan, accelerations,
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

/// With what is needed beside the motion of bodies: for springs, dampers and rotors, less the forces of `gravity_compensation`.
pub(super) fn with_forces(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
    accelerations: Accelerations<'_>,
    mut tau: Vec<Expr>,
) -> Vec<Expr> {
    mechanics::add_forces(graph, tree, accelerations, &mut tau);
    if tree.lifts_some() {
        let lifting = match way {
            Way::Notes => notes::lifting_forces(graph, tree),
            Way::Recursive(plan) => gravity::lifting_forces(graph, tree, plan),
        };
        solve::subtract(graph, tree, &mut tau, &lifting);
    }
    tau
}

pub(super) fn matrix(graph: &mut ExprGraph, tree: &Tree, way: Way<'_>) -> SpeedMatrix {
    let a = match way {
        Way::Notes => notes::mass_matrix(graph, tree),
        Way::Recursive(plan) => composite::mass_matrix(graph, tree, plan),
    };
    with_rotors(graph, tree, a)
}

pub(in crate::functions) fn mass_matrix(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
) -> Vec<Expr> {
    matrix(graph, tree, way).concat()
}

pub(in crate::functions) fn mass_matrix_packed(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
) -> Vec<Expr> {
    let a = matrix(graph, tree, way);
    at(tree.coupled_speeds(), &a)
}

pub(in crate::functions) fn packed_of_mass(
    _: &mut ExprGraph,
    tree: &Tree,
    _: &Plan,
    mass: &SpeedMatrix,
) -> Vec<Expr> {
    at(tree.coupled_speeds(), mass)
}

/// The entries of a matrix at these places.
pub(super) fn at(places: impl IntoIterator<Item = [usize; 2]>, matrix: &SpeedMatrix) -> Vec<Expr> {
    let places = places.into_iter();
    places.map(|[row, column]| matrix[row][column]).collect()
}

pub(in crate::functions) fn forcing(graph: &mut ExprGraph, tree: &Tree, way: Way<'_>) -> Vec<Expr> {
    let f = match way {
        Way::Notes => notes::forcing(graph, tree),
        Way::Recursive(plan) => inverse_dynamics::forcing(graph, tree, plan),
    };
    let minus = f.into_iter().map(|entry| -entry).collect();
    let sum = with_forces(graph, tree, way, Accelerations::Zero, minus);
    sum.into_iter().map(|entry| -entry).collect()
}

pub(in crate::functions) fn bias(graph: &mut ExprGraph, tree: &Tree, way: Way<'_>) -> Vec<Expr> {
    needed(graph, tree, way, Accelerations::Zero, Loads::Absent)
}

pub(in crate::functions) fn inverse_dynamics(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
) -> Vec<Expr> {
    needed(graph, tree, way, Accelerations::Given, Loads::Absent)
}

/// All forces that are needed at these accelerations.
pub(super) fn needed(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
    given: Accelerations<'_>,
    loads: Loads,
) -> Vec<Expr> {
    let tau = match (way, loads) {
        (Way::Notes, Loads::Absent) => notes::inverse_dynamics(graph, tree, given),
        (Way::Notes, Loads::Given) => notes::loaded_inverse_dynamics(graph, tree, given),
        (Way::Recursive(plan), Loads::Absent) => {
            inverse_dynamics::inverse_dynamics(graph, tree, plan, given)
        }
        (Way::Recursive(plan), Loads::Given) => {
            inverse_dynamics::loaded_inverse_dynamics(graph, tree, plan, given)
        }
    };
    with_forces(graph, tree, way, given, tau)
}

pub(in crate::functions) fn forward_dynamics(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
) -> Vec<Expr> {
    accelerated(graph, tree, way, Loads::Absent)
}

/// The accelerations by what is left of `tau` beside what a motion without any needs.
pub(super) fn accelerated(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
    loads: Loads,
) -> Vec<Expr> {
    let zero = Accelerations::Zero;
    match way {
        Way::Notes => {
            let needed = needed(graph, tree, way, zero, loads);
            let factors = factors(graph, tree, way);
            let mut net = applied(graph, tree);
            solve::subtract(graph, tree, &mut net, &needed);
            factors.solve(graph, net)
        }
        Way::Recursive(plan) => {
            let mut net = applied(graph, tree);
            let none = vec![graph.zero(); net.len()];
            let taken = with_forces(graph, tree, way, zero, none);
            solve::subtract(graph, tree, &mut net, &taken);
            accelerations::forward_dynamics::forward_dynamics(graph, tree, plan, net, loads)
        }
    }
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

pub(super) fn factors(graph: &mut ExprGraph, tree: &Tree, way: Way<'_>) -> Factors {
    let a = matrix(graph, tree, way);
    solve::factorise(graph, tree, a)
}

pub(in crate::functions) fn pivots(graph: &mut ExprGraph, tree: &Tree, way: Way<'_>) -> Vec<Expr> {
    factors(graph, tree, way).pivots
}
