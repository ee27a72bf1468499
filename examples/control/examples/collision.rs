//! Hits a UR5 that feels it by its motors' torques: [`kane_examples::collision`].

#![expect(clippy::print_stdout, reason = "what it prints is what it is for")]

use kane_examples::{CallTimes, collision};

fn main() {
    let mut calls = CallTimes::default();
    println!("{}", collision::run(&mut calls));
    println!("{calls}");
}
