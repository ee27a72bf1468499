//! Which entries of derivatives are left out, whatever the numbers are; all others are not zero where numbers are drawn.

use std::collections::BTreeSet;

use kane_codegen::{functions::Sparsity, recursive::Plan, tree::Tree};
use kane_test_support::{
    compare::{assert_within, larger, largest},
    dynamics::State,
    random::Random,
    systems::trees,
};

use crate::{
    derivatives::{EXACT, INVERTED, inverts, n_entries, values, variables, ways},
    evaluator::input,
    frames::{relative, request, system},
    products::every_function,
};

/// Seeds of numbers that trees are given here.
const DRAWN: [u64; 2] = [71, 72];

/// The tree with drawn numbers, also of what is set at run time.
fn drawn(tree: &Tree, seed: u64) -> Tree {
    let mut drawn = tree.with_drawn_numbers(seed);
    let numbers = Random::new(seed).numbers(drawn.parameters.len());
    for (parameter, number) in drawn.parameters.iter_mut().zip(numbers) {
        parameter.nominal = number;
    }
    drawn
}

fn sparsity(tree: &Tree, text: &str) -> Sparsity {
    let request = request(tree, text);
    let sparsity = request.parts()[0].sparsity(tree);
    sparsity.expect("it is packed").clone()
}

/// All derivatives at a state drawn by the seed.
fn whole(tree: &Tree, text: &str, seed: u64) -> Vec<f64> {
    let state = State::random(tree, seed);
    values(tree, &request(tree, text), &Plan::full(tree), &state)
}

/// Of each entry whether it is left out.
fn left_out(places: &[[usize; 2]], n: usize, n_all: usize) -> Vec<bool> {
    let mut left_out = vec![true; n_all];
    for [row, column] in places {
        left_out[row * n + column] = false;
    }
    left_out
}

#[test]
fn what_is_left_out_is_zero_and_nothing_else() {
    for seed in trees::tried(591..=596) {
        let (_, tree) = system(seed);
        let drawn = DRAWN.map(|seed| drawn(&tree, seed));
        for (function, name) in every_function(&tree) {
            for variable in variables(&tree, function) {
                let text = format!("d({name})/d({variable})");
                let places = sparsity(&tree, &format!("packed({text})")).places;
                let n = n_entries(&tree, &variable);
                let own = whole(&tree, &text, seed);
                let mut most = vec![0.0; own.len()];
                let allowed = if inverts(&name) { INVERTED } else { EXACT };
                for (tree, seed) in [
                    (&tree, seed),
                    (&drawn[0], 1),
                    (&drawn[0], 2),
                    (&drawn[1], 3),
                ] {
                    let found = whole(tree, &text, seed);
                    let scale = larger(largest(&found), 1.0);
                    for (most, own) in most.iter_mut().zip(&found) {
                        *most = larger(*most, own.abs() / scale);
                    }
                }
                for (place, (is_out, most)) in left_out(&places, n, own.len())
                    .iter()
                    .zip(&most)
                    .enumerate()
                {
                    let what = format!("{seed}, {text}, row {}, column {}", place / n, place % n);
                    if *is_out {
                        assert_within(what, *most, allowed);
                    } else if *most < 1e-14 {
                        println!(
                            "NOTSPARSE {what}: {most:e} {}",
                            tree.parameters.get(place % n).map_or("", |p| &p.name)
                        );
                    }
                    if *is_out && *most != 0.0 {
                        println!(
                            "NOISE {seed}, {text}, row {}, column {} {most:e}",
                            place / n,
                            place % n
                        );
                    }
                }
            }
        }
    }
}
