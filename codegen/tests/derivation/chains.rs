//! How the cost of a function grows with a chain.

#![expect(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use std::fmt::Write as _;

use crate::counts::counts;
use kane_codegen::{
    config::{Formulation, Functions},
    tree::Tree,
};
use kane_test_support::models;

/// Free bodies with all numbers different from one another and from zero: equal ones would be shared.
fn chain(n: usize) -> Tree {
    let lower: Vec<String> = (0..n).map(|k| k.to_string()).collect();
    let mut text = format!(
        "name = \"chain\"\ngravity = [0.1, 0.2, -9.81]\nlower_bodies = [{}]\n",
        lower.join(", ")
    );
    for k in 1..=n {
        write!(
            text,
            "[[body]]\nname = \"b{k}\"\nmass = {k}.5\nmass_center = [0.1{k:02}, 0.2{k:02}, 0.3{k:02}]\n\
             inertia = {{ xx = 1.1{k:02}, yy = 1.2{k:02}, zz = 1.3{k:02}, xy = 0.01{k:02}, xz = 0.02{k:02}, yz = 0.03{k:02} }}\n\
             attachment = [0.4{k:02}, 0.5{k:02}, 0.6{k:02}]\njoint = \"free\"\n"
        )
        .unwrap();
    }
    models::build(&text).unwrap().tree
}

/// Operations as emitted.
fn cost(tree: &Tree, function: &str) -> usize {
    let functions = Functions::Named(vec![function.to_owned()]);
    let counts = counts(tree, functions, Formulation::Recursive);
    // A module always has `q_dot`.
    let own = counts.iter().find(|(name, _)| name != "q_dot");
    own.unwrap().1.total()
}

#[test]
fn forces_energies_momenta_and_what_is_swept_back_for_grow_by_the_same_with_every_body() {
    let chains: Vec<[Tree; 2]> = [4, 2, 3, 8, 16, 32].map(|n| [n, n + 1].map(chain)).into();
    for function in [
        "bias",
        "inverse_dynamics",
        "kinetic_energy",
        "potential_energy",
        "linear_momentum",
        "angular_momentum",
        "d(kinetic_energy)/d(q, u)",
        "d(potential_energy)/d(q)",
        "vjp(angular_momentum; q, u)",
        "vjp(inverse_dynamics; q, u, u_dot)",
    ] {
        let mut steps = chains.iter().map(|[shorter, longer]| {
            let step = cost(longer, function) - cost(shorter, function);
            (longer.bodies.len(), step)
        });
        let (_, first) = steps.next().unwrap();
        for (n_bodies, step) in steps {
            assert_eq!(step, first, "{function}: body {n_bodies} of a chain");
        }
    }
}
