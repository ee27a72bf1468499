//! Holds and moves a UR5 under payloads that it does not know: [`kane_examples::gravity_compensation`].

#![expect(clippy::print_stdout, reason = "what it prints is what it is for")]

use kane_examples::{CallTimes, gravity_compensation};

fn main() {
    let mut calls = CallTimes::default();
    print!("{}", gravity_compensation::run(&mut calls));
    println!("{calls}");
}
