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

use crate::{Array, Block, Real, System};

// Its macros are for what stands after it.
#[macro_use]
mod define;
mod matrices;

pub use matrices::{
    CoriolisMatrix, MassMatrixDot, MassMatrixFactors, MassMatrixInverse, MassMatrixInversePacked,
    MassMatrixProduct, MassMatrixSolve, solve_factored,
};

function_traits! {
    /// Rotation matrix `JR_K` of each body: components in `J` to components in `K`. Eq. (4).
    "`{Self}` was generated without `relative_rotation`; name it in `functions`, alone and not in a sum, and generate again"
    RelativeRotation: relative_rotation(q: &Self::Q, out: &mut Self::Rotations);

    /// Rotation matrix `R_K` of each body: inertial components to components in `K`. Eqs. (2)-(5).
    ///
    /// Its transpose turns body components into inertial ones.
    "`{Self}` was generated without `rotation`; name it in `functions`, alone and not in a sum, and generate again"
    Rotation: rotation(q: &Self::Q, out: &mut Self::Rotations);

    /// Angular velocity of each body relative to its lower body, body components, rad/s. Eq. (8).
    "`{Self}` was generated without `relative_angular_velocity`; name it in `functions`, alone and not in a sum, and generate again"
    RelativeAngularVelocity: relative_angular_velocity(q: &Self::Q, u: &Self::U, out: &mut Self::Vectors);

    /// Angular velocity `w_K` of each body in the inertial frame, body components, rad/s. Eq. (11).
    "`{Self}` was generated without `angular_velocity`; name it in `functions`, alone and not in a sum, and generate again"
    AngularVelocity: angular_velocity(q: &Self::Q, u: &Self::U, out: &mut Self::Vectors);

    /// Rates of the three angles of each body from its relative angular velocity (body components, rad/s):
    /// the inverse of Eq. (8), Eq. (9), rad/s.
    ///
    /// For bodies with all three angles free. Singular at `cos(theta_2) = 0`, where it gives huge numbers, infinities
    /// or NaN; [`Singularity`] gives the distance from that.
    "`{Self}` was generated without `angle_rates`; name it in `functions`, alone and not in a sum, and generate again"
    AngleRates: angle_rates(q: &Self::Q, w_rel: &Self::Vectors, out: &mut Self::Vectors);

    /// Angular acceleration of each body in the inertial frame, body components, rad/s². Below Eq. (19).
    "`{Self}` was generated without `angular_acceleration`; name it in `functions`, alone and not in a sum, and generate again"
    AngularAcceleration: angular_acceleration(q: &Self::Q, u: &Self::U, u_dot: &Self::U, out: &mut Self::Vectors);
}

partial_traits! {
    /// Partial angular velocities `W_K` of each body: `w_K = W_K u`, body components, rad/s per unit of each speed. Eqs. (15)-(17).
    "`{Self}` was generated without `partial_angular_velocity`; name it in `functions`, alone and not in a sum, and generate again"
    PartialAngularVelocity: partial_angular_velocity(q: &Self::Q), PartialAngularVelocityColumns, PARTIAL_ANGULAR_VELOCITY_BLOCKS;

    /// Time derivatives of the partial angular velocities, `W_dot_K`, taken in body `K`, body components, rad/s² per unit of each speed. Eq. (20).
    "`{Self}` was generated without `partial_angular_velocity_dot`; name it in `functions`, alone and not in a sum, and generate again"
    PartialAngularVelocityDot: partial_angular_velocity_dot(q: &Self::Q, u: &Self::U), PartialAngularVelocityDotColumns, PARTIAL_ANGULAR_VELOCITY_DOT_BLOCKS;
}

function_traits! {
    /// Position of each body's origin `O_K` from the inertial origin, body components, m. Eq. (22).
    "`{Self}` was generated without `origin_position`; name it in `functions`, alone and not in a sum, and generate again"
    OriginPosition: origin_position(q: &Self::Q, out: &mut Self::Vectors);

    /// Position of each body's mass centre `G_K` from the inertial origin, body components, m. Eq. (23).
    "`{Self}` was generated without `mass_center_position`; name it in `functions`, alone and not in a sum, and generate again"
    MassCenterPosition: mass_center_position(q: &Self::Q, out: &mut Self::Vectors);

    /// Velocity of each body's origin `O_K` in the inertial frame, **lower-body** components, m/s. Eq. (25).
    ///
    /// For a root these are inertial components.
    "`{Self}` was generated without `origin_velocity`; name it in `functions`, alone and not in a sum, and generate again"
    OriginVelocity: origin_velocity(q: &Self::Q, u: &Self::U, out: &mut Self::Vectors);

    /// Velocity of each body's mass centre `G_K` in the inertial frame, body components, m/s. Eq. (27).
    "`{Self}` was generated without `mass_center_velocity`; name it in `functions`, alone and not in a sum, and generate again"
    MassCenterVelocity: mass_center_velocity(q: &Self::Q, u: &Self::U, out: &mut Self::Vectors);
}

partial_traits! {
    /// Partial velocities `V_O_K` of each body's origin: `v_O_K = V_O_K u`, **lower-body** components, m/s per unit of each speed.
    /// Eqs. (28)-(30).
    "`{Self}` was generated without `partial_velocity_origin`; name it in `functions`, alone and not in a sum, and generate again"
    PartialVelocityOrigin: partial_velocity_origin(q: &Self::Q), PartialVelocityOriginColumns, PARTIAL_VELOCITY_ORIGIN_BLOCKS;

    /// Time derivatives of the origins' partial velocities, `V_O_dot_K`, **lower-body** components, m/s² per unit of each speed. Eq. (34).
    "`{Self}` was generated without `partial_velocity_origin_dot`; name it in `functions`, alone and not in a sum, and generate again"
    PartialVelocityOriginDot: partial_velocity_origin_dot(q: &Self::Q, u: &Self::U), PartialVelocityOriginDotColumns, PARTIAL_VELOCITY_ORIGIN_DOT_BLOCKS;

    /// Partial velocities `V_G_K` of each body's mass centre: `v_G_K = V_G_K u`, body components, m/s per unit of each speed. Eq. (32).
    "`{Self}` was generated without `partial_velocity`; name it in `functions`, alone and not in a sum, and generate again"
    PartialVelocity: partial_velocity(q: &Self::Q), PartialVelocityColumns, PARTIAL_VELOCITY_BLOCKS;

    /// Time derivatives of the mass centres' partial velocities, `V_G_dot_K`, body components, m/s² per unit of each speed. Eq. (33).
    "`{Self}` was generated without `partial_velocity_dot`; name it in `functions`, alone and not in a sum, and generate again"
    PartialVelocityDot: partial_velocity_dot(q: &Self::Q, u: &Self::U), PartialVelocityDotColumns, PARTIAL_VELOCITY_DOT_BLOCKS;
}

function_traits! {
    /// Acceleration of each body's mass centre in the inertial frame, body components, m/s². Before Eq. (33).
    ///
    /// The kinematic acceleration, without gravity: zero for a system at rest, `g` for one in free fall.
    "`{Self}` was generated without `mass_center_acceleration`; name it in `functions`, alone and not in a sum, and generate again"
    MassCenterAcceleration: mass_center_acceleration(q: &Self::Q, u: &Self::U, u_dot: &Self::U, out: &mut Self::Vectors);

    /// Generalized forces `tau` of the loads: `sum_K V_G_Kᵀ F_K + W_Kᵀ M_K`, N m and N. Eq. (36).
    ///
    /// Gravity is not included; it is in [`Bias`].
    "`{Self}` was generated without `generalized_forces`; name it in `functions`, alone and not in a sum, and generate again"
    GeneralizedForces: generalized_forces(q: &Self::Q, loads: &Self::Loads, tau: &mut Self::U);
}

/// Mass matrix `M` (`A` in the notes), symmetric, written whole, `m[row][column]`. Eq. (42); often called
/// the joint-space inertia matrix or, by its algorithm, CRBA.
///
/// Units kg m², kg m and kg, depending on the units of the two speeds.
#[diagnostic::on_unimplemented(
    message = "`{Self}` was generated without `mass_matrix`; name it in `functions`, alone and not in a sum, and generate again"
)]
pub trait MassMatrix<R: Real>: System<R> {
    /// Overwrites the last argument; meaning, frame and unit are those of [`MassMatrix`].
    fn mass_matrix(&self, q: &Self::Q, m: &mut Self::Matrix);
}

/// The entries of the [`MassMatrix`] on and below the diagonal that are not structurally zero, row by row. Eq. (42).
///
/// Entries of two speeds that move no common body are left out. For a humanoid a quarter of the matrix remains, in the form that
/// sparse solvers along the tree use. [`unpack`] makes the whole matrix.
#[diagnostic::on_unimplemented(
    message = "`{Self}` was generated without `mass_matrix_packed`; name it in `functions`, alone and not in a sum, and generate again"
)]
pub trait MassMatrixPacked<R: Real>: System<R> {
    /// `[R; n]`, one entry for each place.
    type Entries: Array<R>;
    /// The row and the column of each entry, column not above row; ordered by row, within a row by column.
    const PLACES: &'static [[usize; 2]];
    /// Overwrites the last argument; meaning, frame and unit are those of [`MassMatrix`].
    fn mass_matrix_packed(&self, q: &Self::Q, entries: &mut Self::Entries);
}

/// Writes the whole symmetric matrix with these `entries` at these `places`; all other entries become zero.
///
/// For packed mass matrices and their inverses, and for second derivatives. Entries without a place, and places outside the matrix, are
/// ignored.
pub fn unpack<R: Real, Row: Array<R>>(
    entries: &[R],
    places: &[[usize; 2]],
    m: &mut impl Array<Row>,
) {
    let rows = m.as_mut();
    for row in rows.iter_mut() {
        *row = Row::filled(R::from_f64(0.0));
    }
    for (&entry, &[row, column]) in entries.iter().zip(places) {
        for [row, column] in [[row, column], [column, row]] {
            let place = rows
                .get_mut(row)
                .and_then(|row| row.as_mut().get_mut(column));
            if let Some(place) = place {
                *place = entry;
            }
        }
    }
}

function_traits! {
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

    /// How far each body's angles are from their singularity: `|cos(theta_2)|` where `theta_1` and
    /// `theta_3` are both free, 1 elsewhere. Eq. (9).
    "`{Self}` was generated without `singularity`; name it in `functions`, alone and not in a sum, and generate again"
    Singularity: singularity(q: &Self::Q, distances: &mut Self::Scalars);

    /// Kinetic energy in the inertial frame, J.
    "`{Self}` was generated without `kinetic_energy`; name it in `functions`, alone and not in a sum, and generate again"
    KineticEnergy: kinetic_energy(q: &Self::Q, u: &Self::U, energy: &mut R);

    /// Potential energy, J: that of weight, zero at the inertial origin, and that of springs, zero at rest.
    "`{Self}` was generated without `potential_energy`; name it in `functions`, alone and not in a sum, and generate again"
    PotentialEnergy: potential_energy(q: &Self::Q, energy: &mut R);

    /// Linear momentum of the whole system, inertial components, kg m/s.
    "`{Self}` was generated without `linear_momentum`; name it in `functions`, alone and not in a sum, and generate again"
    LinearMomentum: linear_momentum(q: &Self::Q, u: &Self::U, out: &mut [R; 3]);

    /// Angular momentum of the whole system about the inertial origin, inertial components, kg m²/s.
    "`{Self}` was generated without `angular_momentum`; name it in `functions`, alone and not in a sum, and generate again"
    AngularMomentum: angular_momentum(q: &Self::Q, u: &Self::U, out: &mut [R; 3]);
}

function_traits! {
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

    /// Kinetic energy of each body in the inertial frame, including the rotors of its joint, J.
    "`{Self}` was generated without `kinetic_energies`; name it in `functions`, alone and not in a sum, and generate again"
    KineticEnergies: kinetic_energies(q: &Self::Q, u: &Self::U, energies: &mut Self::Scalars);

    /// Potential energy of each body, including the springs of its joint, J: that of weight is zero at the inertial
    /// origin, that of a spring at rest.
    "`{Self}` was generated without `potential_energies`; name it in `functions`, alone and not in a sum, and generate again"
    PotentialEnergies: potential_energies(q: &Self::Q, energies: &mut Self::Scalars);
}

function_traits! {
    /// Mass centre of all bodies from the inertial origin, inertial components, m. Often called the centre of mass, `CoM`.
    ///
    /// Mass fixed to the inertial frame does not count. If the model has no mass it is the inertial origin; if all masses are
    /// zero only at run time, it is NaN.
    "`{Self}` was generated without `center_of_mass`; name it in `functions`, alone and not in a sum, and generate again"
    CenterOfMass: center_of_mass(q: &Self::Q, position: &mut [R; 3]);

    /// Velocity of the mass centre of all bodies in the inertial frame, inertial components, m/s.
    "`{Self}` was generated without `center_of_mass_velocity`; name it in `functions`, alone and not in a sum, and generate again"
    CenterOfMassVelocity: center_of_mass_velocity(q: &Self::Q, u: &Self::U, velocity: &mut [R; 3]);

    /// Partial velocities of the mass centre of all bodies, inertial components, `jacobian[component][speed]`, m/s per unit of
    /// each speed: its velocity is this matrix times `u`. Often called the `CoM` Jacobian.
    "`{Self}` was generated without `center_of_mass_jacobian`; name it in `functions`, alone and not in a sum, and generate again"
    CenterOfMassJacobian: center_of_mass_jacobian(q: &Self::Q, jacobian: &mut [Self::U; 3]);

    /// Acceleration of the mass centre of all bodies for `u_dot = 0`, inertial components, m/s².
    ///
    /// For any `u_dot`, the acceleration without gravity is this plus the Jacobian times `u_dot`.
    "`{Self}` was generated without `center_of_mass_jacobian_dot_u`; name it in `functions`, alone and not in a sum, and generate again"
    CenterOfMassJacobianDotU: center_of_mass_jacobian_dot_u(q: &Self::Q, u: &Self::U, acceleration: &mut [R; 3]);
}

/// Momentum of all bodies about their mass centre per unit of each speed, inertial components, `[component][speed]`.
///
/// Linear momentum, kg m/s, and angular momentum, kg m²/s, are these matrices times `u`: entries are in kg and kg m for a speed in
/// m/s, in kg m and kg m² for one in rad/s. Often called the CMM, `A_G`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` was generated without `centroidal_momentum_matrix`; name it in `functions`, alone and not in a sum, and generate again"
)]
pub trait CentroidalMomentumMatrix<R: Real>: System<R> {
    /// Overwrites `linear` and `angular`; meaning, frame and unit are those of [`CentroidalMomentumMatrix`].
    fn centroidal_momentum_matrix(
        &self,
        q: &Self::Q,
        linear: &mut [Self::U; 3],
        angular: &mut [Self::U; 3],
    );
}

/// Rates of linear momentum, N, and of angular momentum about the mass centre, N m, of all bodies for `u_dot = 0`, inertial components.
///
/// For any `u_dot`, the rates are these plus [`CentroidalMomentumMatrix`] times `u_dot`. Often called `A_G_dot u`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` was generated without `centroidal_momentum_matrix_dot_u`; name it in `functions`, alone and not in a sum, and generate again"
)]
pub trait CentroidalMomentumMatrixDotU<R: Real>: System<R> {
    /// Overwrites `linear` and `angular`; meaning, frame and unit are those of [`CentroidalMomentumMatrixDotU`].
    fn centroidal_momentum_matrix_dot_u(
        &self,
        q: &Self::Q,
        u: &Self::U,
        linear: &mut [R; 3],
        angular: &mut [R; 3],
    );
}

mod derivatives;
mod dynamics;
mod frames;
mod linear;
mod regressors;

pub use derivatives::{
    ForwardDynamicsAndDerivatives, ForwardDynamicsByParameters, ForwardDynamicsDerivatives,
    ForwardDynamicsJvp, ForwardDynamicsParametersJvp, ForwardDynamicsParametersVjp,
    ForwardDynamicsVjp, HybridDynamicsAndDerivatives, HybridDynamicsJvp, HybridDynamicsVjp,
    InverseDynamicsAndDerivatives, InverseDynamicsByParameters, InverseDynamicsDerivatives,
    InverseDynamicsJvp, InverseDynamicsParametersJvp, InverseDynamicsParametersVjp,
    InverseDynamicsVjp, LoadedForwardDynamicsAndDerivatives, LoadedForwardDynamicsJvp,
    LoadedForwardDynamicsVjp,
};
pub use dynamics::{HybridDynamics, JointWrenches};
pub use frames::{
    Acceleration, GeneralizedForce, Imu, Jacobian, JacobianDotU, JacobianPacked, Local,
    OperationalInverseInertia, PointJacobian, Pose, Seen, Velocity,
};
pub use linear::{
    LinearAcceleration, LinearGeneralizedForce, LinearJacobian, LinearJacobianDotU,
    LinearJacobianPacked, LinearOperationalInverseInertia, LinearVelocity, Position,
};
pub use regressors::{
    BaseParameters, BaseRegressor, InertialParameters, JointRegressor, Regressor, RegressorPacked,
};
