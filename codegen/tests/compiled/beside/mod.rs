//! The tests beside modules, compiled and run: whatever the model, a sound module passes them and a faulty one does not.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test stops where it cannot go on"
)]

mod crates;
mod unusual;

use crates::Tested;

use kane_test_support::{mutant, systems::trees};

/// How many mutants each tree has where all trees are tried.
const MUTANTS: u64 = 10;

/// Each tree alone: all of them in one crate would take gigabytes.
#[test]
#[expect(clippy::print_stdout, reason = "what was tried, for `tests/trees.sh`")]
fn random_trees_pass_and_their_mutants_do_not() {
    let count = trees::count(3);
    // In an ordinary run the smallest one alone, or compiling takes a minute.
    let n_mutants = |place: usize| match (count < 50, place) {
        (false, _) => MUTANTS,
        (true, 0) => 3,
        (true, _) => 0,
    };
    let (mut n_tests, mut caught, mut missed) = (0, 0, Vec::new());
    for (place, system) in trees::first(count).enumerate() {
        let tested = Tested::new(&system.toml());
        n_tests += tested.passes(&system.name);
        for seed in 0..n_mutants(place) {
            let mutant = mutant::mutant(tested.module(), seed);
            if tested.fails(&mutant.module) {
                caught += 1;
            } else {
                missed.push(format!("{}: {}", system.name, mutant.line));
            }
        }
    }
    println!(
        "{count} trees pass {n_tests} tests; of their mutants {caught} are caught, these are not: {missed:#?}"
    );
    assert!(10 * missed.len() <= caught, "{missed:#?}");
}
