//! The root expressions of the Coriolis matrix, and of the rate of the mass matrix.

use super::{coordinates, dynamics::with_rotors};
use crate::{
    differentiate::{Seeds, forward},
    expr::{Expr, ExprGraph, Input, Purpose},
    functions::{
        argument::Argument,
        formulation::Way,
        told::{KnownMatrix, Told},
    },
    given::{Accelerations, mechanics},
    kane,
    recursive::{Plan, Technique, forces::gravity, matrices as recursive},
    solve::{self, SpeedMatrix},
    tree::Tree,
};

pub(in crate::functions) fn mass_matrix_dot(
    graph: &mut ExprGraph,
    tree: &Tree,
    way: Way<'_>,
) -> Vec<Expr> {
    let rate = match way {
        Way::Notes => kane::coriolis::mass_matrix_dot(graph, tree),
        Way::Recursive(plan) => rate_and_mass(graph, tree, plan).0,
    };
    rate.concat()
}

/// With the mass matrix, of which it is the rate.
pub(in crate::functions) fn mass_matrix_dot_beside(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> (Vec<Expr>, Told) {
    let (rate, mass) = rate_and_mass(graph, tree, plan);
    let mass = with_rotors(graph, tree, mass);
    (rate.concat(), Told::default().with(KnownMatrix::Mass, mass))
}

fn rate_and_mass(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> (SpeedMatrix, SpeedMatrix) {
    if plan.uses(Technique::Rates) {
        recursive::mass_matrix_dot::mass_matrix_dot(graph, tree, plan)
    } else {
        let mass = recursive::composite::mass_matrix(graph, tree, plan);
        (differentiated(graph, tree, &mass), mass)
    }
}

/// The rate of the mass matrix, from its entries.
fn differentiated(graph: &mut ExprGraph, tree: &Tree, mass: &SpeedMatrix) -> SpeedMatrix {
    let places: Vec<[usize; 2]> = tree.coupled_speeds().into_iter().collect();
    let entries: Vec<Expr> = places.iter().map(|&[i, j]| mass[i][j]).collect();
    graph.enter(None);
    let rates = coordinates::q_dot(graph, tree).into_iter();
    let rates = rates.map(|rate| vec![(0, rate)]);
    let seeds: Seeds = Argument::Q.inputs(tree).zip(rates).collect();
    let changes = forward(graph, &entries, &seeds);
    let mut rate = solve::zero_matrix(graph, tree.n_speeds);
    for ([row, column], change) in places.into_iter().zip(changes) {
        if let Some(&(_, change)) = change.first() {
            rate[row][column] = change;
            rate[column][row] = change;
        }
    }
    rate
}

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
