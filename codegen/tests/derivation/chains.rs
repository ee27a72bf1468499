//! How the cost of a function grows with a chain.
#![allow(
    clippy::print_stdout,
    reason = "the operations counted, shown with --nocapture"
)]

use std::fmt::Write as _;

use kane_codegen::{
    compile::operations,
    functions::{Derived, Formulation, Function},
    passes::factor,
    tree::Tree,
};

/// A chain of free bodies. Numbers differ from body to body: equal ones would be shared.
fn chain(n_bodies: u8) -> Tree {
    let lower: Vec<u8> = (0..n_bodies).collect();
    let mut text =
        format!("name = \"chain\"\ngravity = [0.1, 0.2, -9.81]\nlower_bodies = {lower:?}\n");
    for body in 1..=n_bodies {
        let number = |start: f64| start + f64::from(body) / 1000.0;
        let [a, b, c, d, e, f] = [0.3, 0.35, 0.4, 0.01, 0.02, 0.03].map(number);
        write!(
            text,
            "\n[[body]]\nname = \"b{body}\"\nmass = {:?}\nmass_center = [{a}, {b}, {c}]\n\
            inertia = {{ xx = {a}, yy = {b}, zz = {c}, xy = {d}, xz = {e}, yz = {f} }}\n\
            attachment = [{b}, {c}, {a}]\njoint = \"free\"\n",
            number(1.0)
        )
        .expect("a String takes any text");
    }
    kane_test_support::models::build(&text)
        .expect("a right description")
        .tree
}

/// Operations as emitted.
fn cost(tree: &Tree, function: &str) -> usize {
    let function = Function::find(function).expect("a function of the catalogue");
    let derived = function.derive(
        tree,
        Formulation::Recursive,
        &kane_codegen::recursive::Plan::full(tree),
    );
    let (graph, roots) = factor::run(&derived.graph, &derived.roots);
    operations(&Derived {
        graph,
        roots,
        blocks: derived.blocks,
    })
    .total()
}

#[test]
fn right_hand_sides_of_chains_grow_by_the_same_with_every_body() {
    let chains: Vec<Tree> = (2..=32).map(chain).collect();
    for function in ["bias", "inverse_dynamics"] {
        let costs: Vec<usize> = chains.iter().map(|tree| cost(tree, function)).collect();
        let steps: Vec<usize> = costs.windows(2).map(|pair| pair[1] - pair[0]).collect();
        println!(
            "{function}: {} at 2 bodies, {} at 32, {} for each",
            costs[0], costs[30], steps[0]
        );
        assert!(
            steps.iter().all(|step| *step == steps[0]),
            "{function}: {costs:?}"
        );
    }
}
