//! What one part of a joined function tells another, against the notes' equations of each.

use kane_codegen::{
    functions::Formulation,
    recursive::{Plan, Technique},
};
use kane_test_support::{compare::assert_within, dynamics::State, systems::trees};

use crate::{
    derivatives::{EXACT, INVERTED, inverts},
    frames::{evaluate_by, relative, request, system},
};

/// Parts of which one finds what others need.
const TOLD: [&[&str]; 5] = [
    &[
        "mass_matrix",
        "bias",
        "coriolis_matrix",
        "mass_matrix_dot",
        "mass_matrix_packed",
    ],
    &["d(inverse_dynamics)/d(u_dot, q)", "mass_matrix"],
    &["mass_matrix_packed", "d(forcing)/d(u)"],
    &["mass_matrix", "packed(d(bias)/d(q))"],
    &[
        "mass_matrix_inverse",
        "d(forward_dynamics)/d(q)",
        "mass_matrix_packed",
        "mass_matrix_inverse_packed",
    ],
];

#[test]
fn what_is_told_is_what_the_notes_say() {
    for seed in trees::tried(571..=594) {
        let (_, tree) = system(seed);
        let state = State::random(&tree, seed);
        for parts in TOLD {
            let alone = parts.iter().flat_map(|part| {
                let alone = request(&tree, part);
                evaluate_by(
                    &tree,
                    &alone,
                    Formulation::Notes,
                    &Plan::plain(&tree),
                    &state,
                )
            });
            let expected: Vec<f64> = alone.collect();
            let text = parts.join("+");
            let joined = request(&tree, &text);
            let full = Plan::full(&tree);
            let one_by_one = full.with(Technique::Lockstep, false);
            for plan in [&full, &one_by_one, &full.with_matrices_apart(true)] {
                let found = evaluate_by(&tree, &joined, Formulation::Recursive, plan, &state);
                let allowed = if inverts(&text) { INVERTED } else { EXACT };
                assert_within(
                    format!("{seed}, {text}"),
                    relative(&found, &expected),
                    allowed,
                );
            }
        }
    }
}
