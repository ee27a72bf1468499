//! One small trait for each function that a generated module may hold.
//!
//! A method takes those of `q`, `u`, `u_dot`, `tau` and `loads` that the function needs, in this order. It overwrites each of its last
//! arguments whole. `self` is the module's `Prepared<R>`. No function fails, panics or allocates; the results are whatever IEEE
//! arithmetic gives. Generic code names the functions that it needs as bounds: `S: MassMatrix<R> + Bias<R>`.
//!
//! `K` is a body, `J` its lower body (parent), 0 the inertial frame. Equation numbers are those of a set of lecture notes, called *the
//! notes* here: J. W. Kamman,
//! *Multibody Dynamics: Equations of Motion for Unconstrained Systems Using Relative Coordinates with Orientation Angles*.
//!
//! | trait | method | output | equation |
//! | --- | --- | --- | --- |
//! | [`RelativeRotation`] | `relative_rotation(q, out)` | `Rotations` | (4) |
//! | [`Rotation`] | `rotation(q, out)` | `Rotations` | (2)-(5) |
//! | [`RelativeAngularVelocity`] | `relative_angular_velocity(q, u, out)` | `Vectors` | (8) |
//! | [`AngularVelocity`] | `angular_velocity(q, u, out)` | `Vectors` | (11) |
//! | [`AngleRates`] | `angle_rates(q, w_rel, out)` | `Vectors` | (9) |
//! | [`AngularAcceleration`] | `angular_acceleration(q, u, u_dot, out)` | `Vectors` | below (19) |
//! | [`PartialAngularVelocity`] | `partial_angular_velocity(q, columns)` | `PartialAngularVelocityColumns`, pattern `PARTIAL_ANGULAR_VELOCITY_BLOCKS` | (15)-(17) |
//! | [`PartialAngularVelocityDot`] | `partial_angular_velocity_dot(q, u, columns)` | `PartialAngularVelocityDotColumns`, `PARTIAL_ANGULAR_VELOCITY_DOT_BLOCKS` | (20) |
//! | [`OriginPosition`] | `origin_position(q, out)` | `Vectors` | (22) |
//! | [`MassCenterPosition`] | `mass_center_position(q, out)` | `Vectors` | (23) |
//! | [`OriginVelocity`] | `origin_velocity(q, u, out)` | `Vectors` | (25) |
//! | [`MassCenterVelocity`] | `mass_center_velocity(q, u, out)` | `Vectors` | (27) |
//! | [`PartialVelocityOrigin`] | `partial_velocity_origin(q, columns)` | `PartialVelocityOriginColumns`, `PARTIAL_VELOCITY_ORIGIN_BLOCKS` | (28)-(30) |
//! | [`PartialVelocityOriginDot`] | `partial_velocity_origin_dot(q, u, columns)` | `PartialVelocityOriginDotColumns`, `PARTIAL_VELOCITY_ORIGIN_DOT_BLOCKS` | (34) |
//! | [`PartialVelocity`] | `partial_velocity(q, columns)` | `PartialVelocityColumns`, `PARTIAL_VELOCITY_BLOCKS` | (32) |
//! | [`PartialVelocityDot`] | `partial_velocity_dot(q, u, columns)` | `PartialVelocityDotColumns`, `PARTIAL_VELOCITY_DOT_BLOCKS` | (33) |
//! | [`MassCenterAcceleration`] | `mass_center_acceleration(q, u, u_dot, out)` | `Vectors` | before (33) |
//! | [`GeneralizedForces`] | `generalized_forces(q, loads, tau)` | `U` | (36) |
//! | [`MassMatrix`] | `mass_matrix(q, m)` | `Matrix` | (42) |
//! | [`MassMatrixPacked`] | `mass_matrix_packed(q, entries)` | `Entries`, `PLACES` | (42) |
//! | [`Forcing`] | `forcing(q, u, loads, f)` | `U` | (43) |
//! | [`Bias`] | `bias(q, u, bias)` | `U` | `M u_dot + bias = tau` |
//! | [`GravityForces`] | `gravity_forces(q, tau)` | `U` | (36), of weight |
//! | [`InverseDynamics`] | `inverse_dynamics(q, u, u_dot, tau)` | `U` | `M u_dot + bias = tau` |
//! | [`ForwardDynamics`] | `forward_dynamics(q, u, tau, u_dot)` | `U` | (41) |
//! | [`ForwardDynamicsPivots`] | `forward_dynamics_pivots(q, pivots)` | `U` | `M = Lᵀ D L` |
//! | [`Singularity`] | `singularity(q, distances)` | `Scalars` | (9) |
//! | [`KineticEnergy`] | `kinetic_energy(q, u, energy)` | `R` | |
//! | [`PotentialEnergy`] | `potential_energy(q, energy)` | `R` | |
//! | [`LinearMomentum`] | `linear_momentum(q, u, out)` | `[R; 3]` | |
//! | [`AngularMomentum`] | `angular_momentum(q, u, out)` | `[R; 3]` | |
//! | [`MassMatrixProduct`] | `mass_matrix_product(q, u_dot, tau)` | `U` | (42) |
//! | [`MassMatrixSolve`] | `mass_matrix_solve(q, tau, u_dot)` | `U` | (42) |
//! | [`MassMatrixInverse`] | `mass_matrix_inverse(q, inverse)` | `Matrix` | (42) |
//! | [`MassMatrixInversePacked`] | `mass_matrix_inverse_packed(q, entries)` | `Entries`, `PLACES` | (42) |
//! | [`MassMatrixFactors`] | `mass_matrix_factors(q, entries)` | `Entries`, `PLACES`, `ORDER` | `M = Lᵀ D L` |
//! | [`CoriolisMatrix`] | `coriolis_matrix(q, u, c)` | `Matrix` | (15), (20), (32), (33) |
//! | [`MassMatrixDot`] | `mass_matrix_dot(q, u, m_dot)` | `Matrix` | `M_dot = C + Cᵀ` |
//! | [`LoadedInverseDynamics`] | `loaded_inverse_dynamics(q, u, u_dot, loads, tau)` | `U` | (36), (43) |
//! | [`LoadedForwardDynamics`] | `loaded_forward_dynamics(q, u, tau, loads, u_dot)` | `U` | (36), (41) |
//! | [`KineticEnergies`] | `kinetic_energies(q, u, energies)` | `Scalars` | |
//! | [`PotentialEnergies`] | `potential_energies(q, energies)` | `Scalars` | |
//! | [`JointWrenches`] | `joint_wrenches(q, u, u_dot, loads, force, moment)` | `Vectors`, `Vectors` | |
//! | [`HybridDynamics`] | `hybrid_dynamics(q, u, u_dot, tau, whole_u_dot, whole_tau)` | `U`, `U`, `PRESCRIBED` | (41), (43) |
//! | [`CenterOfMass`] | `center_of_mass(q, position)` | `[R; 3]` | (23) |
//! | [`CenterOfMassVelocity`] | `center_of_mass_velocity(q, u, velocity)` | `[R; 3]` | (27) |
//! | [`CenterOfMassJacobian`] | `center_of_mass_jacobian(q, jacobian)` | `[U; 3]` | (32) |
//! | [`CenterOfMassJacobianDotU`] | `center_of_mass_jacobian_dot_u(q, u, acceleration)` | `[R; 3]` | before (33) |
//! | [`CentroidalMomentumMatrix`] | `centroidal_momentum_matrix(q, linear, angular)` | `[U; 3]`, `[U; 3]` | (15), (32) |
//! | [`CentroidalMomentumMatrixDotU`] | `centroidal_momentum_matrix_dot_u(q, u, linear, angular)` | `[R; 3]`, `[R; 3]` | before (33) |
//! | [`InertialParameters`] | `inertial_parameters(pi)` | `Inertial` | |
//! | [`BaseParameters`] | `base_parameters(pi)` | `Base` | |
//! | [`Regressor`] | `regressor(q, u, u_dot, y)` | `Row`, `Rows` | (36), (43) |
//! | [`RegressorPacked`] | `regressor_packed(q, u, u_dot, y)` | `Entries`, `PLACES` | (36), (43) |
//! | [`BaseRegressor`] | `base_regressor(q, u, u_dot, y)` | `Row`, `Rows`, `NAMES`, `TERMS` | (36), (43) |
//! | [`JointRegressor`] | `joint_regressor(q, u, u_dot, y)` | `Terms` | |
//! | [`Pose`] of a frame | `pose(q, rotation, position)` | `[[R; 3]; 3]`, `[R; 3]` | (3), (22) |
//! | [`Position`] of a frame | `position(q, position)` | `[R; 3]` | (22) |
//! | [`Velocity`] of a frame | `velocity(q, u, linear, angular)` | `[R; 3]`, `[R; 3]` | (25), (11) |
//! | [`LinearVelocity`] of a frame | `linear_velocity(q, u, linear)` | `[R; 3]` | (25) |
//! | [`Acceleration`] of a frame | `acceleration(q, u, u_dot, linear, angular)` | `[R; 3]`, `[R; 3]` | before (33) |
//! | [`LinearAcceleration`] of a frame | `linear_acceleration(q, u, u_dot, linear)` | `[R; 3]` | before (33) |
//! | [`Jacobian`] of a frame | `jacobian(q, linear, angular)` | `[U; 3]`, `[U; 3]`, `SPEEDS` | (28), (15) |
//! | [`JacobianPacked`] of a frame | `jacobian_packed(q, linear, angular)` | `[Columns; 3]`, `[Columns; 3]`, `SPEEDS` | (28), (15) |
//! | [`PointJacobian`] of a frame | `point_jacobian(q, point, linear, angular)` | `[U; 3]`, `[U; 3]`, `SPEEDS` | (28), (15) |
//! | [`LinearJacobian`] of a frame | `linear_jacobian(q, linear)` | `[U; 3]`, `SPEEDS` | (28) |
//! | [`LinearJacobianPacked`] of a frame | `linear_jacobian_packed(q, linear)` | `[Columns; 3]`, `SPEEDS` | (28) |
//! | [`JacobianDotU`] of a frame | `jacobian_dot_u(q, u, linear, angular)` | `[R; 3]`, `[R; 3]` | (34), (20) |
//! | [`LinearJacobianDotU`] of a frame | `linear_jacobian_dot_u(q, u, linear)` | `[R; 3]` | (34) |
//! | [`GeneralizedForce`] of a frame | `generalized_force(q, force, moment, tau)` | `U` | (36) |
//! | [`LinearGeneralizedForce`] of a frame | `linear_generalized_force(q, force, tau)` | `U` | (36) |
//! | [`OperationalInverseInertia`] of frames | `operational_inverse_inertia(q, inverse_inertia)` | `Row`, `Rows` | `J M⁻¹ Jᵀ` |
//! | [`LinearOperationalInverseInertia`] of frames | `linear_operational_inverse_inertia(q, inverse_inertia)` | `Row`, `Rows` | `J M⁻¹ Jᵀ` |
//! | [`Imu`] of a frame | `imu(q, u, u_dot, specific_force, angular_velocity)` | `[R; 3]`, `[R; 3]` | before (33) |
//!
//! Derivatives of forward and inverse dynamics have traits too. Each names its request:
//!
//! | derivatives | of forward dynamics | of inverse dynamics |
//! | --- | --- | --- |
//! | by `q`, `u`, and `tau` or `u_dot` | [`ForwardDynamicsDerivatives`] | [`InverseDynamicsDerivatives`] |
//! | the same, with the values | [`ForwardDynamicsAndDerivatives`] | [`InverseDynamicsAndDerivatives`] |
//! | times a direction | [`ForwardDynamicsJvp`] | [`InverseDynamicsJvp`] |
//! | a multiplier times these | [`ForwardDynamicsVjp`] | [`InverseDynamicsVjp`] |
//! | by the parameters | [`ForwardDynamicsByParameters`] | [`InverseDynamicsByParameters`] |
//! | times a direction, of the parameters too | [`ForwardDynamicsParametersJvp`] | [`InverseDynamicsParametersJvp`] |
//! | a multiplier times these | [`ForwardDynamicsParametersVjp`] | [`InverseDynamicsParametersVjp`] |
//!
//! Under loads that stay, forward dynamics have [`LoadedForwardDynamicsAndDerivatives`], [`LoadedForwardDynamicsJvp`] and [`LoadedForwardDynamicsVjp`];
//! hybrid dynamics have [`HybridDynamicsAndDerivatives`], [`HybridDynamicsJvp`] and [`HybridDynamicsVjp`].
//! Those with `Parameters` in their names need a [`Parametric`](crate::Parametric) system, which makes systems from arrays of values.
//!
//! ```
//! use kane::functions::{Bias, MassMatrix};
//! use kane::{Array, Real};
//!
//! /// `tau = M u_dot + bias`, for any system.
//! fn computed_torque<R: Real, S: MassMatrix<R> + Bias<R>>(
//!     system: &S,
//!     q: &S::Q,
//!     u: &S::U,
//!     u_dot: &S::U,
//! ) -> S::U {
//!     let zero = S::U::filled(R::from_f64(0.0));
//!     let (mut m, mut tau) = (S::Matrix::filled(zero), zero);
//!     system.mass_matrix(q, &mut m);
//!     system.bias(q, u, &mut tau);
//!     for (tau, row) in tau.as_mut().iter_mut().zip(m.as_ref()) {
//!         for (entry, u_dot) in row.as_ref().iter().zip(u_dot.as_ref()) {
//!             *tau = *tau + *entry * *u_dot;
//!         }
//!     }
//!     tau
//! }
//! # #[cfg(feature = "eight_body")] {
//! # use kane::{eight_body::{NQ, NU, Prepared}, functions::InverseDynamics};
//! # let system = Prepared::<f64>::nominal();
//! # let (q, u, u_dot) = ([0.1; NQ], [0.2; NU], [0.3; NU]);
//! # let mut tau = [0.0; NU];
//! # system.inverse_dynamics(&q, &u, &u_dot, &mut tau);
//! # let found = computed_torque(&system, &q, &u, &u_dot);
//! # assert!(found.iter().zip(tau).all(|(a, b)| (a - b).abs() < 1e-10));
//! # }
//! ```

// Its macros are for what stands after it.
#[macro_use]
mod define;

mod center;
mod derivatives;
mod dynamics;
mod energy;
mod frames;
mod kinematics;
mod linear;
mod matrices;
mod regressors;

pub use center::{
    CenterOfMass, CenterOfMassJacobian, CenterOfMassJacobianDotU, CenterOfMassVelocity,
    CentroidalMomentumMatrix, CentroidalMomentumMatrixDotU,
};
pub use derivatives::{
    ForwardDynamicsAndDerivatives, ForwardDynamicsByParameters, ForwardDynamicsDerivatives,
    ForwardDynamicsJvp, ForwardDynamicsParametersJvp, ForwardDynamicsParametersVjp,
    ForwardDynamicsVjp, HybridDynamicsAndDerivatives, HybridDynamicsJvp, HybridDynamicsVjp,
    InverseDynamicsAndDerivatives, InverseDynamicsByParameters, InverseDynamicsDerivatives,
    InverseDynamicsJvp, InverseDynamicsParametersJvp, InverseDynamicsParametersVjp,
    InverseDynamicsVjp, LoadedForwardDynamicsAndDerivatives, LoadedForwardDynamicsJvp,
    LoadedForwardDynamicsVjp,
};
pub use dynamics::{
    Bias, Forcing, ForwardDynamics, ForwardDynamicsPivots, GeneralizedForces, GravityForces,
    HybridDynamics, InverseDynamics, JointWrenches, LoadedForwardDynamics, LoadedInverseDynamics,
};
pub use energy::{
    AngularMomentum, KineticEnergies, KineticEnergy, LinearMomentum, PotentialEnergies,
    PotentialEnergy,
};
pub use frames::{
    Acceleration, GeneralizedForce, Imu, Jacobian, JacobianDotU, JacobianPacked, Local,
    OperationalInverseInertia, PointJacobian, Pose, Seen, Velocity,
};
pub use kinematics::{
    AngleRates, AngularAcceleration, AngularVelocity, MassCenterAcceleration, MassCenterPosition,
    MassCenterVelocity, OriginPosition, OriginVelocity, PartialAngularVelocity,
    PartialAngularVelocityDot, PartialVelocity, PartialVelocityDot, PartialVelocityOrigin,
    PartialVelocityOriginDot, RelativeAngularVelocity, RelativeRotation, Rotation, Singularity,
};
pub use linear::{
    LinearAcceleration, LinearGeneralizedForce, LinearJacobian, LinearJacobianDotU,
    LinearJacobianPacked, LinearOperationalInverseInertia, LinearVelocity, Position,
};
pub use matrices::{
    CoriolisMatrix, MassMatrix, MassMatrixDot, MassMatrixFactors, MassMatrixInverse,
    MassMatrixInversePacked, MassMatrixPacked, MassMatrixProduct, MassMatrixSolve, solve_factored,
    unpack,
};
pub use regressors::{
    BaseParameters, BaseRegressor, InertialParameters, JointRegressor, Regressor, RegressorPacked,
};
