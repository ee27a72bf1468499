//! Lets a Panda learn what it carries: [`kane_examples::identification`].

#![expect(clippy::print_stdout, reason = "what it prints is what it is for")]

use kane_examples::{CallTimes, identification};

fn main() {
    let mut calls = CallTimes::default();
    print!("{}", identification::run(1, &mut calls));
    println!("{calls}");
}
