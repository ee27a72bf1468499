//! What joined functions cost, beside their parts.

#![expect(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use std::collections::BTreeSet;

use kane_codegen::{compile, functions::Formulation, recursive::Technique, report, tree::Tree};
use kane_test_support::{random::Random, systems::trees};

use crate::frames::{request, system};

/// Of some the notes need fewer operations than the recursion, on small trees.
const PARTS: [&str; 9] = [
    "bias",
    "d(bias)/d(q)",
    "generalized_forces",
    "mass_matrix_dot",
    "mass_matrix_factors",
    "mass_matrix_inverse_packed",
    "potential_energy",
    "regressor_packed",
    "vjp(bias; u)",
];

/// What functions cost without lockstep, which takes more operations in a shorter time, and in which formulation they are.
fn costs(tree: &Tree, functions: &[&str]) -> Vec<(usize, Formulation)> {
    let requests: Vec<_> = functions.iter().map(|text| request(tree, text)).collect();
    let counts = report::count(tree, &requests, &BTreeSet::from([Technique::Lockstep])).into_iter();
    let costs = counts.map(|counts| {
        let cost = |&(_, operations)| compile::cost(&counts.function, operations);
        let least = counts.formulations.iter().map(cost).min();
        (least.unwrap(), counts.cheapest.unwrap())
    });
    costs.collect()
}

#[test]
fn a_joined_function_costs_no_more_than_its_parts() {
    let mut n_of_two = 0;
    for seed in trees::tried(601..=640) {
        let (_, tree) = system(seed);
        let mut random = Random::new(seed);
        for _ in 0..4 {
            let first = random.below(PARTS.len());
            let second = (first + 1 + random.below(PARTS.len() - 1)) % PARTS.len();
            let parts = [PARTS[first], PARTS[second]];
            let joined = parts.join("+");
            let costs = costs(&tree, &[parts[0], parts[1], &joined]);
            let [(one, by), (other, other_by), (whole, _)] = costs[..] else {
                unreachable!("three were asked for");
            };
            assert!(
                whole <= one + other,
                "{seed} {joined}: {whole} of {one} + {other}"
            );
            n_of_two += usize::from(by != other_by);
        }
    }
    assert!(n_of_two > 0, "all parts want one formulation");
}
