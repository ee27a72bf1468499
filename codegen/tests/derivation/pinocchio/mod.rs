//! Derivatives of dynamics against Pinocchio's, of robots.

mod local;
mod robot;

use kane_codegen::recursive::Plan;
use kane_test_support::json::flat;

use crate::derivative_references::{FORWARD, INVERSE, check, matrices, scaled};
use local::Local;
use robot::Robot;

/// Relative to the largest entry of a matrix, whose values have been rounded on the way there, too; of solutions, times a
/// ten-thousandth of the condition number of the mass matrix where that is more.
const ROUNDED: f64 = 1e-10;

fn compare(name: &str) {
    let robot = Robot::read(name);
    let (tree, samples) = (&robot.tree, robot.reference["samples"].as_array());
    // Some samples are of other quantities alone.
    let samples = samples.into_iter().flatten();
    let samples = samples.filter(|sample| sample["dtau_dq"].is_array());
    let mut n_compared = 0;
    for sample in samples.take(2) {
        n_compared += 1;
        let plan = Plan::full(tree);
        let base = robot.floats.then(|| Local::at(&robot, sample));
        // Of forces at the sample's accelerations, of accelerations at its forces.
        let inputs = robot.inputs(sample);
        let forces = matrices(tree, INVERSE, &plan, &inputs);
        let solved = scaled(ROUNDED, tree, forces[2].clone());
        let forces = forces.map(|matrix| robot.ordered(&matrix));
        let [by_q, by_u, by_a] = match &base {
            Some(base) => base.of_forces(sample, forces),
            None => forces,
        };
        check(name, ROUNDED, &by_q.entries, &flat(&sample["dtau_dq"]));
        check(name, ROUNDED, &by_u.entries, &flat(&sample["dtau_dv"]));
        check(name, ROUNDED, &by_a.entries, &flat(&sample["M"]));
        let found = matrices(tree, FORWARD, &plan, &inputs).map(|matrix| robot.ordered(&matrix));
        let [by_q, by_u, by_tau] = match &base {
            Some(base) => base.of_accelerations(sample, found),
            None => found,
        };
        check(name, solved, &by_q.entries, &flat(&sample["ddq_dq"]));
        check(name, solved, &by_u.entries, &flat(&sample["ddq_dv"]));
        check(name, solved, &by_tau.entries, &flat(&sample["ddq_dtau"]));
    }
    assert!(n_compared > 0, "nothing was compared");
}

#[test]
fn arms_change_as_pinocchio_says() {
    for name in ["double_pendulum", "cartpole", "ur5", "panda"] {
        compare(name);
    }
}

#[test]
fn robots_that_float_change_as_pinocchio_says() {
    for name in ["solo12", "talos"] {
        compare(name);
    }
}
