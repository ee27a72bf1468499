//! Presses a Panda's hand against a wall that is a quarter stiffer than it believes: [`kane_examples::impedance`].

#![expect(clippy::print_stdout, reason = "what it prints is what it is for")]

use kane_examples::{CallTimes, impedance};

fn main() {
    let mut calls = CallTimes::default();
    println!("{}", impedance::run(20e3, 16e3, &mut calls));
    println!("{calls}");
}
