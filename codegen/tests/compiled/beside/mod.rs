//! The tests beside modules, compiled and run: whatever the model, a sound module passes them and a faulty one does not.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test stops where it cannot go on"
)]

mod crates;
mod expected;
mod interpreter;
mod mutants;
mod unusual;

use kane_test_support::{mutant::mutant, systems::trees};

use crates::Tested;
use mutants::{Evaluated, Verdict};

/// How many mutants each tree has.
const MUTANTS: u64 = 10;

/// How many of these are compiled and run, of the smallest tree: what is evaluated is what a compiler makes of the text.
const COMPILED: u64 = 3;

/// Each tree alone: all of them in one crate would take gigabytes.
#[test]
#[expect(clippy::print_stdout, reason = "what was tried, for `tests/trees.sh`")]
fn random_trees_pass_and_their_mutants_do_not() {
    let count = trees::count(3);
    let (mut n_tests, mut caught, mut harmless, mut missed) = (0, 0, Vec::new(), Vec::new());
    for (place, system) in trees::first(count).enumerate() {
        let tested = Tested::new(&system.toml());
        n_tests += tested.passes(&system.name);
        let evaluated = Evaluated::new(tested.module(), tested.tests());
        for seed in 0..MUTANTS {
            let mutant = mutant(tested.module(), seed);
            let verdict = evaluated.verdict(&mutant);
            let at = format!("{}: {}", system.name, mutant.line);
            if place == 0 && seed < COMPILED {
                let fails = tested.fails(&mutant.module);
                assert!(fails || verdict != Verdict::Seen, "{at}");
            }
            match verdict {
                Verdict::Seen => caught += 1,
                Verdict::Harmless => harmless.push(at),
                // What the test of a function's values does not see, its identities may.
                Verdict::Unseen(_) if tested.fails(&mutant.module) => caught += 1,
                Verdict::Unseen(function) => missed.push(format!("{at}, of {function}")),
            }
        }
    }
    println!(
        "{count} trees pass {n_tests} tests; of their mutants {caught} are caught, these change nothing: {harmless:#?}"
    );
    assert!(missed.is_empty(), "not caught: {missed:#?}");
    assert!(caught > harmless.len(), "{caught} mutants change a value");
}
