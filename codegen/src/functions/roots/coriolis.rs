//! The root expressions of the Coriolis matrix, and of the rate of the mass matrix.

use super::dynamics::with_rotors;
use crate::{
    expr::{Expr, ExprGraph, Input, Purpose},
    functions::{
        argument::Argument,
        told::{KnownMatrix, Told},
    },
    given::{Accelerations, mechanics},
    recursive::{Plan, forces::gravity, matrices as recursive},
    solve::{self, SpeedMatrix},
    tree::Tree,
};

/// With the mass matrix, which its columns hold, and its rate.
pub(in crate::functions) fn coriolis_matrix_beside(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> (Vec<Expr>, Told) {
    let (c, mass) = recursive::coriolis::coriolis_and_mass_matrix(graph, tree, plan);
    let rate = rate(graph, tree, &c, &mass);
    let mass = with_rotors(graph, tree, mass);
    let entries = c.concat();
    let told = Told::default()
        .with(KnownMatrix::Mass, mass)
        .with(KnownMatrix::MassDot, rate)
        .with(KnownMatrix::Coriolis, c);
    (entries, told)
}

/// `M_dot = C + C^T`, zero where the mass matrix depends on no coordinate.
fn rate(graph: &mut ExprGraph, tree: &Tree, c: &SpeedMatrix, mass: &SpeedMatrix) -> SpeedMatrix {
    graph.begin(Purpose::Composite);
    let bodies = tree.speed_bodies();
    let varies =
        graph.varies(|input| matches!(input, Input::Q(_) | Input::Sine(_) | Input::Cosine(_)));
    let mut rate = solve::zero_matrix(graph, tree.n_speeds);
    for [row, column] in tree.coupled_speeds() {
        if varies[mass[row][column].node().index()] {
            graph.enter(bodies[row]);
            let entry = graph.add(c[row][column], c[column][row]);
            rate[row][column] = entry;
            rate[column][row] = entry;
        }
    }
    rate
}

/// `C u`, weight, springs and dampers: all that bodies need at zero accelerations.
pub(in crate::functions) fn bias_of_coriolis(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    c: &SpeedMatrix,
) -> Vec<Expr> {
    let u: Vec<Expr> = Argument::U
        .inputs(tree)
        .map(|own| graph.input(own))
        .collect();
    let mut bias = gravity::gravity_forces_of_masses(graph, tree, plan);
    graph.begin(Purpose::Forces);
    let bodies = tree.speed_bodies().into_iter();
    for ((sum, row), body) in bias.iter_mut().zip(c).zip(bodies) {
        graph.enter(body);
        for (&entry, &u) in row.iter().zip(&u) {
            let term = graph.mul(entry, u);
            *sum = graph.add(*sum, term);
        }
    }
    mechanics::add_forces(graph, tree, Accelerations::Zero, &mut bias);
    bias
}
