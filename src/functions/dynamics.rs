//! Dynamics that write two outputs.

use crate::{Real, System};

/// The force and moment that each joint transmits from the lower body to its body, for sizing bearings and structures.
///
/// `force`, N, and `moment`, N m, are body components, about the point of the body where its joint sits: its origin, or its
/// `body_attachment` if it has one. They include weight and the loads on all bodies outward of the joint, and the motors,
/// springs and dampers that act through the joint. Often called joint reactions.
#[diagnostic::on_unimplemented(
    message = "`{Self}` was generated without `joint_wrenches`; name it in `functions`, alone and not in a sum, and generate again"
)]
pub trait JointWrenches<R: Real>: System<R> {
    /// Overwrites `force` and `moment`; meaning, frame and unit are those of [`JointWrenches`].
    fn joint_wrenches(
        &self,
        q: &Self::Q,
        u: &Self::U,
        u_dot: &Self::U,
        loads: &Self::Loads,
        force: &mut Self::Vectors,
        moment: &mut Self::Vectors,
    );
}

/// Hybrid dynamics: finds the forces of the speeds with given accelerations, and the accelerations of the speeds with given forces.
///
/// `M u_dot + bias = tau` holds for the whole `u_dot`, rad/s² and m/s², and the whole `tau`, N m and N. Eqs. (41), (43).
/// The generator's option `prescribed` selects the speeds with given accelerations. Given entries are copied; entries of `u_dot` and
/// `tau` to be found are not read. If all speeds are prescribed it is [`InverseDynamics`](super::InverseDynamics), if none is it is [`ForwardDynamics`](super::ForwardDynamics). Nothing
/// is checked, as in [`ForwardDynamics`](super::ForwardDynamics).
#[diagnostic::on_unimplemented(
    message = "`{Self}` was generated without `hybrid_dynamics`; name it in `functions`, alone and not in a sum, and generate again"
)]
pub trait HybridDynamics<R: Real>: System<R> {
    /// For each of the `NU` speeds: true if its acceleration is given.
    const PRESCRIBED: &'static [bool];
    /// Overwrites `whole_u_dot` and `whole_tau`; meaning, frame and unit are those of [`HybridDynamics`].
    fn hybrid_dynamics(
        &self,
        q: &Self::Q,
        u: &Self::U,
        u_dot: &Self::U,
        tau: &Self::U,
        whole_u_dot: &mut Self::U,
        whole_tau: &mut Self::U,
    );
}
