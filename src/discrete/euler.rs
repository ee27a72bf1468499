//! The semi-implicit Euler step: speeds move by the accelerations before the step, coordinates by the speeds after it.
//!
//! `u' = u + dt u_dot(q, u, tau)`, `q' = q_plus(q, dt u')`. It is of first order. Where the mass matrix is constant and forces depend on `q`
//! alone, the energy of a system without losses does not drift over long times. Elsewhere it does: forces from speeds, Coriolis and
//! gyroscopic ones too, are those before the step. For long motions without losses take [`rk4`](super::rk4), or short steps.

use super::derivatives::{Change, StepByParameters, StepDerivatives, Variable};
use super::products::{self, At};
use super::reached::{Reached, move_on};
use crate::functions::{
    ForwardDynamics, ForwardDynamicsAndDerivatives, ForwardDynamicsByParameters,
    ForwardDynamicsJvp, ForwardDynamicsParametersJvp, ForwardDynamicsParametersVjp,
    ForwardDynamicsVjp,
};
use crate::vector::{add_identity, plus, plus_scaled, scale_rows, scaled, set_scaled_rows, zero};
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

/// Turns changes of accelerations, a column for each entry of a variable, into those of the speeds, and writes those of the coordinates.
fn change_rows<R: Real, S: System<R>, Row: Array<R>, M: Array<Row>>(
    moving: &Reached<R, S>,
    dt: R,
    variable: Variable,
    of_q: &mut M,
    of_u: &mut M,
) {
    scale_rows(of_u, dt);
    if variable == Variable::U {
        add_identity(of_u);
    }
    set_scaled_rows(of_q, dt, of_u);
    moving.change_rows(variable, of_q);
}

/// Like [`step`], and also gives its derivatives at the state before it.
pub fn linearized<R: Real, S: ForwardDynamicsAndDerivatives<R>>(
    system: &S,
    tau: &S::U,
    dt: R,
    state: (&mut S::Q, &mut S::U),
    derivatives: &mut StepDerivatives<S::Matrix>,
) {
    let _ = linearized_by(system, tau, dt, state, derivatives);
}

/// Like [`linearized`]; gives the way to the coordinates after the step.
fn linearized_by<R: Real, S: ForwardDynamicsAndDerivatives<R>>(
    system: &S,
    tau: &S::U,
    dt: R,
    (q, u): (&mut S::Q, &mut S::U),
    derivatives: &mut StepDerivatives<S::Matrix>,
) -> Reached<R, S> {
    let mut u_dot = zero();
    system.forward_dynamics_and_d_forward_dynamics_d_q_u_tau(
        q,
        u,
        tau,
        &mut u_dot,
        &mut derivatives.u_by_q,
        &mut derivatives.u_by_u,
        &mut derivatives.u_by_tau,
    );
    let moving = Reached::by(&moved(system, dt, q, u, &u_dot));
    for (variable, of_q, of_u) in derivatives.by_variable() {
        change_rows(&moving, dt, variable, of_q, of_u);
    }
    moving
}

/// [`linearized`] and [`by_parameters`], without the evaluation of the dynamics that the second needs alone.
pub fn linearized_and_by_parameters<
    R: Real,
    S: ForwardDynamicsAndDerivatives<R> + ForwardDynamicsByParameters<R>,
>(
    system: &S,
    tau: &S::U,
    dt: R,
    (q, u): (&mut S::Q, &mut S::U),
    (derivatives, by_parameters): (
        &mut StepDerivatives<S::Matrix>,
        &mut StepByParameters<S::ByParameters>,
    ),
) {
    let StepByParameters { q: of_q, u: of_u } = by_parameters;
    system.d_forward_dynamics_d_parameters(q, u, tau, of_u);
    let moving = linearized_by(system, tau, dt, (q, u), derivatives);
    change_rows(&moving, dt, Variable::Other, of_q, of_u);
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
    let StepByParameters { q: of_q, u: of_u } = derivatives;
    system.forward_dynamics(&q, &u, tau, &mut u_dot);
    system.d_forward_dynamics_d_parameters(&q, &u, tau, of_u);
    let moving = Reached::<R, S>::by(&moved(system, dt, &mut q, &mut u, &u_dot));
    change_rows(&moving, dt, Variable::Other, of_q, of_u);
}

/// Like [`step`], and also turns `change`, a change of the state before the step, into that after it, if `tau` changes by `tau_change`.
pub fn forward<R: Real, S: ForwardDynamics<R> + ForwardDynamicsJvp<R>>(
    system: &S,
    tau: &S::U,
    dt: R,
    state: (&mut S::Q, &mut S::U),
    (change, tau_change): (&mut Change<S::U>, &S::U),
) {
    let along = products::along(system, tau_change);
    forward_by(system, tau, dt, state, change, along);
}

/// Like [`forward`], if the values set at run time change too, by `parameters_change`.
pub fn forward_with_parameters<R: Real, S: ForwardDynamics<R> + ForwardDynamicsParametersJvp<R>>(
    system: &S,
    tau: &S::U,
    dt: R,
    state: (&mut S::Q, &mut S::U),
    (change, tau_change, parameters_change): (&mut Change<S::U>, &S::U, &S::Values),
) {
    let along = products::along_with_parameters(system, tau_change, parameters_change);
    forward_by(system, tau, dt, state, change, along);
}

/// The accelerations change with the state as `along` tells.
fn forward_by<R: Real, S: ForwardDynamics<R>>(
    system: &S,
    tau: &S::U,
    dt: R,
    (q, u): (&mut S::Q, &mut S::U),
    change: &mut Change<S::U>,
    along: impl Fn(At<'_, R, S>, &Change<S::U>) -> S::U,
) {
    let mut u_dot = zero();
    system.forward_dynamics(q, u, tau, &mut u_dot);
    let du_dot = along((q, u, tau), change);
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
    state: (&S::Q, &S::U),
    (multiplier, tau_gradient): (&mut Change<S::U>, &mut S::U),
) {
    let back = products::back(system, tau_gradient);
    adjoint_by(system, tau, dt, state, multiplier, back);
}

/// Like [`adjoint`]; also overwrites `parameters_gradient` with that of all values set at run time: `multiplier` times the derivatives of
/// [`by_parameters`].
pub fn adjoint_with_parameters<R: Real, S: ForwardDynamics<R> + ForwardDynamicsParametersVjp<R>>(
    system: &S,
    tau: &S::U,
    dt: R,
    state: (&S::Q, &S::U),
    (multiplier, tau_gradient, parameters_gradient): (&mut Change<S::U>, &mut S::U, &mut S::Values),
) {
    let back = products::back_with_parameters(system, tau_gradient, parameters_gradient);
    adjoint_by(system, tau, dt, state, multiplier, back);
}

/// `back` tells the gradient of the accelerations by the state.
fn adjoint_by<R: Real, S: ForwardDynamics<R>>(
    system: &S,
    tau: &S::U,
    dt: R,
    (q, u): (&S::Q, &S::U),
    multiplier: &mut Change<S::U>,
    mut back: impl FnMut(At<'_, R, S>, &S::U) -> Change<S::U>,
) {
    let mut u_dot = zero();
    system.forward_dynamics(q, u, tau, &mut u_dot);
    let direction = moved(system, dt, &mut { *q }, &mut { *u }, &u_dot);
    let (of_q, of_direction) = Reached::<R, S>::by(&direction).back(&multiplier.q);
    let of_u = plus_scaled(&multiplier.u, dt, &of_direction);
    let own = back((q, u, tau), &scaled(dt, &of_u));
    multiplier.q = plus(&of_q, &own.q);
    multiplier.u = plus(&of_u, &own.u);
}
