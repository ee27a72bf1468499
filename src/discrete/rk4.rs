//! The classic fourth-order Runge-Kutta step, on the manifold.
//!
//! The step integrates the speeds, and the direction by which [`q_plus`] leads from the coordinates before the step. If the
//! speeds are rates of coordinates, this is the ordinary step, [`rk4_step`](crate::integrate::rk4_step), up to rounding. For
//! an orientation `d_dot = w + d × w / 2 + d × (d × w) / 12`; the omitted terms are beyond the order of the step.

use super::derivatives::{Change, StepByParameters, StepDerivatives, Variable};
use super::reached::{Reached, move_on};
use crate::functions::{
    ForwardDynamics, ForwardDynamicsAndDerivatives, ForwardDynamicsByParameters,
    ForwardDynamicsJvp, ForwardDynamicsVjp,
};
use crate::manifold::{q_plus, rate};
use crate::vector::{column, plus, plus_scaled, scaled, times, zero};
use crate::{Array, Real, System};

/// How far each stage is from the state before the step, in steps.
const WAYS: [f64; 4] = [0.0, 0.5, 0.5, 1.0];

/// The weights of the stages' rates.
const WEIGHTS: [f64; 4] = [1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0];

/// A state within the step, and its rates.
#[derive(Clone, Copy)]
struct Stage<Q, U> {
    /// The direction that leads to `q`.
    d: U,
    q: Q,
    u: U,
    d_dot: U,
    u_dot: U,
}

type Stages<R, S> = [Stage<<S as System<R>>::Q, <S as System<R>>::U>; 4];

/// The stages of a step, and the direction and speeds to which it leads.
type Walk<R, S> = (Stages<R, S>, <S as System<R>>::U, <S as System<R>>::U);

/// The stages of a step, with the accelerations `u_dot(stage, q, u)`.
fn stages<R: Real, S: System<R>>(
    system: &S,
    dt: R,
    (q, u): (&S::Q, &S::U),
    mut u_dot: impl FnMut(usize, &S::Q, &S::U) -> S::U,
) -> Walk<R, S> {
    let start = Stage {
        d: zero(),
        q: *q,
        u: *u,
        d_dot: zero(),
        u_dot: zero(),
    };
    let mut all = [start; 4];
    let (mut before, mut d_after, mut u_after) = (start, zero(), *u);
    for (place, stage) in all.iter_mut().enumerate() {
        let way = dt * R::from_f64(WAYS[place]);
        stage.d = scaled(way, &before.d_dot);
        stage.u = plus_scaled(u, way, &before.u_dot);
        stage.q = q_plus(system, q, &stage.d);
        stage.d_dot = rate::of::<R, S>(&stage.d, &stage.u);
        stage.u_dot = u_dot(place, &stage.q, &stage.u);
        let weight = dt * R::from_f64(WEIGHTS[place]);
        d_after = plus_scaled(&d_after, weight, &stage.d_dot);
        u_after = plus_scaled(&u_after, weight, &stage.u_dot);
        before = *stage;
    }
    (all, d_after, u_after)
}

/// The stages of a step, with the accelerations of the dynamics.
fn driven<R: Real, S: ForwardDynamics<R>>(
    system: &S,
    tau: &S::U,
    dt: R,
    state: (&S::Q, &S::U),
) -> Walk<R, S> {
    stages(system, dt, state, |_, q, u| {
        let mut u_dot = zero();
        system.forward_dynamics(q, u, tau, &mut u_dot);
        u_dot
    })
}

/// The derivatives of the stages' accelerations by `q`, `u` and `tau`.
type OfAccelerations<M> = [[M; 3]; 4];

/// The stages of a step, with the derivatives of their accelerations.
fn differentiated<R: Real, S: ForwardDynamicsAndDerivatives<R>>(
    system: &S,
    tau: &S::U,
    dt: R,
    state: (&S::Q, &S::U),
) -> (Walk<R, S>, OfAccelerations<S::Matrix>) {
    let mut of_u_dot = [[S::Matrix::filled(zero()); 3]; 4];
    let walk = stages(system, dt, state, |place, q, u| {
        let mut u_dot = zero();
        let [by_q, by_u, by_tau] = &mut of_u_dot[place];
        system.forward_dynamics_and_d_forward_dynamics_d_q_u_tau(
            q, u, tau, &mut u_dot, by_q, by_u, by_tau,
        );
        u_dot
    });
    (walk, of_u_dot)
}

/// How a stage's accelerations change with its state.
fn by_state<R: Real, U: Array<R>, M: Array<U>>([by_q, by_u, _]: &[M; 3], change: &Change<U>) -> U {
    plus(&times(by_q, &change.q), &times(by_u, &change.u))
}

/// Advances `q` and `u` by `dt`, s, under forces `tau`, N m and N.
pub fn step<R: Real, S: ForwardDynamics<R>>(
    system: &S,
    tau: &S::U,
    dt: R,
    q: &mut S::Q,
    u: &mut S::U,
) {
    let (_, d_after, u_after) = driven(system, tau, dt, (q, u));
    move_on(system, q, &d_after);
    *u = u_after;
}

/// How the stages of a step change, and the coordinates after it.
struct Moved<R: Real, S: System<R>> {
    dt: R,
    stages: Stages<R, S>,
    to_stages: [Reached<R, S>; 4],
    to_end: Reached<R, S>,
}

impl<R: Real, S: System<R>> Moved<R, S> {
    fn new(dt: R, stages: Stages<R, S>, d_after: &S::U) -> Self {
        Self {
            dt,
            stages,
            to_stages: [0, 1, 2, 3].map(|place: usize| Reached::by(&stages[place].d)),
            to_end: Reached::by(d_after),
        }
    }

    /// The change after the step, with the changes `du_dot(stage, change)` of the accelerations.
    fn changed(
        &self,
        change: &Change<S::U>,
        mut du_dot: impl FnMut(usize, &Change<S::U>) -> S::U,
    ) -> Change<S::U> {
        let (mut d_rate, mut u_rate) = (zero(), zero());
        let (mut d_after, mut u_after) = (zero(), change.u);
        for place in 0..4 {
            let stage = &self.stages[place];
            let way = self.dt * R::from_f64(WAYS[place]);
            let d = scaled(way, &d_rate);
            let own = Change {
                q: self.to_stages[place].changed(&change.q, &d),
                u: plus_scaled(&change.u, way, &u_rate),
            };
            d_rate = rate::changed::<R, S>((&stage.d, &stage.u), (&d, &own.u));
            u_rate = du_dot(place, &own);
            let weight = self.dt * R::from_f64(WEIGHTS[place]);
            d_after = plus_scaled(&d_after, weight, &d_rate);
            u_after = plus_scaled(&u_after, weight, &u_rate);
        }
        Change {
            q: self.to_end.changed(&change.q, &d_after),
            u: u_after,
        }
    }

    /// The multiplier before the step, with the gradient `gradient(stage, multiplier)` of the accelerations by the stage's state.
    fn back(
        &self,
        multiplier: &Change<S::U>,
        mut gradient: impl FnMut(usize, &S::U) -> Change<S::U>,
    ) -> Change<S::U> {
        let (of_q, d_after) = self.to_end.back(&multiplier.q);
        let mut before = Change {
            q: of_q,
            u: multiplier.u,
        };
        // What the stage after has of the rates of its own before.
        let (mut of_d_rate, mut of_u_rate) = (zero(), zero());
        for place in (0..4).rev() {
            let (stage, moving) = (&self.stages[place], &self.to_stages[place]);
            let weight = self.dt * R::from_f64(WEIGHTS[place]);
            let of_u_dot = plus_scaled(&of_u_rate, weight, &multiplier.u);
            let of_d_dot = plus_scaled(&of_d_rate, weight, &d_after);
            let own = gradient(place, &of_u_dot);
            let (of_d, of_u) = rate::back::<R, S>((&stage.d, &stage.u), &of_d_dot);
            let (own_q, own_d) = moving.back(&own.q);
            let of_d = plus(&of_d, &own_d);
            let of_u = plus(&of_u, &own.u);
            before.q = plus(&before.q, &own_q);
            before.u = plus(&before.u, &of_u);
            let way = self.dt * R::from_f64(WAYS[place]);
            of_d_rate = scaled(way, &of_d);
            of_u_rate = scaled(way, &of_u);
        }
        before
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
    let ((stages, d_after, u_after), of_u_dot) = differentiated(system, tau, dt, (q, u));
    move_on(system, q, &d_after);
    *u = u_after;
    let moved = Moved::<R, S>::new(dt, stages, &d_after);
    derivatives.set_columns(|variable, place| {
        moved.changed(&variable.change(place), |stage, change| {
            let by_state = by_state(&of_u_dot[stage], change);
            match variable {
                Variable::Q | Variable::U => by_state,
                Variable::Tau => plus(&by_state, &column(&of_u_dot[stage][2], place)),
            }
        })
    });
}

/// The derivatives of the state after the step by all values set at run time.
pub fn by_parameters<
    R: Real,
    S: ForwardDynamicsAndDerivatives<R> + ForwardDynamicsByParameters<R>,
>(
    system: &S,
    tau: &S::U,
    dt: R,
    (q, u): (&S::Q, &S::U),
    derivatives: &mut StepByParameters<S::ByParameters>,
) {
    let ((stages, d_after, _), of_u_dot) = differentiated(system, tau, dt, (q, u));
    let by_values = stages.map(|Stage { q, u, .. }| {
        let mut by_values = S::ByParameters::filled(zero());
        system.d_forward_dynamics_d_parameters(&q, &u, tau, &mut by_values);
        by_values
    });
    let moved = Moved::<R, S>::new(dt, stages, &d_after);
    derivatives.set_columns(|place| {
        moved.changed(&Change::zero(), |stage, change| {
            let by_state = by_state(&of_u_dot[stage], change);
            plus(&by_state, &column(&by_values[stage], place))
        })
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
    let (stages, d_after, u_after) = driven(system, tau, dt, (q, u));
    let moved = Moved::<R, S>::new(dt, stages, &d_after);
    *change = moved.changed(change, |place, change| {
        let Stage { q, u, .. } = &moved.stages[place];
        let mut du_dot = zero();
        system.jvp_forward_dynamics_q_u_tau(
            q,
            u,
            tau,
            &change.q,
            &change.u,
            tau_change,
            &mut du_dot,
        );
        du_dot
    });
    move_on(system, q, &d_after);
    *u = u_after;
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
    let (stages, d_after, _) = driven(system, tau, dt, (q, u));
    let moved = Moved::<R, S>::new(dt, stages, &d_after);
    let mut sum = zero();
    *multiplier = moved.back(multiplier, |place, of_u_dot| {
        let Stage { q, u, .. } = &moved.stages[place];
        let (mut q_gradient, mut u_gradient, mut own) = (zero(), zero(), zero());
        system.vjp_forward_dynamics_q_u_tau(
            q,
            u,
            tau,
            of_u_dot,
            &mut q_gradient,
            &mut u_gradient,
            &mut own,
        );
        sum = plus(&sum, &own);
        Change {
            q: q_gradient,
            u: u_gradient,
        }
    });
    *tau_gradient = sum;
}
