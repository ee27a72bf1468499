//! Turns the hub of eight free bodies: [`kane_examples::reorientation`].

#![expect(clippy::print_stdout, reason = "what it prints is what it is for")]

use kane_examples::{CallTimes, reorientation};

fn main() {
    let mut calls = CallTimes::default();
    let turn = [0.5, -0.3, 0.6];
    let report = reorientation::run(turn, 1e-3, 20, &mut calls);
    println!("{report}");
    println!("{calls}");
}
