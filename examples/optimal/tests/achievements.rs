//! What the examples achieve.

use kane_optimal::predictive::{self, Derivatives};
use kane_optimal::{arm, formation, payload, reach, swing_up};
use kane_test_support::compare::{Tolerance, assert_close, assert_within, largest};

#[test]
fn a_pole_is_swung_up_within_the_limits_of_the_force() {
    let motion = swing_up::run();
    // The limit counts: some step is at it.
    let forces = motion.forces.iter().flatten();
    assert_eq!(largest(forces), swing_up::FORCE);
    // A force costs as little as holding the pole a hundredth off for the last second.
    let (q, u) = motion.states.last().unwrap();
    let still = [q[0], q[1], u[0], u[1]];
    assert_close("still", &still, &[0.0; 4], Tolerance::absolute(0.01));
}

#[test]
fn an_arm_reaches_a_point_within_the_limits_of_its_drives() {
    let motion = reach::run();
    let parts = motion.forces.iter();
    let parts: Vec<_> = parts
        .map(|torques| torques.component_div(&arm::limits()))
        .collect();
    // Some drive gives all that it has, and none more.
    assert_eq!(largest(parts.iter().flatten()), 1.0);
    let (q, u) = motion.states.last().unwrap();
    let way = arm::position(&reach::system(), q) - reach::goal();
    assert_within("way, m", way.norm(), 1e-3);
    assert_close("still", u, &[0.0; 7], Tolerance::absolute(0.02));
}

#[test]
fn eight_bodies_return_to_their_formation() {
    let report = formation::run().unwrap();
    // Pairs of equal eigenvalues without two directions of their own: rounding moves them by its root.
    for value in &report.alone {
        assert_within("alone", value.norm() - 1.0, 1e-6);
    }
    assert_eq!(report.held.len(), 96);
    let sizes: Vec<f64> = report.held.iter().map(|value| value.norm()).collect();
    assert_within("held", largest(&sizes), 0.999);
    // Five hundred steps, of which in the end each leaves at most the largest eigenvalue's part.
    let [start, end] = report.away;
    assert!(end < 1e-3 * start, "{end} of {start}");
}

#[test]
fn a_payload_is_found_as_surely_as_its_estimate_says() {
    for seed in 1..=5 {
        let estimate = payload::run(seed).unwrap();
        let pairs = estimate.found.iter().zip(payload::TRUE).zip(estimate.sure);
        for (place, ((found, truth), sure)) in pairs.enumerate() {
            // Four standard deviations: one number in sixteen thousand would be farther off.
            assert_within(format!("{seed}, {place}"), found - truth, 4.0 * sure);
        }
        assert_within("mass, kg", estimate.found[0] - payload::TRUE[0], 0.02);
    }
}

#[test]
fn a_plan_a_millisecond_leads_the_arm_to_its_goal() {
    let report = predictive::run(Derivatives::Generated, 600, &mut |plan| plan());
    assert_within("parts of limits", largest(&report.parts), 1.0);
    assert_within("way, m", *report.ways.last().unwrap(), 5e-3);
    let differenced = predictive::run(Derivatives::Differenced, 20, &mut |plan| plan());
    // Half the digits of the derivatives, over twenty periods.
    let ways = &report.ways[..20];
    assert_close("ways", &differenced.ways, ways, Tolerance::absolute(1e-6));
}
