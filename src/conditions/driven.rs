//! A system of which something drives joints.

use super::of_system;
use crate::functions::{ForwardDynamics, HybridDynamics};
use crate::vector::zero;
use crate::{Real, System};

/// A system whose prescribed speeds have given accelerations: its forward dynamics find the others, and copy these.
///
/// Entries of `tau` of prescribed speeds are not read; [`HybridDynamics`] finds them.
#[derive(Clone, Copy, Debug)]
pub struct Driven<'a, R: Real, S: System<R>> {
    /// The system.
    pub system: &'a S,
    /// The accelerations of the prescribed speeds, rad/s² and m/s²; other entries are not read.
    pub u_dot: S::U,
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
