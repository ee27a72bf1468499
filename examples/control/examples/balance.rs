//! Pushes a Solo 12 that stands on four feet: [`kane_examples::balance`].

#![expect(clippy::print_stdout, reason = "what it prints is what it is for")]

use kane_examples::balance::{self, Controller, Times};

fn main() {
    let mut times = Times::default();
    for force in [[20.0, 0.0, 0.0], [0.0, 15.0, 0.0], [-15.0, -12.0, 0.0]] {
        let mut controller = Controller::new(&balance::posture());
        let report = balance::run(force, &mut controller, &mut times, |solve| solve());
        println!("pushed with {force:?} N: {report}");
    }
    println!("the solver, in {}", times.program);
    println!("all but the solver, in {}", times.rest);
}
