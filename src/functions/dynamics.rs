//! Forces and accelerations: inverse, forward and hybrid dynamics, and their parts.

use crate::{Real, System};

function_traits! {
    /// Generalized forces `tau` of the loads: `sum_K V_G_Kᵀ F_K + W_Kᵀ M_K`, N m and N. Eq. (36).
    ///
    /// Gravity is not included; it is in [`Bias`].
    "`{Self}` was generated without `generalized_forces`; name it in `functions`, alone and not in a sum, and generate again"
    GeneralizedForces: generalized_forces(q: &Self::Q, loads: &Self::Loads, tau: &mut Self::U);

    /// Right-hand side `f` of `M u_dot = f`: `generalized_forces - bias`, N m and N. Eq. (43).
    "`{Self}` was generated without `forcing`; name it in `functions`, alone and not in a sum, and generate again"
    Forcing: forcing(q: &Self::Q, u: &Self::U, loads: &Self::Loads, f: &mut Self::U);

    /// The terms of `M u_dot + bias = tau` without `u_dot` and `tau`: Coriolis, centrifugal and gyroscopic terms,
    /// weight, springs and dampers, N m and N. Also called the nonlinear effects.
    "`{Self}` was generated without `bias`; name it in `functions`, alone and not in a sum, and generate again"
    Bias: bias(q: &Self::Q, u: &Self::U, bias: &mut Self::U);

    /// The generalized forces `tau` that hold the system at rest against gravity alone, N m and N: the gravity
    /// part of [`Bias`], without springs. Often called the gravity torque, `g(q)`.
    "`{Self}` was generated without `gravity_forces`; name it in `functions`, alone and not in a sum, and generate again"
    GravityForces: gravity_forces(q: &Self::Q, tau: &mut Self::U);

    /// Inverse dynamics: the generalized forces `tau = M u_dot + bias` that a motion needs, N m and N. Often
    /// called by its algorithm, RNEA.
    "`{Self}` was generated without `inverse_dynamics`; name it in `functions`, alone and not in a sum, and generate again"
    InverseDynamics: inverse_dynamics(q: &Self::Q, u: &Self::U, u_dot: &Self::U, tau: &mut Self::U);

    /// Forward dynamics: the `u_dot` that solves `M u_dot + bias = tau`, rad/s² and m/s². Eq. (41); often
    /// called by its algorithm, ABA.
    ///
    /// If `M` is singular or indefinite (a massless body at the end of the tree, angles at
    /// their singularity), the result is infinite, NaN or simply wrong, without notice.
    /// [`checked::forward_dynamics`](crate::checked::forward_dynamics) checks first.
    "`{Self}` was generated without `forward_dynamics`; name it in `functions`, alone and not in a sum, and generate again"
    ForwardDynamics: forward_dynamics(q: &Self::Q, u: &Self::U, tau: &Self::U, u_dot: &mut Self::U);

    /// The pivots `D` of `M = Lᵀ D L`, one for each speed, in the units of the mass matrix's diagonal.
    ///
    /// All are positive if and only if the mass matrix is positive definite.
    "`{Self}` was generated without `forward_dynamics_pivots`; name it in `functions`, alone and not in a sum, and generate again"
    ForwardDynamicsPivots: forward_dynamics_pivots(q: &Self::Q, pivots: &mut Self::U);

    /// Inverse dynamics under loads: [`InverseDynamics`] minus the [`GeneralizedForces`] of the loads, N m and N. Often
    /// called RNEA with external forces.
    "`{Self}` was generated without `loaded_inverse_dynamics`; name it in `functions`, alone and not in a sum, and generate again"
    LoadedInverseDynamics: loaded_inverse_dynamics(q: &Self::Q, u: &Self::U, u_dot: &Self::U, loads: &Self::Loads, tau: &mut Self::U);

    /// Forward dynamics under loads: the `u_dot` that solves `M u_dot + bias = tau + generalized_forces`, rad/s² and m/s².
    /// Often called ABA with external forces.
    ///
    /// Nothing is checked, as in [`ForwardDynamics`].
    "`{Self}` was generated without `loaded_forward_dynamics`; name it in `functions`, alone and not in a sum, and generate again"
    LoadedForwardDynamics: loaded_forward_dynamics(q: &Self::Q, u: &Self::U, tau: &Self::U, loads: &Self::Loads, u_dot: &mut Self::U);
}

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
/// `tau` to be found are not read. If all speeds are prescribed it is [`InverseDynamics`], if none is it is [`ForwardDynamics`]. Nothing
/// is checked, as in [`ForwardDynamics`].
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
