//! Simulation to a tolerance: closed forms are met, tolerances obeyed, failures named.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test stops where it cannot go on"
)]

use std::cell::Cell;

use crate::common::{CartPole, Oscillator, Pendulum, Turning, arrays};
use kane::functions::{ForwardDynamics, KineticEnergy, PotentialEnergy};
use kane::simulate::{Sample, SimulateError, Tolerance, simulate};
use kane::{Real, System};
use kane_test_support::compare::{assert_within, largest};

fn tolerance(relative: f64) -> Tolerance {
    Tolerance {
        relative,
        absolute: relative,
        ..Tolerance::default()
    }
}

/// The largest error of an oscillator after each of ten swings and a bit, and how often the law was called.
fn oscillator_error(relative: f64) -> (f64, usize) {
    let system = Oscillator { stiffness: 1.0 };
    let times: Vec<f64> = (0..=10).map(|i| f64::from(i) * 6.5).collect();
    let calls = Cell::new(0);
    let law = |_: f64, _: &[f64; 1], _: &[f64; 1], _: &mut [f64; 1]| calls.set(calls.get() + 1);
    let samples = simulate(&system, &[1.0], &[0.0], law, &times, &tolerance(relative)).unwrap();
    assert_eq!(
        samples.iter().map(|sample| sample.t).collect::<Vec<_>>(),
        times
    );
    let error = |sample: &Sample<[f64; 1], [f64; 1]>| {
        let (sine, cosine) = <f64 as Real>::sin_cos(sample.t);
        (sample.q[0] - cosine).hypot(sample.u[0] + sine)
    };
    (
        largest(&samples.iter().map(error).collect::<Vec<_>>()),
        calls.get(),
    )
}

#[test]
fn errors_and_work_follow_the_tolerance() {
    // Errors of steps add up: over ten swings a hundred times the local tolerance at most.
    let mut before = (f64::INFINITY, 0);
    for relative in [1e-4, 1e-6, 1e-8, 1e-10, 1e-12] {
        let (error, calls) = oscillator_error(relative);
        assert!(error < 100.0 * relative, "{error:e} at {relative:e}");
        assert!(
            error < 0.3 * before.0,
            "{error:e} at {relative:e}, {:e} before",
            before.0
        );
        assert!(
            calls > before.1 && calls < 5000,
            "{calls} calls at {relative:e}"
        );
        before = (error, calls);
    }
}

#[test]
fn a_pendulum_is_back_after_its_period() {
    let system = Pendulum { gravity: 9.81 };
    let amplitude = 2.5;
    let period = system.period(amplitude);
    let times = [0.0, period / 2.0, period];
    let samples = simulate(
        &system,
        &[amplitude],
        &[0.0],
        |_, _, _, _| {},
        &times,
        &tolerance(1e-12),
    )
    .unwrap();
    for (sample, expected) in samples.iter().zip([amplitude, -amplitude, amplitude]) {
        assert!(
            (sample.q[0] - expected).abs() < 1e-9 && sample.u[0].abs() < 1e-9,
            "{sample:?}"
        );
    }
}

#[test]
fn energy_and_momentum_of_a_cart_pole_are_kept() {
    let system = CartPole {
        mass: 0.4,
        gravity: 9.81,
    };
    let times: Vec<f64> = (0..=50).map(|i| f64::from(i) * 0.1).collect();
    let samples = simulate(
        &system,
        &[0.0, 2.0],
        &[0.5, -1.0],
        |_, _, _, _| {},
        &times,
        &tolerance(1e-11),
    )
    .unwrap();
    let invariants = |q: &[f64; 2], u: &[f64; 2]| {
        let (mut kinetic, mut potential) = (0.0, 0.0);
        system.kinetic_energy(q, u, &mut kinetic);
        system.potential_energy(q, &mut potential);
        let momentum = 1.4 * u[0] + 0.4 * <f64 as Real>::sin_cos(q[1]).1 * u[1];
        [kinetic + potential, momentum]
    };
    let start = invariants(&samples[0].q, &samples[0].u);
    for sample in &samples {
        for (now, then) in invariants(&sample.q, &sample.u).into_iter().zip(start) {
            assert!((now - then).abs() < 1e-8, "{now} {then} at {} s", sample.t);
        }
    }
}

#[test]
fn the_law_sees_the_time_and_the_state() {
    // q'' = cos(t) - q' from rest: q' = (sin t + cos t - exp(-t)) / 2.
    let system = Oscillator { stiffness: 0.0 };
    let law = |t: f64, _: &[f64; 1], u: &[f64; 1], tau: &mut [f64; 1]| {
        tau[0] = <f64 as Real>::sin_cos(t).1 - u[0];
    };
    let times = [2.0, 3.0, 3.5, 7.0];
    let (sine, cosine) = <f64 as Real>::sin_cos(2.0);
    let speed = |t: f64| {
        let (s, c) = <f64 as Real>::sin_cos(t);
        (s + c - (sine + cosine) * (2.0 - t).exp()) / 2.0
    };
    let samples = simulate(&system, &[0.0], &[0.0], law, &times, &tolerance(1e-11)).unwrap();
    for sample in samples {
        assert!((sample.u[0] - speed(sample.t)).abs() < 1e-9, "{sample:?}");
    }
}

#[test]
fn a_system_at_rest_stays_at_rest() {
    let system = Pendulum { gravity: 9.81 };
    let times = [0.0, 1e-9, 1.0, 1e6];
    let samples = simulate(
        &system,
        &[0.0],
        &[0.0],
        |_, _, _, _| {},
        &times,
        &Tolerance::default(),
    )
    .unwrap();
    assert_eq!(samples.len(), 4);
    assert!(
        samples
            .iter()
            .all(|sample| sample.q == [0.0] && sample.u == [0.0])
    );
}

#[test]
fn times_far_from_zero_are_reached() {
    let system = Oscillator { stiffness: 1.0 };
    let start = 1e6;
    let times: Vec<f64> = (0..=100).map(|i| start + f64::from(i) * 0.1).collect();
    let samples = simulate(
        &system,
        &[1.0],
        &[0.0],
        |_, _, _, _| {},
        &times,
        &tolerance(1e-10),
    )
    .unwrap();
    for sample in samples {
        let cosine = <f64 as Real>::sin_cos(sample.t - start).1;
        assert!((sample.q[0] - cosine).abs() < 1e-8, "{sample:?}");
    }
}

#[test]
fn close_times_do_not_slow_the_steps_after_them() {
    let system = Oscillator { stiffness: 1.0 };
    let calls = Cell::new(0);
    let law = |_: f64, _: &[f64; 1], _: &[f64; 1], _: &mut [f64; 1]| calls.set(calls.get() + 1);
    let work = |times: &[f64]| {
        calls.set(0);
        simulate(&system, &[1.0], &[0.0], law, times, &Tolerance::default()).unwrap();
        calls.get()
    };
    let (alone, with_close) = (work(&[0.0, 50.0]), work(&[0.0, 25.0, 25.0 + 1e-12, 50.0]));
    assert!(
        with_close < alone + 100,
        "{with_close} calls, {alone} without"
    );
}

/// A slider of 1000 m/s, from zero at the first of these times: how far it is from where it should be at most, in roundings of that place.
fn slider_error(times: &[f64]) -> f64 {
    let system = Oscillator { stiffness: 0.0 };
    let tolerance = Tolerance::default();
    let samples = simulate(&system, &[0.0], &[1e3], |_, _, _, _| {}, times, &tolerance).unwrap();
    assert_eq!(samples.len(), times.len());
    let error = |sample: &Sample<[f64; 1], [f64; 1]>| {
        let expected = 1e3 * (sample.t - times[0]);
        // Where time itself is rounded, the place is as well.
        let rounding = f64::EPSILON * (expected.abs() + 1e3 * sample.t.abs());
        (sample.q[0] - expected) / (rounding + f64::MIN_POSITIVE)
    };
    largest(&samples.iter().map(error).collect::<Vec<_>>())
}

#[test]
fn close_times_have_their_own_states_however_late_the_last_is() {
    for times in [
        &[0.0, 1e-12, 1e4][..],
        &[0.0, 1e-300, 1e-20, 1e-12, 2e-12, 1.0, 1e9],
        // After long steps, and before a time near zero.
        &[0.0, 1e4, 1e4 + 2e-11, 1e4 + 4e-11, 2e4],
        &[-1e4, 1e-20, 1e-12, 1e4],
    ] {
        let error = slider_error(times);
        assert!(error < 20.0, "{error} roundings at {times:?}");
    }
}

#[test]
fn times_too_close_for_the_integrator_after_a_long_step_have_their_own_states() {
    let system = Oscillator { stiffness: 0.0 };
    let times = [0.0, 1e4, 1e4 + 2e-11, 1e4 + 4e-11];
    let law = |_: f64, _: &[f64; 1], _: &[f64; 1], _: &mut [f64; 1]| {};
    let samples = simulate(&system, &[0.0], &[1e3], law, &times, &Tolerance::default()).unwrap();
    for ends in samples[1..].windows(2) {
        let (way, time) = (ends[1].q[0] - ends[0].q[0], ends[1].t - ends[0].t);
        // Neighbouring numbers are 1.9e-9 apart there.
        assert_within(ends[1].t, way - 1e3 * time, 2e-9);
    }
}

/// A system that cannot move.
struct Fixed;

impl System<f64> for Fixed {
    arrays!(f64; 0, 0, 0);

    const NAME: &'static str = "fixed";
    const BODY_NAMES: &'static [&'static str] = &[];
    const COORDINATE_NAMES: &'static [&'static str] = &[];
    const SPEED_NAMES: &'static [&'static str] = &[];
    const LOWER_BODIES: &'static [usize] = &[];
    const SPEED_BODIES: &'static [usize] = &[];

    fn q_dot(&self, _: &[f64; 0], _: &[f64; 0], _: &mut [f64; 0]) {}
}

impl ForwardDynamics<f64> for Fixed {
    fn forward_dynamics(&self, _: &[f64; 0], _: &[f64; 0], _: &[f64; 0], _: &mut [f64; 0]) {}
}

#[test]
fn a_system_without_coordinates_has_a_sample_at_each_time() {
    let times = [0.0, 1.0, 2.5];
    let tolerance = Tolerance::default();
    let samples = simulate(&Fixed, &[], &[], |_, _, _, _| {}, &times, &tolerance).unwrap();
    assert_eq!(samples, times.map(|t| Sample { t, q: [], u: [] }));
}

#[test]
fn no_times_and_one_time_need_no_integration() {
    let system = Pendulum { gravity: 9.81 };
    let run = |times: &[f64]| {
        simulate(
            &system,
            &[0.1],
            &[0.2],
            |_, _, _, _| {},
            times,
            &Tolerance::default(),
        )
        .unwrap()
    };
    assert!(run(&[]).is_empty());
    let one = run(&[5.0]);
    assert_eq!(
        (one.len(), one[0].t, one[0].q, one[0].u),
        (1, 5.0, [0.1], [0.2])
    );
}

fn failure(times: &[f64], tolerance: Tolerance, stiffness: f64) -> SimulateError {
    let system = Oscillator { stiffness };
    simulate(&system, &[1.0], &[0.0], |_, _, _, _| {}, times, &tolerance).unwrap_err()
}

#[test]
fn times_that_do_not_increase_are_refused() {
    let sound = Tolerance::default();
    let error = failure(&[0.0, 1.0, 1.0], sound, 1.0);
    assert_eq!(error, SimulateError::Times { index: 2, t: 1.0 });
    assert_eq!(
        error.to_string(),
        "times[2] is 1 s, a finite time above the one before is required"
    );
    assert!(matches!(
        failure(&[0.0, f64::NAN], sound, 1.0),
        SimulateError::Times { index: 1, .. }
    ));
    assert!(matches!(
        failure(&[f64::NEG_INFINITY], sound, 1.0),
        SimulateError::Times { index: 0, .. }
    ));
    assert!(matches!(
        failure(&[0.0, f64::INFINITY], sound, 1.0),
        SimulateError::Times { index: 1, .. }
    ));
}

#[test]
fn tolerances_that_cannot_be_met_are_refused() {
    for value in [0.0, -1e-9, f64::NAN, f64::INFINITY] {
        let error = failure(
            &[0.0, 1.0],
            Tolerance {
                relative: value,
                ..Tolerance::default()
            },
            1.0,
        );
        assert!(matches!(error, SimulateError::Tolerance { .. }), "{error}");
        let error = failure(
            &[0.0, 1.0],
            Tolerance {
                absolute: value,
                ..Tolerance::default()
            },
            1.0,
        );
        assert!(matches!(error, SimulateError::Tolerance { .. }), "{error}");
    }
}

#[test]
fn too_few_steps_are_reported_with_the_time_reached() {
    let error = failure(
        &[0.0, 100.0],
        Tolerance {
            max_steps: 10,
            ..Tolerance::default()
        },
        1.0,
    );
    let SimulateError::MaxSteps { t, max_steps: 10 } = error else {
        panic!("{error:?}")
    };
    assert!(t > 0.0 && t < 100.0, "{t}");
}

#[test]
fn a_control_law_may_keep_a_state_of_its_own() {
    let system = Oscillator { stiffness: 1.0 };
    let mut calls = 0;
    let law = |_: f64, _: &[f64; 1], _: &[f64; 1], _: &mut [f64; 1]| calls += 1;
    simulate(
        &system,
        &[1.0],
        &[0.0],
        law,
        &[0.0, 1.0],
        &Tolerance::default(),
    )
    .unwrap();
    // Twelve stages a step.
    assert!(calls > 12, "{calls}");
}

#[test]
fn a_motion_that_is_not_finite_is_reported() {
    assert_eq!(
        failure(&[3.0, 4.0], Tolerance::default(), f64::NAN),
        SimulateError::NotFinite { t: 3.0 }
    );
    assert_eq!(
        failure(&[3.0], Tolerance::default(), f64::NAN),
        SimulateError::NotFinite { t: 3.0 }
    );
    // From 1 s on the law gives NaN: the step shrinks until it cannot.
    let system = Oscillator { stiffness: 1.0 };
    let law = |t: f64, _: &[f64; 1], _: &[f64; 1], tau: &mut [f64; 1]| {
        tau[0] = if t < 1.0 { 0.0 } else { f64::NAN };
    };
    let error = simulate(
        &system,
        &[1.0],
        &[0.0],
        law,
        &[0.0, 2.0],
        &Tolerance::default(),
    )
    .unwrap_err();
    let SimulateError::StepSize { t } = error else {
        panic!("{error:?}")
    };
    assert!((t - 1.0).abs() < 1e-9, "{t}");
}

#[test]
fn a_stiff_system_ends_in_an_error_or_in_the_right_place() {
    // A damper of 1e6/s: an explicit method crawls, and says so.
    let system = Oscillator { stiffness: 0.0 };
    let law = |_: f64, _: &[f64; 1], u: &[f64; 1], tau: &mut [f64; 1]| tau[0] = -1e6 * (u[0] - 1.0);
    let error =
        simulate(&system, &[0.0], &[1.0], law, &[0.0, 10.0], &tolerance(1e-6)).map(|end| end[1].q);
    match error {
        Ok(q) => assert!((q[0] - 10.0).abs() < 1e-4, "{q:?}"),
        Err(error) => assert!(matches!(
            error,
            SimulateError::Stiff { .. } | SimulateError::MaxSteps { .. }
        )),
    }
}

impl ForwardDynamics<f64> for Turning {
    fn forward_dynamics(&self, _: &[f64; 11], u: &[f64; 10], _: &[f64; 10], u_dot: &mut [f64; 10]) {
        // The floating body precesses.
        *u_dot = [0.0; 10];
        (u_dot[3], u_dot[5]) = (-u[4] * u[5], u[3] * u[4]);
    }
}

#[test]
fn quaternions_of_samples_have_length_one_whatever_the_tolerance() {
    let mut q = [0.0; 11];
    q[4] = 1.0;
    let mut u = [0.0; 10];
    (u[3], u[4], u[5]) = (0.3, 4.0, -0.2);
    let times = [0.0, 200.0, 4000.0];
    let samples = simulate(&Turning, &q, &u, |_, _, _, _| {}, &times, &tolerance(1e-3)).unwrap();
    for Sample { t, q, .. } in samples {
        let length = q[4..8].iter().map(|entry| entry * entry).sum::<f64>();
        assert!((length - 1.0).abs() < 1e-12, "{length} at {t} s");
    }
}
