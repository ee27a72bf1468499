//! The semi-implicit Euler step: speeds move by the accelerations before the step, coordinates by the speeds after it.
//!
//! `u' = u + dt u_dot(q, u, tau)`, `q' = q_plus(q, dt u')`. It is of first order. Where the mass matrix is constant and forces depend on `q`
//! alone, the energy of a system without losses does not drift over long times. Elsewhere it does: forces from speeds, Coriolis and
//! gyroscopic ones too, are those before the step. For long motions without losses take [`rk4`](super::rk4), or short steps.

use super::derivatives::{Change, StepByParameters, StepDerivatives, Variable};
use super::reached::{Reached, move_on};
use crate::functions::{
    ForwardDynamics, ForwardDynamicsAndDerivatives, ForwardDynamicsByParameters,
    ForwardDynamicsJvp, ForwardDynamicsVjp,
};
use crate::vector::{column, plus, plus_scaled, scaled, zero};
use crate::{Array, Real, System};

/// Advances `q` and `u` by `dt`, s, under forces `tau`, N m and N.
pub fn step<R: Real, S: ForwardDynamics<R>>(
    system: &S,
    tau: &S::U,
    dt: R,
    q: &mut S::Q,
    u: &mut S::U,
) {
    let mut u_dot = zero();
    system.forward_dynamics(q, u, tau, &mut u_dot);
    let _ = moved(system, dt, q, u, &u_dot);
}

/// Advances the state, and returns the direction by which `q` moved.
fn moved<R: Real, S: System<R>>(
    system: &S,
    dt: R,
    q: &mut S::Q,
    u: &mut S::U,
    u_dot: &S::U,
) -> S::U {
    *u = plus_scaled(u, dt, u_dot);
    let direction = scaled(dt, u);
    move_on(system, q, &direction);
    direction
}

/// The change after a step from that before it, if accelerations change by `u_dot`.
fn changed<R: Real, S: System<R>>(
    moving: &Reached<R, S>,
    dt: R,
    change: &Change<S::U>,
    u_dot: &S::U,
) -> Change<S::U> {
    let u = plus_scaled(&change.u, dt, u_dot);
    Change {
        q: moving.changed(&change.q, &scaled(dt, &u)),
        u,
    }
}

/// Like [`step`], and also gives its derivatives at the state before it.
pub fn linearized<R: Real, S: ForwardDynamicsAndDerivatives<R>>(
    system: &S,
    tau: &S::U,
    dt: R,
    (q, u): (&mut S::Q, &mut S::U),
    derivatives: &mut StepDerivatives<S::Matrix>,
) {
    let mut u_dot = zero();
    let [mut by_q, mut by_u, mut by_tau] = [S::Matrix::filled(zero()); 3];
    system.forward_dynamics_and_d_forward_dynamics_d_q_u_tau(
        q,
        u,
        tau,
        &mut u_dot,
        &mut by_q,
        &mut by_u,
        &mut by_tau,
    );
    let moving = Reached::<R, S>::by(&moved(system, dt, q, u, &u_dot));
    derivatives.set_columns(|variable, place| {
        let of_u_dot = match variable {
            Variable::Q => &by_q,
            Variable::U => &by_u,
            Variable::Tau => &by_tau,
        };
        let of_u_dot = column(of_u_dot, place);
        changed(&moving, dt, &variable.change(place), &of_u_dot)
    });
}

/// The derivatives of the state after the step by all values set at run time.
pub fn by_parameters<R: Real, S: ForwardDynamics<R> + ForwardDynamicsByParameters<R>>(
    system: &S,
    tau: &S::U,
    dt: R,
    (q, u): (&S::Q, &S::U),
    derivatives: &mut StepByParameters<S::ByParameters>,
) {
    let (mut u_dot, mut q, mut u) = (zero(), *q, *u);
    let mut by_values = S::ByParameters::filled(zero());
    system.forward_dynamics(&q, &u, tau, &mut u_dot);
    system.d_forward_dynamics_d_parameters(&q, &u, tau, &mut by_values);
    let moving = Reached::<R, S>::by(&moved(system, dt, &mut q, &mut u, &u_dot));
    derivatives.set_columns(|place| {
        let of_u_dot = column(&by_values, place);
        changed(&moving, dt, &Change::zero(), &of_u_dot)
    });
}

/// Like [`step`], and also turns `change`, a change of the state before the step, into that after it, if `tau` changes by `tau_change`.
pub fn forward<R: Real, S: ForwardDynamics<R> + ForwardDynamicsJvp<R>>(
    system: &S,
    tau: &S::U,
    dt: R,
    (q, u): (&mut S::Q, &mut S::U),
    (change, tau_change): (&mut Change<S::U>, &S::U),
) {
    let (mut u_dot, mut du_dot) = (zero(), zero());
    system.forward_dynamics(q, u, tau, &mut u_dot);
    system.jvp_forward_dynamics_q_u_tau(q, u, tau, &change.q, &change.u, tau_change, &mut du_dot);
    let moving = Reached::<R, S>::by(&moved(system, dt, q, u, &u_dot));
    *change = changed(&moving, dt, change, &du_dot);
}

/// Turns the multiplier of the state after the step into that of the state before it, `q`, `u`, and overwrites `tau_gradient` with that
/// of `tau`.
///
/// In terms of [`linearized`], the results are `multiplier · A` and `multiplier · B`.
pub fn adjoint<R: Real, S: ForwardDynamics<R> + ForwardDynamicsVjp<R>>(
    system: &S,
    tau: &S::U,
    dt: R,
    (q, u): (&S::Q, &S::U),
    (multiplier, tau_gradient): (&mut Change<S::U>, &mut S::U),
) {
    let mut u_dot = zero();
    system.forward_dynamics(q, u, tau, &mut u_dot);
    let direction = moved(system, dt, &mut { *q }, &mut { *u }, &u_dot);
    let (of_q, of_direction) = Reached::<R, S>::by(&direction).back(&multiplier.q);
    let of_u = plus_scaled(&multiplier.u, dt, &of_direction);
    let (mut q_gradient, mut u_gradient) = (zero(), zero());
    system.vjp_forward_dynamics_q_u_tau(
        q,
        u,
        tau,
        &scaled(dt, &of_u),
        &mut q_gradient,
        &mut u_gradient,
        tau_gradient,
    );
    multiplier.q = plus(&of_q, &q_gradient);
    multiplier.u = plus(&of_u, &u_gradient);
}
