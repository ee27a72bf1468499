//! The semi-implicit Euler step: speeds by the accelerations before the step, coordinates by the speeds after it.
//!
//! `u' = u + dt u_dot(q, u, tau)`, `q' = q_plus(q, dt u')`. Of first order, and of a system without losses the energy does not
//! drift over long times.

use super::derivatives::{Change, StepByParameters, StepDerivatives};
use super::vector::{column, plus, plus_scaled, scaled, set_column, unit, zero};
use crate::functions::{
    ForwardDynamics, ForwardDynamicsAndDerivatives, ForwardDynamicsByParameters,
    ForwardDynamicsJvp, ForwardDynamicsVjp,
};
use crate::manifold::{TangentMap, q_plus};
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

/// Moves the state on, and returns by which direction `q`.
fn moved<R: Real, S: System<R>>(
    system: &S,
    dt: R,
    q: &mut S::Q,
    u: &mut S::U,
    u_dot: &S::U,
) -> S::U {
    *u = plus_scaled(u, dt, u_dot);
    let direction = scaled(dt, u);
    *q = q_plus(system, q, &direction);
    system.normalize(q);
    direction
}

/// How the coordinates after a step change.
struct Moving<R: Real, S: System<R>> {
    dt: R,
    by_q: TangentMap<R, S>,
    by_direction: TangentMap<R, S>,
}

impl<R: Real, S: System<R>> Moving<R, S> {
    fn new(dt: R, direction: &S::U) -> Self {
        Self {
            dt,
            by_q: TangentMap::of_q_plus_by_q(direction),
            by_direction: TangentMap::of_q_plus_by_direction(direction),
        }
    }

    /// What becomes of a change, where accelerations change by `u_dot`.
    fn changed(&self, change: &Change<S::U>, u_dot: &S::U) -> Change<S::U> {
        let u = plus_scaled(&change.u, self.dt, u_dot);
        let by_u = self.by_direction.times(&scaled(self.dt, &u));
        Change {
            q: plus(&self.by_q.times(&change.q), &by_u),
            u,
        }
    }
}

/// As [`step`], with its derivatives at the state before it.
pub fn linearized<R: Real, S: ForwardDynamicsAndDerivatives<R>>(
    system: &S,
    tau: &S::U,
    dt: R,
    (q, u): (&mut S::Q, &mut S::U),
    derivatives: &mut StepDerivatives<S::Matrix>,
) {
    let mut u_dot = zero();
    let mut of_u_dot = [S::Matrix::filled(zero()); 3];
    let [by_q, by_u, by_tau] = &mut of_u_dot;
    system.forward_dynamics_and_d_forward_dynamics_d_q_u_tau(
        q, u, tau, &mut u_dot, by_q, by_u, by_tau,
    );
    let direction = moved(system, dt, q, u, &u_dot);
    let moving = Moving::<R, S>::new(dt, &direction);
    let none = Change {
        q: zero(),
        u: zero(),
    };
    let out = derivatives;
    for place in 0..S::U::LEN {
        let unit = unit(place);
        let of = |change, matrix: &S::Matrix| moving.changed(&change, &column(matrix, place));
        let changed = of(Change { q: unit, ..none }, by_q);
        set_column(&mut out.q_by_q, place, &changed.q);
        set_column(&mut out.u_by_q, place, &changed.u);
        let changed = of(Change { u: unit, ..none }, by_u);
        set_column(&mut out.q_by_u, place, &changed.q);
        set_column(&mut out.u_by_u, place, &changed.u);
        let changed = of(none, by_tau);
        set_column(&mut out.q_by_tau, place, &changed.q);
        set_column(&mut out.u_by_tau, place, &changed.u);
    }
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
    let moving = Moving::<R, S>::new(dt, &moved(system, dt, &mut q, &mut u, &u_dot));
    let none = Change {
        q: zero(),
        u: zero(),
    };
    for place in 0..S::Values::LEN {
        let changed = moving.changed(&none, &column(&by_values, place));
        set_column(&mut derivatives.q, place, &changed.q);
        set_column(&mut derivatives.u, place, &changed.u);
    }
}

/// As [`step`], and the change of the state becomes that after the step, where `tau` changes by `tau_change`.
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
    let direction = moved(system, dt, q, u, &u_dot);
    *change = Moving::<R, S>::new(dt, &direction).changed(change, &du_dot);
}

/// The multiplier of the state after the step becomes that of the state before it, `q`, `u`; `tau_gradient` is overwritten with that of
/// `tau`.
///
/// With the derivatives of [`linearized`], `multiplier · A` and `multiplier · B`.
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
    let Moving {
        by_q, by_direction, ..
    } = Moving::<R, S>::new(dt, &direction);
    let of_direction = by_direction.transposed_times(&multiplier.q);
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
    multiplier.q = plus(&by_q.transposed_times(&multiplier.q), &q_gradient);
    multiplier.u = plus(&of_u, &u_gradient);
}
