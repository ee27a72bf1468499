//! A system under loads.

use core::fmt;

use super::of_system;
use crate::functions::{
    ForwardDynamics, ForwardDynamicsAndDerivatives, ForwardDynamicsJvp, ForwardDynamicsVjp,
    InverseDynamics, LoadedForwardDynamics, LoadedForwardDynamicsAndDerivatives,
    LoadedForwardDynamicsJvp, LoadedForwardDynamicsVjp, LoadedInverseDynamics,
};
use crate::{Real, System};

/// A system with loads on its bodies: its forward and inverse dynamics are the loaded ones of the system.
pub struct Loaded<'a, R: Real, S: System<R>> {
    /// The system.
    pub system: &'a S,
    /// The loads, one for each body: N and N m, in the axes and about the points of [`Load`](crate::Load).
    pub loads: S::Loads,
}

// Derived, these would ask the system for the same.
impl<R: Real, S: System<R>> Clone for Loaded<'_, R, S> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<R: Real, S: System<R>> Copy for Loaded<'_, R, S> {}

impl<R: Real, S: System<R>> fmt::Debug for Loaded<'_, R, S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Loaded")
            .field("system", &S::NAME)
            .field("loads", &self.loads)
            .finish()
    }
}

impl<R: Real, S: System<R>> System<R> for Loaded<'_, R, S> {
    of_system!();
}

impl<R: Real, S: LoadedForwardDynamics<R>> ForwardDynamics<R> for Loaded<'_, R, S> {
    fn forward_dynamics(&self, q: &S::Q, u: &S::U, tau: &S::U, u_dot: &mut S::U) {
        self.system
            .loaded_forward_dynamics(q, u, tau, &self.loads, u_dot);
    }
}

impl<R: Real, S: LoadedInverseDynamics<R>> InverseDynamics<R> for Loaded<'_, R, S> {
    fn inverse_dynamics(&self, q: &S::Q, u: &S::U, u_dot: &S::U, tau: &mut S::U) {
        self.system
            .loaded_inverse_dynamics(q, u, u_dot, &self.loads, tau);
    }
}

impl<R: Real, S: LoadedForwardDynamicsAndDerivatives<R>> ForwardDynamicsAndDerivatives<R>
    for Loaded<'_, R, S>
{
    fn forward_dynamics_and_d_forward_dynamics_d_q_u_tau(
        &self,
        q: &S::Q,
        u: &S::U,
        tau: &S::U,
        u_dot: &mut S::U,
        du_dot_dq: &mut S::Matrix,
        du_dot_du: &mut S::Matrix,
        du_dot_dtau: &mut S::Matrix,
    ) {
        let loads = &self.loads;
        self.system
            .loaded_forward_dynamics_and_d_loaded_forward_dynamics_d_q_u_tau(
                q,
                u,
                tau,
                loads,
                u_dot,
                du_dot_dq,
                du_dot_du,
                du_dot_dtau,
            );
    }
}

impl<R: Real, S: LoadedForwardDynamicsJvp<R>> ForwardDynamicsJvp<R> for Loaded<'_, R, S> {
    fn jvp_forward_dynamics_q_u_tau(
        &self,
        q: &S::Q,
        u: &S::U,
        tau: &S::U,
        q_direction: &S::U,
        u_direction: &S::U,
        tau_direction: &S::U,
        du_dot: &mut S::U,
    ) {
        self.system.jvp_loaded_forward_dynamics_q_u_tau(
            q,
            u,
            tau,
            &self.loads,
            q_direction,
            u_direction,
            tau_direction,
            du_dot,
        );
    }
}

impl<R: Real, S: LoadedForwardDynamicsVjp<R>> ForwardDynamicsVjp<R> for Loaded<'_, R, S> {
    fn vjp_forward_dynamics_q_u_tau(
        &self,
        q: &S::Q,
        u: &S::U,
        tau: &S::U,
        multiplier: &S::U,
        q_gradient: &mut S::U,
        u_gradient: &mut S::U,
        tau_gradient: &mut S::U,
    ) {
        self.system.vjp_loaded_forward_dynamics_q_u_tau(
            q,
            u,
            tau,
            &self.loads,
            multiplier,
            q_gradient,
            u_gradient,
            tau_gradient,
        );
    }
}
