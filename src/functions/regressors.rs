//! Regressors: inverse dynamics as a linear function of the parameters of bodies and joints.

use crate::{Array, Real, System};

/// The inertial parameters `pi` of the bodies, by which [`Regressor`] and [`RegressorPacked`] are multiplied.
///
/// Ten per body, including all that is fixed to it: `m`, `m c_x`, `m c_y`, `m c_z`, `I_xx`, `I_xy`, `I_yy`, `I_xz`, `I_yz`, `I_zz`, about the
/// body's origin, body components, kg, kg m, kg m²; `I_xy` is the tensor's component. Often called the standard or dynamic parameters.
#[diagnostic::on_unimplemented(
    message = "`{Self}` was generated without `inertial_parameters`; name it in `functions`, alone and not in a sum, and generate again"
)]
pub trait InertialParameters<R: Real>: System<R> {
    /// `[[R; 10]; NB]`.
    type Inertial: Array<[R; 10]>;
    /// Overwrites the argument; meaning, frame and unit are those of [`InertialParameters`].
    fn inertial_parameters(&self, pi: &mut Self::Inertial);
}

/// The base parameters, by which [`BaseRegressor`] is multiplied: sums of [`InertialParameters`], each times its factor in
/// [`BaseRegressor::TERMS`].
///
/// In kg, kg m and kg m², as the sums. The factors hold for the nominal parameters. Often called the minimal parameters.
#[diagnostic::on_unimplemented(
    message = "`{Self}` was generated without `base_parameters`; name it in `functions`, alone and not in a sum, and generate again"
)]
pub trait BaseParameters<R: Real>: System<R> {
    /// `[R; BASE_PARAMETERS_LEN]`.
    type Base: Array<R>;
    /// Overwrites the argument; meaning, frame and unit are those of [`BaseParameters`].
    fn base_parameters(&self, pi: &mut Self::Base);
}

/// Inertia forces and weight as a linear function of the inertial parameters `pi` of the bodies, `y[speed][body][parameter]`.
///
/// [`InverseDynamics`](super::InverseDynamics) is the sum of `y pi` over all bodies and parameters, plus the forces of springs, dampers
/// and rotors. Ten parameters per body, including all that is fixed to it: `m`, `m c_x`, `m c_y`, `m c_z`, `I_xx`, `I_xy`, `I_yy`,
/// `I_xz`, `I_yz`, `I_zz`, about the body's origin, body components, kg, kg m, kg m²; `I_xy` is the tensor's component. The model's
/// own values do not matter. An entry times its parameter is a generalized force, N m or N. Often called the joint torque regressor, or identification matrix.
#[diagnostic::on_unimplemented(
    message = "`{Self}` was generated without `regressor`; name it in `functions`, alone and not in a sum, and generate again"
)]
pub trait Regressor<R: Real>: System<R> {
    /// `[[R; 10]; NB]`: the row of one speed.
    type Row: Array<[R; 10]>;
    /// `[[[R; 10]; NB]; NU]`.
    type Rows: Array<Self::Row>;
    /// Overwrites the last argument; meaning, frame and unit are those of [`Regressor`].
    fn regressor(&self, q: &Self::Q, u: &Self::U, u_dot: &Self::U, y: &mut Self::Rows);
}

/// The entries of the [`Regressor`] that are not structurally zero, column by column.
///
/// A body has entries for the speeds that move it; for a speed that translates it without rotation, only those of its mass and first
/// moment. Forces are sums of few entries times the parameters of all bodies, ten per body, in the order of the bodies:
///
/// ```
/// use kane::{Array, Real, functions::RegressorPacked};
///
/// /// Adds the forces that the parameters make to those in `tau`.
/// fn add_forces<R: Real, S: RegressorPacked<R>>(entries: &S::Entries, parameters: &[[R; 10]], tau: &mut S::U) {
///     for (&entry, &[speed, column]) in entries.as_ref().iter().zip(S::PLACES) {
///         tau[speed] = tau[speed] + entry * parameters.as_flattened()[column];
///     }
/// }
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` was generated without `regressor_packed`; name it in `functions`, alone and not in a sum, and generate again"
)]
pub trait RegressorPacked<R: Real>: System<R> {
    /// `[R; n]`, one entry for each place.
    type Entries: Array<R>;
    /// The row of each entry, a speed, and its column, ten times the body plus the parameter; ordered by column, within a column by speed.
    const PLACES: &'static [[usize; 2]];
    /// Overwrites the last argument; meaning, frame and unit are those of [`Regressor`].
    fn regressor_packed(&self, q: &Self::Q, u: &Self::U, u_dot: &Self::U, y: &mut Self::Entries);
}

/// Inertia forces and weight as a linear function of the base parameters: the independent columns of the [`Regressor`].
///
/// Base parameters are the smallest set of combinations of inertial parameters that determines the forces, and all that measured
/// forces can identify. An entry times its base parameter is a generalized force, N m or N. Also known as minimal or reduced regressor, minimal inertial parameters.
#[diagnostic::on_unimplemented(
    message = "`{Self}` was generated without `base_regressor`; name it in `functions`, alone and not in a sum, and generate again"
)]
pub trait BaseRegressor<R: Real>: System<R> {
    /// `[R; BASE_PARAMETERS_LEN]`: the row of one speed.
    type Row: Array<R>;
    /// `[[R; BASE_PARAMETERS_LEN]; NU]`.
    type Rows: Array<Self::Row>;
    /// The base parameters as text, one per column: `mcx(upper) + 0.32 m(fore)`.
    const NAMES: &'static [&'static str];
    /// The terms of the base parameters, one base parameter after the other; the factors hold for the nominal parameters.
    const TERMS: &'static [crate::BaseTerm];
    /// Overwrites the last argument; meaning, frame and unit are those of [`BaseRegressor`].
    fn base_regressor(&self, q: &Self::Q, u: &Self::U, u_dot: &Self::U, y: &mut Self::Rows);
}

/// Forces of dampers, Coulomb friction and rotors as a linear function of their coefficients.
///
/// Each speed has three numbers: the speed, its sign and its rate. Its force is the sum of these times its viscous damping, N m s or
/// N s/m, its Coulomb friction, N m or N, and its rotor inertia, kg m² or kg. A coefficient is the sum over all joints that the speed
/// moves. For a mimic joint, damper and rotor count times the square of its multiplier, and friction times its magnitude. The sign is
/// branch-free, `u / (|u| + 1e-30)`: one half at a speed of `1e-30`, zero at zero, without a dead band.
#[diagnostic::on_unimplemented(
    message = "`{Self}` was generated without `joint_regressor`; name it in `functions`, alone and not in a sum, and generate again"
)]
pub trait JointRegressor<R: Real>: System<R> {
    /// `[[R; 3]; NU]`.
    type Terms: Array<[R; 3]>;
    /// Overwrites the last argument; meaning, frame and unit are those of [`JointRegressor`].
    fn joint_regressor(&self, q: &Self::Q, u: &Self::U, u_dot: &Self::U, y: &mut Self::Terms);
}
