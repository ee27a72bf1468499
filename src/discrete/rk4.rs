//! The classic fourth-order Runge-Kutta step, on the manifold.
//!
//! The step integrates the speeds, and the direction by which [`q_plus`] leads from the coordinates before the step. If the
//! speeds are rates of coordinates, this is the ordinary step, [`rk4_step`](crate::integrate::rk4_step), up to rounding. For
//! an orientation `d_dot = w + d × w / 2 + d × (d × w) / 12`; the omitted terms are beyond the order of the step.

use super::derivatives::{Change, StepByParameters, StepDerivatives, Variable};
use super::products::{self, At};
use super::reached::{Reached, move_on};
use crate::functions::{
    ForwardDynamics, ForwardDynamicsAndDerivatives, ForwardDynamicsByParameters,
    ForwardDynamicsJvp, ForwardDynamicsParametersJvp, ForwardDynamicsParametersVjp,
    ForwardDynamicsVjp,
};
use crate::manifold::{q_plus, rate, rate::RateMap};
use crate::vector::{
    add_identity, add_product, add_scaled_rows, plus, plus_scaled, scale_rows, scaled, zero,
};
use crate::{Array, Real, System};

/// How far each stage is from the state before the step, in steps.
const WAYS: [f64; 4] = [0.0, 0.5, 0.5, 1.0];

/// The weights of the stages' rates.
const WEIGHTS: [f64; 4] = [1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0];

/// A state within the step.
#[derive(Clone, Copy)]
struct Stage<R, Q, U> {
    /// The time by which rates before it lead to it, s.
    way: R,
    /// The time for which its own rates count, s.
    weight: R,
    /// The direction that leads to `q`.
    d: U,
    q: Q,
    u: U,
}

type StageOf<R, S> = Stage<R, <S as System<R>>::Q, <S as System<R>>::U>;

/// The direction and speeds to which a step leads, with the accelerations `u_dot(stage)`.
fn walk<R: Real, S: System<R>>(
    system: &S,
    dt: R,
    (q, u): (&S::Q, &S::U),
    mut u_dot: impl FnMut(&StageOf<R, S>) -> S::U,
) -> (S::U, S::U) {
    let (mut d_rate, mut u_rate) = (zero(), zero());
    let (mut d_after, mut u_after) = (zero(), *u);
    for (way, weight) in WAYS.into_iter().zip(WEIGHTS) {
        let (way, weight) = (dt * R::from_f64(way), dt * R::from_f64(weight));
        let d = scaled(way, &d_rate);
        let stage = Stage {
            way,
            weight,
            d,
            q: q_plus(system, q, &d),
            u: plus_scaled(u, way, &u_rate),
        };
        d_rate = rate::of::<R, S>(&d, &stage.u);
        u_rate = u_dot(&stage);
        d_after = plus_scaled(&d_after, weight, &d_rate);
        u_after = plus_scaled(&u_after, weight, &u_rate);
    }
    (d_after, u_after)
}

/// The accelerations of a stage.
fn driven<R: Real, S: ForwardDynamics<R>>(system: &S, tau: &S::U, stage: &StageOf<R, S>) -> S::U {
    let mut u_dot = zero();
    system.forward_dynamics(&stage.q, &stage.u, tau, &mut u_dot);
    u_dot
}

/// The accelerations of a stage, and their derivatives by `q`, `u` and `tau`.
fn differentiated<R: Real, S: ForwardDynamicsAndDerivatives<R>>(
    system: &S,
    tau: &S::U,
    stage: &StageOf<R, S>,
    [by_q, by_u, by_tau]: &mut [S::Matrix; 3],
) -> S::U {
    let mut u_dot = zero();
    system.forward_dynamics_and_d_forward_dynamics_d_q_u_tau(
        &stage.q, &stage.u, tau, &mut u_dot, by_q, by_u, by_tau,
    );
    u_dot
}

/// Advances `q` and `u` by `dt`, s, under forces `tau`, N m and N.
pub fn step<R: Real, S: ForwardDynamics<R>>(
    system: &S,
    tau: &S::U,
    dt: R,
    q: &mut S::Q,
    u: &mut S::U,
) {
    let (d_after, u_after) = walk(system, dt, (q, u), |stage| driven(system, tau, stage));
    move_on(system, q, &d_after);
    *u = u_after;
}

/// How the accelerations and the direction's rate at a stage change with its state.
struct Linear<'a, R: Real, S: System<R>> {
    way: R,
    weight: R,
    reached: Reached<R, S>,
    rate: RateMap<R, S>,
    by_q: &'a S::Matrix,
    by_u: &'a S::Matrix,
}

impl<'a, R: Real, S: System<R>> Linear<'a, R, S> {
    fn new(stage: &StageOf<R, S>, [by_q, by_u, _]: &'a [S::Matrix; 3]) -> Self {
        Self {
            way: stage.way,
            weight: stage.weight,
            reached: Reached::by(&stage.d),
            rate: RateMap::at(&stage.d, &stage.u),
            by_q,
            by_u,
        }
    }
}

/// Changes by the entries of a variable, a column for each, by rows.
struct Columns<'a, M> {
    variable: Variable,
    /// Of the rates at the stage before: of the direction, of the speeds.
    d_rate: M,
    u_rate: M,
    /// Whether these are other than zero.
    d_changes: bool,
    u_changes: bool,
    /// After the step; of `q`, those of the direction until the end.
    of_q: &'a mut M,
    of_u: &'a mut M,
}

impl<'a, M> Columns<'a, M> {
    /// Those before the step.
    fn start<R: Real, Row: Array<R>>(
        (variable, of_q, of_u): (Variable, &'a mut M, &'a mut M),
    ) -> Self
    where
        M: Array<Row>,
    {
        let none = M::filled(zero());
        (*of_q, *of_u) = (none, none);
        if variable == Variable::U {
            add_identity(of_u);
        }
        Self {
            variable,
            d_rate: none,
            u_rate: none,
            d_changes: false,
            u_changes: false,
            of_q,
            of_u,
        }
    }

    /// Passes on to a stage. `own` has the changes of its accelerations by the variable itself.
    fn pass<R: Real, S: System<R>, Row: Array<R>>(&mut self, stage: &Linear<'_, R, S>, own: &M)
    where
        M: Array<Row>,
    {
        let way = stage.way;
        let mut d_rate = self.u_rate;
        scale_rows(&mut d_rate, way);
        if self.variable == Variable::U {
            add_identity(&mut d_rate);
        }
        stage.rate.change_rows((way, &self.d_rate), &mut d_rate);
        let mut u_rate = *own;
        if self.variable == Variable::Q {
            stage.reached.by_q.turn_columns(&mut u_rate);
        }
        if self.d_changes {
            stage.reached.by_direction.turn_rows(&mut self.d_rate);
            add_product(&mut u_rate, way, stage.by_q, &self.d_rate);
        }
        if self.u_changes {
            add_product(&mut u_rate, way, stage.by_u, &self.u_rate);
        }
        add_scaled_rows(self.of_q, stage.weight, &d_rate);
        add_scaled_rows(self.of_u, stage.weight, &u_rate);
        (self.d_rate, self.u_rate) = (d_rate, u_rate);
        // The direction is zero before the first stage, and changes there with the speeds alone.
        self.d_changes = self.u_changes || self.variable == Variable::U;
        self.u_changes = true;
    }
}

/// Like [`step`], and also gives its derivatives at the state before it.
pub fn linearized<R: Real, S: ForwardDynamicsAndDerivatives<R>>(
    system: &S,
    tau: &S::U,
    dt: R,
    state: (&mut S::Q, &mut S::U),
    derivatives: &mut StepDerivatives<S::Matrix>,
) {
    let _ = linearized_and(system, tau, dt, state, derivatives, |_, _| {});
}

/// Like [`linearized`], with what is to be done with each stage; gives the way to the coordinates after the step.
fn linearized_and<R: Real, S: ForwardDynamicsAndDerivatives<R>>(
    system: &S,
    tau: &S::U,
    dt: R,
    (q, u): (&mut S::Q, &mut S::U),
    derivatives: &mut StepDerivatives<S::Matrix>,
    mut and: impl FnMut(&StageOf<R, S>, &Linear<'_, R, S>),
) -> Reached<R, S> {
    let mut by = [S::Matrix::filled(zero()); 3];
    let mut all = derivatives.by_variable().map(Columns::start);
    let (d_after, u_after) = walk(system, dt, (q, u), |stage| {
        let u_dot = differentiated(system, tau, stage, &mut by);
        let linear = Linear::<R, S>::new(stage, &by);
        for (columns, own) in all.iter_mut().zip(&by) {
            columns.pass(&linear, own);
        }
        and(stage, &linear);
        u_dot
    });
    let end = Reached::<R, S>::by(&d_after);
    for columns in &mut all {
        end.change_rows(columns.variable, columns.of_q);
    }
    move_on(system, q, &d_after);
    *u = u_after;
    end
}

/// The derivatives of the state after the step by all values set at run time.
pub fn by_parameters<
    R: Real,
    S: ForwardDynamicsAndDerivatives<R> + ForwardDynamicsByParameters<R>,
>(
    system: &S,
    tau: &S::U,
    dt: R,
    state: (&S::Q, &S::U),
    derivatives: &mut StepByParameters<S::ByParameters>,
) {
    let StepByParameters { q: of_q, u: of_u } = derivatives;
    let (mut by, mut by_values) = (
        [S::Matrix::filled(zero()); 3],
        S::ByParameters::filled(zero()),
    );
    let mut columns = Columns::start((Variable::Other, of_q, of_u));
    let (d_after, _) = walk(system, dt, state, |stage| {
        let u_dot = differentiated(system, tau, stage, &mut by);
        system.d_forward_dynamics_d_parameters(&stage.q, &stage.u, tau, &mut by_values);
        columns.pass(&Linear::<R, S>::new(stage, &by), &by_values);
        u_dot
    });
    Reached::<R, S>::by(&d_after).change_rows(columns.variable, columns.of_q);
}

/// [`linearized`] and [`by_parameters`], without the evaluation of the dynamics that the second needs alone at each stage.
pub fn linearized_and_by_parameters<
    R: Real,
    S: ForwardDynamicsAndDerivatives<R> + ForwardDynamicsByParameters<R>,
>(
    system: &S,
    tau: &S::U,
    dt: R,
    state: (&mut S::Q, &mut S::U),
    (derivatives, by_parameters): (
        &mut StepDerivatives<S::Matrix>,
        &mut StepByParameters<S::ByParameters>,
    ),
) {
    let StepByParameters { q: of_q, u: of_u } = by_parameters;
    let mut by_values = S::ByParameters::filled(zero());
    let mut columns = Columns::start((Variable::Other, of_q, of_u));
    let end = linearized_and(system, tau, dt, state, derivatives, |stage, linear| {
        system.d_forward_dynamics_d_parameters(&stage.q, &stage.u, tau, &mut by_values);
        columns.pass(linear, &by_values);
    });
    end.change_rows(columns.variable, columns.of_q);
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

/// The accelerations of a stage change with its state as `along` tells.
fn forward_by<R: Real, S: ForwardDynamics<R>>(
    system: &S,
    tau: &S::U,
    dt: R,
    (q, u): (&mut S::Q, &mut S::U),
    change: &mut Change<S::U>,
    along: impl Fn(At<'_, R, S>, &Change<S::U>) -> S::U,
) {
    let (mut d_rate, mut u_rate) = (zero(), zero());
    let (mut d_change, mut u_change) = (zero(), change.u);
    let (d_after, u_after) = walk(system, dt, (q, u), |stage| {
        let d = scaled(stage.way, &d_rate);
        let own = Change {
            q: Reached::<R, S>::by(&stage.d).changed(&change.q, &d),
            u: plus_scaled(&change.u, stage.way, &u_rate),
        };
        d_rate = rate::changed::<R, S>((&stage.d, &stage.u), (&d, &own.u));
        u_rate = along((&stage.q, &stage.u, tau), &own);
        d_change = plus_scaled(&d_change, stage.weight, &d_rate);
        u_change = plus_scaled(&u_change, stage.weight, &u_rate);
        driven(system, tau, stage)
    });
    *change = Change {
        q: Reached::<R, S>::by(&d_after).changed(&change.q, &d_change),
        u: u_change,
    };
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

/// `back` tells the gradient of a stage's accelerations by its state.
fn adjoint_by<R: Real, S: ForwardDynamics<R>>(
    system: &S,
    tau: &S::U,
    dt: R,
    (q, u): (&S::Q, &S::U),
    multiplier: &mut Change<S::U>,
    mut back: impl FnMut(At<'_, R, S>, &S::U) -> Change<S::U>,
) {
    let mut stages = [None; 4];
    let mut kept = stages.iter_mut();
    let (d_after, _) = walk(system, dt, (q, u), |stage| {
        if let Some(kept) = kept.next() {
            *kept = Some(*stage);
        }
        driven(system, tau, stage)
    });
    let (of_q, d_after) = Reached::<R, S>::by(&d_after).back(&multiplier.q);
    let mut before = Change {
        q: of_q,
        u: multiplier.u,
    };
    // What the stage after has of the rates of its own before.
    let (mut of_d_rate, mut of_u_rate) = (zero(), zero());
    for stage in stages.iter().flatten().rev() {
        let of_u_dot = plus_scaled(&of_u_rate, stage.weight, &multiplier.u);
        let of_d_dot = plus_scaled(&of_d_rate, stage.weight, &d_after);
        let own = back((&stage.q, &stage.u, tau), &of_u_dot);
        let (of_d, of_u) = rate::back::<R, S>((&stage.d, &stage.u), &of_d_dot);
        let (own_q, own_d) = Reached::<R, S>::by(&stage.d).back(&own.q);
        let of_u = plus(&of_u, &own.u);
        before.q = plus(&before.q, &own_q);
        before.u = plus(&before.u, &of_u);
        of_d_rate = scaled(stage.way, &plus(&of_d, &own_d));
        of_u_rate = scaled(stage.way, &of_u);
    }
    *multiplier = before;
}
