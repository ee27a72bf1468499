//! Products with derivatives of accelerations, as both kinds of steps ask for them: along changes, and back from multipliers.

use super::derivatives::Change;
use crate::functions::{
    ForwardDynamicsJvp, ForwardDynamicsParametersJvp, ForwardDynamicsParametersVjp,
    ForwardDynamicsVjp,
};
use crate::vector::{plus, zero};
use crate::{Real, System};

/// Where accelerations are differentiated: `q`, `u`, `tau`.
pub(super) type At<'a, R, S> = (
    &'a <S as System<R>>::Q,
    &'a <S as System<R>>::U,
    &'a <S as System<R>>::U,
);

/// How accelerations change with a change of the state, if `tau` changes too.
pub(super) fn along<R: Real, S: ForwardDynamicsJvp<R>>(
    system: &S,
    tau_change: &S::U,
) -> impl Fn(At<'_, R, S>, &Change<S::U>) -> S::U {
    move |(q, u, tau), change| {
        let mut du_dot = zero();
        let Change { q: of_q, u: of_u } = change;
        system.jvp_forward_dynamics_q_u_tau(q, u, tau, of_q, of_u, tau_change, &mut du_dot);
        du_dot
    }
}

/// The same if values set at run time change too.
pub(super) fn along_with_parameters<R: Real, S: ForwardDynamicsParametersJvp<R>>(
    system: &S,
    tau_change: &S::U,
    parameters_change: &S::Values,
) -> impl Fn(At<'_, R, S>, &Change<S::U>) -> S::U {
    move |(q, u, tau), change| {
        let mut du_dot = zero();
        system.jvp_forward_dynamics_q_u_tau_parameters(
            q,
            u,
            tau,
            &change.q,
            &change.u,
            tau_change,
            parameters_change,
            &mut du_dot,
        );
        du_dot
    }
}

/// The gradient of accelerations, times a multiplier, by the state; that by `tau` is summed up.
pub(super) fn back<R: Real, S: ForwardDynamicsVjp<R>>(
    system: &S,
    tau_gradient: &mut S::U,
) -> impl FnMut(At<'_, R, S>, &S::U) -> Change<S::U> {
    *tau_gradient = zero();
    move |(q, u, tau), multiplier| {
        let (mut of_q, mut of_u, mut of_tau) = (zero(), zero(), zero());
        system.vjp_forward_dynamics_q_u_tau(
            q,
            u,
            tau,
            multiplier,
            &mut of_q,
            &mut of_u,
            &mut of_tau,
        );
        *tau_gradient = plus(tau_gradient, &of_tau);
        Change { q: of_q, u: of_u }
    }
}

/// The same; that by values set at run time is summed up too.
pub(super) fn back_with_parameters<R: Real, S: ForwardDynamicsParametersVjp<R>>(
    system: &S,
    tau_gradient: &mut S::U,
    parameters_gradient: &mut S::Values,
) -> impl FnMut(At<'_, R, S>, &S::U) -> Change<S::U> {
    (*tau_gradient, *parameters_gradient) = (zero(), zero());
    move |(q, u, tau), multiplier| {
        let (mut of_q, mut of_u, mut of_tau) = (zero(), zero(), zero());
        let mut of_values = zero();
        system.vjp_forward_dynamics_q_u_tau_parameters(
            q,
            u,
            tau,
            multiplier,
            &mut of_q,
            &mut of_u,
            &mut of_tau,
            &mut of_values,
        );
        *tau_gradient = plus(tau_gradient, &of_tau);
        *parameters_gradient = plus(parameters_gradient, &of_values);
        Change { q: of_q, u: of_u }
    }
}
