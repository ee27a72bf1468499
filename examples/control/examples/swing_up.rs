//! Swings a pole up and balances it: [`kane_examples::swing_up`].

#![expect(clippy::print_stdout, reason = "what it prints is what it is for")]

use kane_examples::{CallTimes, swing_up};

fn main() {
    let mut calls = CallTimes::default();
    for mass in [0.5, 0.6, 0.4] {
        let report = swing_up::run(mass, 0.5, &mut calls);
        println!("a pole of {mass} kg, 0.5 kg believed: {report}");
    }
    println!("{calls}");
}
