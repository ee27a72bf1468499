//! Derivatives of forward, inverse and hybrid dynamics for controllers, one trait each.
//!
//! A module implements a trait if it was generated with the request in the trait's documentation, with these variables in this
//! order; the method is the generated function. Other derivatives are plain functions of the module, without a trait.
//!
//! Rows are entries of the output, columns entries of the variable: `du_dot_dq[i][j]`. A column of `q` belongs to a speed: it is the
//! derivative along the motion of that speed alone, per unit of its integral over time; in every chart the direction `d` of
//! [`q_plus`](crate::manifold::q_plus). Units are those of the output over those of the variable. Directions and gradients of `q`
//! also have one entry per speed. Parameters are in the order of [`Parametric::PARAMETER_NAMES`], each in the model's unit.

use crate::{Parametric, Real, System};

derivative_traits! {
    /// Derivatives of [`ForwardDynamics`](super::ForwardDynamics), `u_dot` by `q`, `u` and `tau`: `"d(forward_dynamics)/d(q, u, tau)"`.
    ///
    /// The derivative by `tau` is the inverse of the mass matrix. Eq. (41), differentiated.
    "`{Self}` was generated without `d(forward_dynamics)/d(q, u, tau)`; name it in `functions`, alone and not in a sum, and generate again"
    ForwardDynamicsDerivatives of System: d_forward_dynamics_d_q_u_tau(q: &Self::Q, u: &Self::U, tau: &Self::U, du_dot_dq: &mut Self::Matrix, du_dot_du: &mut Self::Matrix, du_dot_dtau: &mut Self::Matrix), "the last three arguments";

    /// [`ForwardDynamics`](super::ForwardDynamics) and its [derivatives](ForwardDynamicsDerivatives), which share their work:
    /// `"forward_dynamics + d(forward_dynamics)/d(q, u, tau)"`.
    "`{Self}` was generated without `forward_dynamics+d(forward_dynamics)/d(q, u, tau)`; name this sum in `functions`, in this order and with no other part, and generate again"
    ForwardDynamicsAndDerivatives of System: forward_dynamics_and_d_forward_dynamics_d_q_u_tau(q: &Self::Q, u: &Self::U, tau: &Self::U, u_dot: &mut Self::U, du_dot_dq: &mut Self::Matrix, du_dot_du: &mut Self::Matrix, du_dot_dtau: &mut Self::Matrix), "the last four arguments";

    /// Derivatives of [`ForwardDynamics`](super::ForwardDynamics) by all values set at run time: `"d(forward_dynamics)/d(parameters)"`.
    "`{Self}` was generated without `d(forward_dynamics)/d(parameters)`; name it in `functions`, alone and not in a sum, and generate again"
    ForwardDynamicsByParameters of Parametric: d_forward_dynamics_d_parameters(q: &Self::Q, u: &Self::U, tau: &Self::U, du_dot_dparameters: &mut Self::ByParameters), "the last argument";

    /// The directional derivative of [`ForwardDynamics`](super::ForwardDynamics): `"jvp(forward_dynamics; q, u, tau)"`.
    ///
    /// The [derivatives](ForwardDynamicsDerivatives) times the direction, without forming them.
    "`{Self}` was generated without `jvp(forward_dynamics; q, u, tau)`; name it in `functions`, alone and not in a sum, and generate again"
    ForwardDynamicsJvp of System: jvp_forward_dynamics_q_u_tau(q: &Self::Q, u: &Self::U, tau: &Self::U, q_direction: &Self::U, u_direction: &Self::U, tau_direction: &Self::U, du_dot: &mut Self::U), "the last argument";

    /// Like [`ForwardDynamicsJvp`], also along parameters: `"jvp(forward_dynamics; q, u, tau, parameters)"`.
    "`{Self}` was generated without `jvp(forward_dynamics; q, u, tau, parameters)`; name it in `functions`, alone and not in a sum, and generate again"
    ForwardDynamicsParametersJvp of Parametric: jvp_forward_dynamics_q_u_tau_parameters(q: &Self::Q, u: &Self::U, tau: &Self::U, q_direction: &Self::U, u_direction: &Self::U, tau_direction: &Self::U, parameters_direction: &Self::Values, du_dot: &mut Self::U), "the last argument";

    /// The gradient of `multiplier · u_dot` of [`ForwardDynamics`](super::ForwardDynamics): `"vjp(forward_dynamics; q, u, tau)"`.
    ///
    /// The multiplier times the [derivatives](ForwardDynamicsDerivatives), without forming them.
    "`{Self}` was generated without `vjp(forward_dynamics; q, u, tau)`; name it in `functions`, alone and not in a sum, and generate again"
    ForwardDynamicsVjp of System: vjp_forward_dynamics_q_u_tau(q: &Self::Q, u: &Self::U, tau: &Self::U, multiplier: &Self::U, q_gradient: &mut Self::U, u_gradient: &mut Self::U, tau_gradient: &mut Self::U), "the last three arguments";

    /// Like [`ForwardDynamicsVjp`], also by parameters: `"vjp(forward_dynamics; q, u, tau, parameters)"`.
    "`{Self}` was generated without `vjp(forward_dynamics; q, u, tau, parameters)`; name it in `functions`, alone and not in a sum, and generate again"
    ForwardDynamicsParametersVjp of Parametric: vjp_forward_dynamics_q_u_tau_parameters(q: &Self::Q, u: &Self::U, tau: &Self::U, multiplier: &Self::U, q_gradient: &mut Self::U, u_gradient: &mut Self::U, tau_gradient: &mut Self::U, parameters_gradient: &mut Self::Values), "the last four arguments";

    /// [`LoadedForwardDynamics`](super::LoadedForwardDynamics) and its derivatives by `q`, `u` and `tau`, for loads that stay:
    /// `"loaded_forward_dynamics + d(loaded_forward_dynamics)/d(q, u, tau)"`.
    ///
    /// With [`Loaded`](crate::conditions::Loaded), [`discrete`](crate::discrete) makes derivatives of steps of it.
    "`{Self}` was generated without `loaded_forward_dynamics+d(loaded_forward_dynamics)/d(q, u, tau)`; name this sum in `functions`, in this order and with no other part, and generate again"
    LoadedForwardDynamicsAndDerivatives of System: loaded_forward_dynamics_and_d_loaded_forward_dynamics_d_q_u_tau(q: &Self::Q, u: &Self::U, tau: &Self::U, loads: &Self::Loads, u_dot: &mut Self::U, du_dot_dq: &mut Self::Matrix, du_dot_du: &mut Self::Matrix, du_dot_dtau: &mut Self::Matrix), "the last four arguments";

    /// Like [`ForwardDynamicsJvp`], under loads that stay: `"jvp(loaded_forward_dynamics; q, u, tau)"`.
    "`{Self}` was generated without `jvp(loaded_forward_dynamics; q, u, tau)`; name it in `functions`, alone and not in a sum, and generate again"
    LoadedForwardDynamicsJvp of System: jvp_loaded_forward_dynamics_q_u_tau(q: &Self::Q, u: &Self::U, tau: &Self::U, loads: &Self::Loads, q_direction: &Self::U, u_direction: &Self::U, tau_direction: &Self::U, du_dot: &mut Self::U), "the last argument";

    /// Like [`ForwardDynamicsVjp`], under loads that stay: `"vjp(loaded_forward_dynamics; q, u, tau)"`.
    "`{Self}` was generated without `vjp(loaded_forward_dynamics; q, u, tau)`; name it in `functions`, alone and not in a sum, and generate again"
    LoadedForwardDynamicsVjp of System: vjp_loaded_forward_dynamics_q_u_tau(q: &Self::Q, u: &Self::U, tau: &Self::U, loads: &Self::Loads, multiplier: &Self::U, q_gradient: &mut Self::U, u_gradient: &mut Self::U, tau_gradient: &mut Self::U), "the last three arguments";

    /// [`HybridDynamics`](super::HybridDynamics) and its derivatives by `q`, `u` and `tau`, for accelerations that are given and stay:
    /// `"hybrid_dynamics + d(hybrid_dynamics)/d(q, u, tau)"`.
    ///
    /// With [`Driven`](crate::conditions::Driven), [`discrete`](crate::discrete) makes derivatives of steps of it.
    "`{Self}` was generated without `hybrid_dynamics+d(hybrid_dynamics)/d(q, u, tau)`; name this sum in `functions`, in this order and with no other part, and generate again"
    HybridDynamicsAndDerivatives of System: hybrid_dynamics_and_d_hybrid_dynamics_d_q_u_tau(q: &Self::Q, u: &Self::U, u_dot: &Self::U, tau: &Self::U, whole_u_dot: &mut Self::U, whole_tau: &mut Self::U, dwhole_u_dot_dq: &mut Self::Matrix, dwhole_u_dot_du: &mut Self::Matrix, dwhole_u_dot_dtau: &mut Self::Matrix, dwhole_tau_dq: &mut Self::Matrix, dwhole_tau_du: &mut Self::Matrix, dwhole_tau_dtau: &mut Self::Matrix), "the last eight arguments";

    /// The directional derivative of [`HybridDynamics`](super::HybridDynamics), for accelerations that are given and stay:
    /// `"jvp(hybrid_dynamics; q, u, tau)"`.
    "`{Self}` was generated without `jvp(hybrid_dynamics; q, u, tau)`; name it in `functions`, alone and not in a sum, and generate again"
    HybridDynamicsJvp of System: jvp_hybrid_dynamics_q_u_tau(q: &Self::Q, u: &Self::U, u_dot: &Self::U, tau: &Self::U, q_direction: &Self::U, u_direction: &Self::U, tau_direction: &Self::U, dwhole_u_dot: &mut Self::U, dwhole_tau: &mut Self::U), "the last two arguments";

    /// The gradient of the sum of both outputs of [`HybridDynamics`](super::HybridDynamics), each times a multiplier, for accelerations that are
    /// given and stay: `"vjp(hybrid_dynamics; q, u, tau)"`.
    "`{Self}` was generated without `vjp(hybrid_dynamics; q, u, tau)`; name it in `functions`, alone and not in a sum, and generate again"
    HybridDynamicsVjp of System: vjp_hybrid_dynamics_q_u_tau(q: &Self::Q, u: &Self::U, u_dot: &Self::U, tau: &Self::U, whole_u_dot_multiplier: &Self::U, whole_tau_multiplier: &Self::U, q_gradient: &mut Self::U, u_gradient: &mut Self::U, tau_gradient: &mut Self::U), "the last three arguments";

    /// Derivatives of [`InverseDynamics`](super::InverseDynamics), `tau` by `q`, `u` and `u_dot`: `"d(inverse_dynamics)/d(q, u, u_dot)"`.
    ///
    /// The derivative by `u_dot` is the mass matrix. `M u_dot + bias = tau`, differentiated.
    "`{Self}` was generated without `d(inverse_dynamics)/d(q, u, u_dot)`; name it in `functions`, alone and not in a sum, and generate again"
    InverseDynamicsDerivatives of System: d_inverse_dynamics_d_q_u_u_dot(q: &Self::Q, u: &Self::U, u_dot: &Self::U, dtau_dq: &mut Self::Matrix, dtau_du: &mut Self::Matrix, dtau_du_dot: &mut Self::Matrix), "the last three arguments";

    /// [`InverseDynamics`](super::InverseDynamics) and its [derivatives](InverseDynamicsDerivatives), which share their work:
    /// `"inverse_dynamics + d(inverse_dynamics)/d(q, u, u_dot)"`.
    "`{Self}` was generated without `inverse_dynamics+d(inverse_dynamics)/d(q, u, u_dot)`; name this sum in `functions`, in this order and with no other part, and generate again"
    InverseDynamicsAndDerivatives of System: inverse_dynamics_and_d_inverse_dynamics_d_q_u_u_dot(q: &Self::Q, u: &Self::U, u_dot: &Self::U, tau: &mut Self::U, dtau_dq: &mut Self::Matrix, dtau_du: &mut Self::Matrix, dtau_du_dot: &mut Self::Matrix), "the last four arguments";

    /// Derivatives of [`InverseDynamics`](super::InverseDynamics) by all values set at run time: `"d(inverse_dynamics)/d(parameters)"`.
    "`{Self}` was generated without `d(inverse_dynamics)/d(parameters)`; name it in `functions`, alone and not in a sum, and generate again"
    InverseDynamicsByParameters of Parametric: d_inverse_dynamics_d_parameters(q: &Self::Q, u: &Self::U, u_dot: &Self::U, dtau_dparameters: &mut Self::ByParameters), "the last argument";

    /// The directional derivative of [`InverseDynamics`](super::InverseDynamics): `"jvp(inverse_dynamics; q, u, u_dot)"`.
    ///
    /// The [derivatives](InverseDynamicsDerivatives) times the direction, without forming them.
    "`{Self}` was generated without `jvp(inverse_dynamics; q, u, u_dot)`; name it in `functions`, alone and not in a sum, and generate again"
    InverseDynamicsJvp of System: jvp_inverse_dynamics_q_u_u_dot(q: &Self::Q, u: &Self::U, u_dot: &Self::U, q_direction: &Self::U, u_direction: &Self::U, u_dot_direction: &Self::U, dtau: &mut Self::U), "the last argument";

    /// Like [`InverseDynamicsJvp`], also along parameters: `"jvp(inverse_dynamics; q, u, u_dot, parameters)"`.
    "`{Self}` was generated without `jvp(inverse_dynamics; q, u, u_dot, parameters)`; name it in `functions`, alone and not in a sum, and generate again"
    InverseDynamicsParametersJvp of Parametric: jvp_inverse_dynamics_q_u_u_dot_parameters(q: &Self::Q, u: &Self::U, u_dot: &Self::U, q_direction: &Self::U, u_direction: &Self::U, u_dot_direction: &Self::U, parameters_direction: &Self::Values, dtau: &mut Self::U), "the last argument";

    /// The gradient of `multiplier · tau` of [`InverseDynamics`](super::InverseDynamics): `"vjp(inverse_dynamics; q, u, u_dot)"`.
    ///
    /// The multiplier times the [derivatives](InverseDynamicsDerivatives), without forming them.
    "`{Self}` was generated without `vjp(inverse_dynamics; q, u, u_dot)`; name it in `functions`, alone and not in a sum, and generate again"
    InverseDynamicsVjp of System: vjp_inverse_dynamics_q_u_u_dot(q: &Self::Q, u: &Self::U, u_dot: &Self::U, multiplier: &Self::U, q_gradient: &mut Self::U, u_gradient: &mut Self::U, u_dot_gradient: &mut Self::U), "the last three arguments";

    /// Like [`InverseDynamicsVjp`], also by parameters: `"vjp(inverse_dynamics; q, u, u_dot, parameters)"`.
    "`{Self}` was generated without `vjp(inverse_dynamics; q, u, u_dot, parameters)`; name it in `functions`, alone and not in a sum, and generate again"
    InverseDynamicsParametersVjp of Parametric: vjp_inverse_dynamics_q_u_u_dot_parameters(q: &Self::Q, u: &Self::U, u_dot: &Self::U, multiplier: &Self::U, q_gradient: &mut Self::U, u_gradient: &mut Self::U, u_dot_gradient: &mut Self::U, parameters_gradient: &mut Self::Values), "the last four arguments";
}
