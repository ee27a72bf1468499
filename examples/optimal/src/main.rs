//! Runs all of them, and prints what they achieve.

use std::time::{Duration, Instant};

use kane_optimal::predictive::{self, Derivatives};
use kane_optimal::{arm, formation, payload, reach, swing_up};

#[expect(clippy::print_stdout, reason = "a program that reports")]
fn main() {
    let motion = swing_up::run();
    if let Some(([_, pole], [_, turning])) = motion.states.last() {
        println!("swing-up: the pole is {pole:.4} rad from upright, turning at {turning:.4} rad/s");
    }
    let motion = reach::run();
    if let Some((q, _)) = motion.states.last() {
        let way = arm::position(&reach::system(), q) - reach::goal();
        println!(
            "reach: {:.2} mm from the goal after half a second",
            1e3 * way.norm()
        );
    }
    if let Some(report) = formation::run() {
        let sizes = report.held.iter().map(|value| value.norm());
        let largest = sizes.max_by(f64::total_cmp).unwrap_or_default();
        let [start, end] = report.away;
        println!(
            "formation: eigenvalues up to {largest:.4}; {start:.3} away at first, {end:.1e} after ten seconds, rad and m"
        );
    }
    if let Some(estimate) = payload::run(1) {
        let [mass, x, y, z] = estimate.found;
        let sure = estimate.sure[0];
        println!("payload: {mass:.3} ± {sure:.3} kg at ({x:.3}, {y:.3}, {z:.3}) m");
    }
    for (what, derivatives) in [
        ("generated derivatives", Derivatives::Generated),
        ("differences", Derivatives::Differenced),
    ] {
        let mut times: Vec<Duration> = Vec::new();
        let report = predictive::run(derivatives, 1000, &mut |plan| {
            times.push(timed(plan));
        });
        times.sort_unstable();
        let (median, slow) = (times[times.len() / 2], times[times.len() * 99 / 100]);
        let way = report.ways.last().map_or(0.0, |way| 1e3 * way);
        println!(
            "predictive, {what}: a plan of {} steps in {median:.0?}, 99 of 100 below {slow:.0?}; {way:.2} mm away after a second",
            predictive::HORIZON
        );
    }
}

#[expect(
    clippy::disallowed_methods,
    reason = "the clock reaches the times of plans, and nothing that is computed"
)]
fn timed(plan: &mut dyn FnMut()) -> Duration {
    let start = Instant::now();
    plan();
    start.elapsed()
}
