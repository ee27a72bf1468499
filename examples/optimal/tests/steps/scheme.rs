//! Both kinds of steps, as tests call them.

use kane::Array;
use kane::discrete::{Change, StepByParameters, StepDerivatives, euler, rk4};
use kane::functions::{
    ForwardDynamics, ForwardDynamicsAndDerivatives, ForwardDynamicsByParameters,
    ForwardDynamicsJvp, ForwardDynamicsParametersJvp, ForwardDynamicsParametersVjp,
    ForwardDynamicsVjp,
};

#[derive(Clone, Copy, Debug)]
pub(crate) enum Scheme {
    Euler,
    Rk4,
}

/// A state, and what drives it for how long.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Driven<Q, U> {
    pub(crate) q: Q,
    pub(crate) u: U,
    pub(crate) tau: U,
    pub(crate) dt: f64,
}

impl Scheme {
    pub(crate) const ALL: [Self; 2] = [Self::Euler, Self::Rk4];

    pub(crate) fn step<S: ForwardDynamics<f64>>(
        self,
        system: &S,
        Driven { q, u, tau, dt }: &Driven<S::Q, S::U>,
    ) -> (S::Q, S::U) {
        let (mut q, mut u) = (*q, *u);
        match self {
            Self::Euler => euler::step(system, tau, *dt, &mut q, &mut u),
            Self::Rk4 => rk4::step(system, tau, *dt, &mut q, &mut u),
        }
        (q, u)
    }

    pub(crate) fn linearized<S: ForwardDynamicsAndDerivatives<f64>>(
        self,
        system: &S,
        Driven { q, u, tau, dt }: &Driven<S::Q, S::U>,
        derivatives: &mut StepDerivatives<S::Matrix>,
    ) -> (S::Q, S::U) {
        let (mut q, mut u) = (*q, *u);
        let state = (&mut q, &mut u);
        match self {
            Self::Euler => euler::linearized(system, tau, *dt, state, derivatives),
            Self::Rk4 => rk4::linearized(system, tau, *dt, state, derivatives),
        }
        (q, u)
    }

    pub(crate) fn by_parameters<
        S: ForwardDynamics<f64>
            + ForwardDynamicsAndDerivatives<f64>
            + ForwardDynamicsByParameters<f64>,
    >(
        self,
        system: &S,
        Driven { q, u, tau, dt }: &Driven<S::Q, S::U>,
        derivatives: &mut StepByParameters<S::ByParameters>,
    ) {
        match self {
            Self::Euler => euler::by_parameters(system, tau, *dt, (q, u), derivatives),
            Self::Rk4 => rk4::by_parameters(system, tau, *dt, (q, u), derivatives),
        }
    }

    pub(crate) fn linearized_and_by_parameters<
        S: ForwardDynamicsAndDerivatives<f64> + ForwardDynamicsByParameters<f64>,
    >(
        self,
        system: &S,
        Driven { q, u, tau, dt }: &Driven<S::Q, S::U>,
        both: (
            &mut StepDerivatives<S::Matrix>,
            &mut StepByParameters<S::ByParameters>,
        ),
    ) -> (S::Q, S::U) {
        let (mut q, mut u) = (*q, *u);
        let state = (&mut q, &mut u);
        match self {
            Self::Euler => euler::linearized_and_by_parameters(system, tau, *dt, state, both),
            Self::Rk4 => rk4::linearized_and_by_parameters(system, tau, *dt, state, both),
        }
        (q, u)
    }

    pub(crate) fn forward<S: ForwardDynamics<f64> + ForwardDynamicsJvp<f64>>(
        self,
        system: &S,
        Driven { q, u, tau, dt }: &Driven<S::Q, S::U>,
        (mut change, tau_change): (Change<S::U>, S::U),
    ) -> (S::Q, S::U, Change<S::U>) {
        let (mut q, mut u) = (*q, *u);
        let (state, changes) = ((&mut q, &mut u), (&mut change, &tau_change));
        match self {
            Self::Euler => euler::forward(system, tau, *dt, state, changes),
            Self::Rk4 => rk4::forward(system, tau, *dt, state, changes),
        }
        (q, u, change)
    }

    pub(crate) fn adjoint<S: ForwardDynamics<f64> + ForwardDynamicsVjp<f64>>(
        self,
        system: &S,
        Driven { q, u, tau, dt }: &Driven<S::Q, S::U>,
        mut multiplier: Change<S::U>,
    ) -> (Change<S::U>, S::U) {
        let mut gradient = *u;
        let multipliers = (&mut multiplier, &mut gradient);
        match self {
            Self::Euler => euler::adjoint(system, tau, *dt, (q, u), multipliers),
            Self::Rk4 => rk4::adjoint(system, tau, *dt, (q, u), multipliers),
        }
        (multiplier, gradient)
    }

    pub(crate) fn forward_with_parameters<
        S: ForwardDynamics<f64> + ForwardDynamicsParametersJvp<f64>,
    >(
        self,
        system: &S,
        Driven { q, u, tau, dt }: &Driven<S::Q, S::U>,
        (mut change, tau_change, values_change): (Change<S::U>, S::U, S::Values),
    ) -> Change<S::U> {
        let (mut q, mut u) = (*q, *u);
        let state = (&mut q, &mut u);
        let changes = (&mut change, &tau_change, &values_change);
        match self {
            Self::Euler => euler::forward_with_parameters(system, tau, *dt, state, changes),
            Self::Rk4 => rk4::forward_with_parameters(system, tau, *dt, state, changes),
        }
        change
    }

    pub(crate) fn adjoint_with_parameters<
        S: ForwardDynamics<f64> + ForwardDynamicsParametersVjp<f64>,
    >(
        self,
        system: &S,
        Driven { q, u, tau, dt }: &Driven<S::Q, S::U>,
        mut multiplier: Change<S::U>,
    ) -> (Change<S::U>, S::U, S::Values) {
        let (mut gradient, mut of_values) = (*u, S::Values::filled(f64::NAN));
        let all = (&mut multiplier, &mut gradient, &mut of_values);
        let state = (q, u);
        match self {
            Self::Euler => euler::adjoint_with_parameters(system, tau, *dt, state, all),
            Self::Rk4 => rk4::adjoint_with_parameters(system, tau, *dt, state, all),
        }
        (multiplier, gradient, of_values)
    }
}
