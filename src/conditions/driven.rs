//! A system of which something drives joints.

use core::fmt;

use super::of_system;
use crate::functions::{
    ForwardDynamics, ForwardDynamicsAndDerivatives, ForwardDynamicsJvp, ForwardDynamicsVjp,
    HybridDynamics, HybridDynamicsAndDerivatives, HybridDynamicsJvp, HybridDynamicsVjp,
};
use crate::vector::zero;
use crate::{Array, Real, System};

/// A system in which something drives the prescribed speeds, with accelerations that are given.
///
/// Its forward dynamics copy these and find the others. Entries of `tau` of prescribed speeds have no effect. The forces that drive them are
/// the `whole_tau` of [`HybridDynamics`].
pub struct Driven<'a, R: Real, S: System<R>> {
    /// The system.
    pub system: &'a S,
    /// The accelerations of the prescribed speeds, rad/s² and m/s²; other entries have no effect.
    pub u_dot: S::U,
}

// Derived, these would ask the system for the same.
impl<R: Real, S: System<R>> Clone for Driven<'_, R, S> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<R: Real, S: System<R>> Copy for Driven<'_, R, S> {}

impl<R: Real, S: System<R>> fmt::Debug for Driven<'_, R, S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Driven")
            .field("system", &S::NAME)
            .field("u_dot", &self.u_dot)
            .finish()
    }
}

impl<R: Real, S: System<R>> System<R> for Driven<'_, R, S> {
    of_system!();
}

impl<R: Real, S: HybridDynamics<R>> ForwardDynamics<R> for Driven<'_, R, S> {
    fn forward_dynamics(&self, q: &S::Q, u: &S::U, tau: &S::U, u_dot: &mut S::U) {
        let mut whole_tau = zero();
        self.system
            .hybrid_dynamics(q, u, &self.u_dot, tau, u_dot, &mut whole_tau);
    }
}

impl<R: Real, S: HybridDynamicsAndDerivatives<R>> ForwardDynamicsAndDerivatives<R>
    for Driven<'_, R, S>
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
        let (mut whole_tau, mut of_tau) = (zero(), [S::Matrix::filled(zero()); 3]);
        let [by_q, by_u, by_tau] = &mut of_tau;
        self.system.hybrid_dynamics_and_d_hybrid_dynamics_d_q_u_tau(
            q,
            u,
            &self.u_dot,
            tau,
            u_dot,
            &mut whole_tau,
            du_dot_dq,
            du_dot_du,
            du_dot_dtau,
            by_q,
            by_u,
            by_tau,
        );
    }
}

impl<R: Real, S: HybridDynamicsJvp<R>> ForwardDynamicsJvp<R> for Driven<'_, R, S> {
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
        let mut of_tau = zero();
        self.system.jvp_hybrid_dynamics_q_u_tau(
            q,
            u,
            &self.u_dot,
            tau,
            q_direction,
            u_direction,
            tau_direction,
            du_dot,
            &mut of_tau,
        );
    }
}

impl<R: Real, S: HybridDynamicsVjp<R>> ForwardDynamicsVjp<R> for Driven<'_, R, S> {
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
        self.system.vjp_hybrid_dynamics_q_u_tau(
            q,
            u,
            &self.u_dot,
            tau,
            multiplier,
            &zero(),
            q_gradient,
            u_gradient,
            tau_gradient,
        );
    }
}
