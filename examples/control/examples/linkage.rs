//! Turns the crank of a four-bar linkage: [`kane_examples::linkage`].

#![expect(clippy::print_stdout, reason = "what it prints is what it is for")]

use kane_examples::{CallTimes, linkage};

fn main() {
    let mut calls = CallTimes::default();
    for turns in [1.0, 2.0, -3.0] {
        if let Some(report) = linkage::run(turns, 2.0, &mut calls) {
            println!("{turns} turns in 2 s: {report}");
        }
    }
    println!("{calls}");
}
