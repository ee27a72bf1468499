//! The Runge-Kutta step: of fourth order, against closed forms and conserved energy.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test stops where it cannot go on"
)]

use crate::common::{CartPole, Oscillator, Pendulum};
use kane::Real;
use kane::functions::{ForwardDynamics, KineticEnergy, PotentialEnergy};
use kane::integrate::{rk4_step, rk4_step_with};

/// The state after `n` steps of `dt` without generalized forces.
fn run<S: ForwardDynamics<f64>>(system: &S, q: S::Q, u: S::U, dt: f64, n: usize) -> (S::Q, S::U) {
    let (mut q, mut u) = (q, u);
    for _ in 0..n {
        rk4_step_with(system, dt, &mut q, &mut u, |_, _, _| {});
    }
    (q, u)
}

fn energy<S: KineticEnergy<f64> + PotentialEnergy<f64>>(system: &S, (q, u): &(S::Q, S::U)) -> f64 {
    let (mut kinetic, mut potential) = (0.0, 0.0);
    system.kinetic_energy(q, u, &mut kinetic);
    system.potential_energy(q, &mut potential);
    kinetic + potential
}

/// By what power of the step the error falls when the step is halved.
fn order(error: impl Fn(i32) -> f64, n: i32) -> f64 {
    (error(n) / error(2 * n)).log2()
}

fn oscillator_error(n: i32) -> f64 {
    let system = Oscillator { stiffness: 4.0 };
    let (q, u) = run(
        &system,
        [1.0],
        [0.0],
        1.0 / f64::from(n),
        usize::try_from(n).unwrap(),
    );
    let (sine, cosine) = <f64 as Real>::sin_cos(2.0);
    (q[0] - cosine).hypot(u[0] / 2.0 + sine)
}

#[test]
fn error_of_an_oscillator_is_of_fourth_order() {
    let order = order(oscillator_error, 64);
    assert!((order - 4.0).abs() < 0.05, "order {order}");
}

#[test]
fn a_small_step_reaches_the_closed_form() {
    let error = oscillator_error(2000);
    assert!(error < 1e-12, "{error:e}");
}

#[test]
fn a_pendulum_is_back_after_its_period() {
    let system = Pendulum { gravity: 9.81 };
    let amplitude = 2.5;
    let period = system.period(amplitude);
    let error = |n: i32| {
        let steps = usize::try_from(n).unwrap();
        let (q, u) = run(&system, [amplitude], [0.0], period / f64::from(n), steps);
        (q[0] - amplitude).hypot(u[0])
    };
    assert!(error(4000) < 1e-8, "{:e}", error(4000));
    let order = order(error, 500);
    assert!((order - 4.0).abs() < 0.3, "order {order}");
}

#[test]
fn energy_of_a_cart_pole_drifts_with_the_fourth_power_or_better() {
    let system = CartPole {
        mass: 0.4,
        gravity: 9.81,
    };
    let start = ([0.0, 2.0], [0.5, -1.0]);
    let drift = |n: i32| {
        let end = run(
            &system,
            start.0,
            start.1,
            2.0 / f64::from(n),
            usize::try_from(n).unwrap(),
        );
        (energy(&system, &end) - energy(&system, &start)).abs()
    };
    assert!(drift(2000) < 1e-9, "{:e}", drift(2000));
    let order = order(drift, 250);
    assert!(order > 3.7, "order {order}");
}

#[test]
fn a_held_force_is_held_over_the_step() {
    // Without a spring the motion is a parabola, which the method integrates exactly.
    let system = Oscillator { stiffness: 0.0 };
    let (mut q, mut u) = ([1.0], [2.0]);
    rk4_step(&system, &[6.0], 0.5, &mut q, &mut u);
    assert!(
        (q[0] - 2.75).abs() < 1e-15 && (u[0] - 5.0).abs() < 1e-15,
        "{q:?} {u:?}"
    );
}

#[test]
fn a_law_of_the_state_is_called_at_every_stage() {
    // A spring in the law instead of the system: the same equation, so nearly the same bits.
    let (mut q, mut u) = ([1.0], [0.0]);
    let mut calls = 0;
    let free = Oscillator { stiffness: 0.0 };
    rk4_step_with(&free, 0.1, &mut q, &mut u, |q, _, tau| {
        calls += 1;
        assert_eq!(*tau, [0.0]);
        tau[0] = -4.0 * q[0];
    });
    let (expected_q, expected_u) = run(&Oscillator { stiffness: 4.0 }, [1.0], [0.0], 0.1, 1);
    assert_eq!(calls, 4);
    assert!((q[0] - expected_q[0]).abs() < 1e-15 && (u[0] - expected_u[0]).abs() < 1e-15);
}

#[test]
fn single_precision_steps_too() {
    let system = Oscillator { stiffness: 4.0_f32 };
    let (mut q, mut u) = ([1.0_f32], [0.0_f32]);
    for _ in 0..100 {
        rk4_step(&system, &[0.0], 0.01, &mut q, &mut u);
    }
    let (sine, cosine) = <f32 as Real>::sin_cos(2.0);
    assert!(
        (q[0] - cosine).abs() < 2e-6 && (u[0] + 2.0 * sine).abs() < 4e-6,
        "{q:?} {u:?}"
    );
}
