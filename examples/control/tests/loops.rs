//! What each loop achieves, and that it allocates nothing while it does.

use allocation_counter::{measure, opt_out};
use kane_examples::{
    CallTimes, balance, collision, computed_torque, gravity_compensation, identification,
    impedance, reorientation, swing_up,
};

/// What a run reports, which has not allocated, and has called its controller so often.
fn without_allocating<T>(calls: u64, run: impl FnOnce(&mut CallTimes) -> T) -> T {
    let (mut times, mut report) = (CallTimes::default(), None);
    let allocations = measure(|| report = Some(run(&mut times)));
    assert_eq!(allocations.count_total, 0);
    assert_eq!(times.calls(), calls);
    report.expect("the run has ended")
}

#[test]
fn the_counter_sees_what_a_histogram_allocates() {
    let allocations = measure(|| drop(CallTimes::default()));
    assert!(allocations.count_total > 0);
}

#[test]
fn the_arm_rests_where_its_stiffness_bears_the_payload() {
    let legs = without_allocating(24_000, gravity_compensation::run).legs;
    let mut before = 0.0;
    for leg in legs {
        // An error fades by Kp / Kd, 10 1/s at the least, so two seconds leave 2e-9 of it; then single precision rounds angles.
        let rest = (leg.error_at_rest - leg.error_of_weight).abs();
        assert!(rest < 2e-6, "{leg:?}");
        // The weight is all that disturbs it in earnest: acceleration adds its share on the way.
        let disturbed = [leg.error_of_weight, before].map(|error| error + 4e-3);
        assert!(disturbed.iter().any(|most| leg.error < *most), "{leg:?}");
        assert!(leg.effort < 1.0, "{leg:?}");
        before = leg.error_of_weight;
    }
    assert!(legs[1].error_of_weight > 0.01, "{:?}", legs[1]);
    assert_eq!(legs[5].error_of_weight, 0.0, "{:?}", legs[5]);
}

#[test]
fn the_arm_follows_its_path_as_nearly_as_its_payload_is_known() {
    let [known, mistaken] = [1.2, 1.0].map(|believed| {
        without_allocating(10_000, |calls| computed_torque::run(1.2, believed, calls))
    });
    // Sampling is all that is left: a torque that is held lags half a period behind what the motion needs.
    assert!(known.error < 1e-4, "{known:?}");
    assert!(
        mistaken.error < mistaken.bound + known.error,
        "{mistaken:?}"
    );
    assert!((2.25e-3..2.35e-3).contains(&mistaken.error), "{mistaken:?}");
    assert!(mistaken.error > 10.0 * known.error, "{mistaken:?}");
    for report in [known, mistaken] {
        assert!(report.effort < 1.0 && report.speed < 1.0, "{report:?}");
    }
}

#[test]
fn the_pole_is_swung_up_and_stays_up_though_its_mass_is_mistaken_by_a_fifth() {
    for mass in [0.5, 0.6, 0.4] {
        let report = without_allocating(12_000, |calls| swing_up::run(mass, 0.5, calls));
        // It hangs at first.
        assert!((2.5..4.5).contains(&report.upright_from), "{report:?}");
        // The slowest motion fades by about 4 1/s, and has had five seconds: less than 1e-8 is left of it.
        assert!(report.angle < 1e-5 && report.position < 1e-5, "{report:?}");
        assert!(report.travel < 2.0 && report.force < 50.0, "{report:?}");
    }
}

#[test]
fn the_hub_is_turned_without_angular_momentum() {
    let turn = [0.5_f64, -0.3, 0.6];
    let angle = turn.iter().map(|x| x * x).sum::<f64>().sqrt();
    let report = without_allocating(48_000, |calls| reorientation::run(turn, 1e-3, 20, calls));
    assert!(report.error < 4e-4, "{report:?}");
    assert!((report.turn - angle).abs() < 1e-3, "{report:?}");
    assert!(report.joint_error < 2e-3, "{report:?}");
    // Nothing acts from outside: what there is comes from integration, where joints alone have up to 12 kg m²/s.
    assert!(report.momentum < 1e-7, "{report:?}");
}

#[test]
fn the_hand_presses_as_strongly_as_asked_and_its_elbow_is_quiet() {
    let [known, mistaken] = [20e3, 16e3]
        .map(|believed| without_allocating(10_500, |calls| impedance::run(20e3, believed, calls)));
    assert!(known.force_error < 1e-4, "{known:?}");
    // Of two springs in a row, the softer one decides: a wall that is a quarter stiffer than believed changes little.
    assert!(mistaken.force_error < 1e-2, "{mistaken:?}");
    assert!(mistaken.force_error > 5e-3, "{mistaken:?}");
    for report in [known, mistaken] {
        assert!(report.position_error < 1e-6, "{report:?}");
        assert!(report.null_speed < 0.1, "{report:?}");
        assert!(report.null_speed_at_rest < 1e-5, "{report:?}");
        assert!(report.impact < 25.0 && report.effort < 1.0, "{report:?}");
    }
}

#[test]
fn the_arm_feels_collisions_and_nothing_else() {
    let (mut times, mut report) = (CallTimes::default(), None);
    let allocations = measure(|| report = Some(collision::run(&mut times)));
    let report = report.expect("the run has ended");
    assert_eq!(allocations.count_total, 0);
    assert!(report.duration > 59.99, "{report:?}");
    assert_eq!(report.false_alarms, 0, "{report:?}");
    assert!(report.quiet > 0.3, "there is noise: {report:?}");
    assert!(report.collisions > 1000, "{report:?}");
    assert!(report.delay <= 0.02, "{report:?}");
}

#[test]
fn the_robot_that_is_pushed_keeps_its_feet_and_comes_back() {
    for force in [[20.0, 0.0, 0.0], [0.0, 15.0, 0.0], [-15.0, -12.0, 0.0]] {
        let (mut times, mut report) = (balance::Times::default(), None);
        let mut controller = balance::Controller::new(&balance::posture());
        // The solver allocates in each call; nothing else does.
        let allocations = measure(|| {
            report = Some(balance::run(force, &mut controller, &mut times, |solve| {
                opt_out(solve);
            }));
        });
        let report = report.expect("the run has ended");
        assert_eq!(allocations.count_total, 0);
        assert_eq!((times.program.calls(), times.rest.calls()), (3000, 3000));
        assert_eq!(report.failures, 0, "{report:?}");
        assert!(report.iterations < 20, "{report:?}");

        // It is pushed in earnest: forces reach the pyramids' faces, and go as far beyond as the solver may err.
        assert!(report.displacement > 0.02, "{report:?}");
        assert!(report.pyramid > 0.999, "{report:?}");
        assert!(report.pyramid < 1.0 + 1e-6, "{report:?}");
        assert!(report.torque < 2.5 + 1e-6, "{report:?}");

        // The ground is no rigid one, so that its forces are not quite those chosen; an edge of the pyramid is at 0.875 of the cone.
        assert!(report.friction < 1.0, "{report:?}");
        assert!(report.slip < 1e-9, "{report:?}");
        assert!(report.least_force > 0.2, "{report:?}");

        assert!(report.displacement < 0.1, "{report:?}");
        assert!(report.turn < 0.2, "{report:?}");
        // Nothing of the push is left after 2.5 s at 15 1/s. What is left is the price of forces in the program, for which it bears
        // the weight but for 2.5e-4 of it: at 225 1/s², 0.011 mm too low.
        assert!(report.displacement_at_rest < 2e-5, "{report:?}");
        assert!(report.turn_at_rest < 2e-5, "{report:?}");
    }
}

#[test]
fn the_robot_that_is_pushed_too_hard_loses_its_feet_and_the_report_says_so() {
    let mut controller = balance::Controller::new(&balance::posture());
    let mut times = balance::Times::default();
    let report = balance::run([0.0, 40.0, 0.0], &mut controller, &mut times, |solve| {
        solve();
    });
    assert_eq!(report.least_force, 0.0, "{report:?}");
    assert!(report.slip > 1e-3 && report.failures > 0, "{report:?}");
    assert!(report.displacement_at_rest > 0.1, "{report:?}");
}

#[test]
fn the_arm_learns_what_it_carries_and_follows_its_path_by_that() {
    for seed in 1..4 {
        let laps = without_allocating(50_000, |calls| identification::run(seed, calls)).laps;
        for (lap, first) in laps.iter().zip([true, false, true, false, false]) {
            assert!(lap.effort < 1.0, "{lap:?}");
            // The noise of sums is nearly normal: ten parameters miss by what the filter believes they may, 500 times a lap.
            assert!(lap.deviations < 5.0, "{lap:?}");
            assert!(lap.deviations > 0.5, "there is noise: {lap:?}");
            // A torque of the wrist is measured within 0.12 N m, as much as 0.4 kg weigh at a lever of 30 mm; 5 s are 5000 times,
            // of which not all tell of the same. Whether the arm then moves or rests, the estimate stays.
            let (mass, center) = if first { (0.015, 8e-3) } else { (0.01, 3e-3) };
            assert!(lap.mass_error < mass, "{lap:?}");
            assert!(lap.center_error < center, "{lap:?}");
        }
        let [drill, drill_known, cup, cup_known, cup_at_rest] = laps.map(|lap| lap.error);
        assert!(drill > 0.03 && cup > 5e-3, "{laps:?}");
        assert!(drill_known < drill / 100.0, "{laps:?}");
        assert!(cup_known < cup / 15.0, "{laps:?}");
        assert!(cup_at_rest < cup_known, "{laps:?}");
    }
}
