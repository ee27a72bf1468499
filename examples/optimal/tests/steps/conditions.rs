//! Steps of systems under conditions: with loads, and with joints that something drives.

use kane::Load;
use kane::conditions::{Driven, Loaded};
use kane::functions::{ForwardDynamics, GeneralizedForces, HybridDynamics, InverseDynamics};
use kane_optimal::tumbler;

use super::scheme::{self, Scheme};
use super::{ROUNDED, all_derivatives_are_differences, drawn};
use kane_test_support::{compare::assert_close, random::Random};

/// Loads on all bodies that accelerate them about as much as `tau` of [`drawn`] does.
fn loads() -> [Load<f64>; tumbler::NB] {
    let mut random = Random::new(21);
    std::array::from_fn(|_| {
        let mut three = |size: f64| std::array::from_fn(|_| size * random.symmetric());
        Load {
            force: three(0.5),
            moment: three(0.1),
        }
    })
}

#[test]
fn steps_under_loads_have_derivatives_as_all_have() {
    let system = &tumbler::Prepared::<f64>::nominal();
    let loads = loads();
    let pushed = Loaded { system, loads };
    for dt in [1e-4, 0.02, 0.2] {
        all_derivatives_are_differences(&pushed, &drawn(&pushed, 22, 0.3, dt));
    }
}

#[test]
fn loads_act_as_their_generalized_forces_do() {
    let system = &tumbler::Prepared::<f64>::nominal();
    let loads = loads();
    let pushed = Loaded { system, loads };
    let at = drawn(system, 23, 0.3, 0.02);
    let mut of_loads = [f64::NAN; tumbler::NU];
    system.generalized_forces(&at.q, &loads, &mut of_loads);
    let tau = std::array::from_fn(|i| at.tau[i] + of_loads[i]);
    // Which the step asks for at its first state alone.
    let plain = Scheme::Euler.step(system, &scheme::Driven { tau, ..at });
    let found = Scheme::Euler.step(&pushed, &at);
    assert_close("q", &found.0, &plain.0, ROUNDED);
    assert_close("u", &found.1, &plain.1, ROUNDED);
    let (mut u_dot, mut back) = ([f64::NAN; tumbler::NU], [f64::NAN; tumbler::NU]);
    pushed.forward_dynamics(&at.q, &at.u, &at.tau, &mut u_dot);
    pushed.inverse_dynamics(&at.q, &at.u, &u_dot, &mut back);
    assert_close("tau", &back, &at.tau, ROUNDED);
}

#[test]
fn steps_with_driven_joints_have_derivatives_as_all_have() {
    let system = &tumbler::Prepared::<f64>::nominal();
    let u_dot = [1.5; tumbler::NU];
    let driven = Driven { system, u_dot };
    for dt in [1e-4, 0.02, 0.2] {
        all_derivatives_are_differences(&driven, &drawn(&driven, 25, 0.3, dt));
    }
}

#[test]
fn driven_joints_move_as_they_are_told() {
    let system = &tumbler::Prepared::<f64>::nominal();
    let prescribed = <tumbler::Prepared<f64> as HybridDynamics<f64>>::PRESCRIBED;
    let is_tail = |speed: usize| speed == tumbler::NU - 1;
    assert!((0..tumbler::NU).all(|speed| prescribed[speed] == is_tail(speed)));
    let u_dot = [1.5; tumbler::NU];
    let driven = Driven { system, u_dot };
    let at = drawn(&driven, 24, 0.3, 0.02);
    for scheme in Scheme::ALL {
        let (_, u) = scheme.step(&driven, &at);
        let last = tumbler::NU - 1;
        assert_close("speed", &[u[last]], &[at.u[last] + 1.5 * at.dt], ROUNDED);
    }
    // With the force that the drive needs, the system moves alike.
    let (mut whole_u_dot, mut whole_tau) = ([f64::NAN; tumbler::NU], [f64::NAN; tumbler::NU]);
    system.hybrid_dynamics(
        &at.q,
        &at.u,
        &u_dot,
        &at.tau,
        &mut whole_u_dot,
        &mut whole_tau,
    );
    let tau = whole_tau;
    let free = Scheme::Euler.step(system, &scheme::Driven { tau, ..at });
    let found = Scheme::Euler.step(&driven, &at);
    assert_close("q", &found.0, &free.0, ROUNDED);
    assert_close("u", &found.1, &free.1, ROUNDED);
}

#[test]
fn loads_on_a_driven_system_are_forces_at_the_state() {
    let system = &tumbler::Prepared::<f64>::nominal();
    let (loads, u_dot) = (loads(), [1.5; tumbler::NU]);
    let at = drawn(system, 26, 0.3, 0.02);
    let mut of_loads = [f64::NAN; tumbler::NU];
    system.generalized_forces(&at.q, &loads, &mut of_loads);
    let tau = std::array::from_fn(|i| at.tau[i] + of_loads[i]);
    let (mut found, mut back) = ([f64::NAN; tumbler::NU], [f64::NAN; tumbler::NU]);
    Driven { system, u_dot }.forward_dynamics(&at.q, &at.u, &tau, &mut found);
    Loaded { system, loads }.inverse_dynamics(&at.q, &at.u, &found, &mut back);
    // The last speed is driven.
    let free = tumbler::NU - 1;
    assert_close("tau", &back[..free], &at.tau[..free], ROUNDED);
    assert_close("u_dot", &found[free..], &u_dot[free..], ROUNDED);
}
