//! Leads a Panda along a path: [`kane_examples::computed_torque`].

#![expect(clippy::print_stdout, reason = "what it prints is what it is for")]

use kane_examples::{CallTimes, computed_torque};

fn main() {
    let mut calls = CallTimes::default();
    for believed in [1.2, 1.0, 0.0] {
        let report = computed_torque::run(1.2, believed, &mut calls);
        println!("1.2 kg in the hand, {believed} kg believed: {report}");
    }
    println!("{calls}");
}
