//! Inverse dynamics as it is linear in the parameters of bodies and joints.

use crate::{Array, Real, System};

/// Inertia forces and weight as they are linear in the inertial parameters `pi` of the bodies, `y[speed][body][parameter]`:
/// [`InverseDynamics`](super::InverseDynamics) is the sum of `y pi` over all bodies and parameters, and what springs, dampers and rotors need.
///
/// Ten parameters a body, with all that is fixed to it: `m`, `m c_x`, `m c_y`, `m c_z`, `I_xx`, `I_xy`, `I_yy`, `I_xz`, `I_yz`,
/// `I_zz`, about the body's origin, body components, kg, kg m, kg m²; `I_xy` is the tensor's component. The model's own values
/// are not read. Often called the joint torque regressor, or identification matrix.
#[diagnostic::on_unimplemented(
    message = "`{Self}` was generated without `regressor`; name it in `functions` and generate again"
)]
pub trait Regressor<R: Real>: System<R> {
    /// `[[R; 10]; NB]`: of one speed.
    type Row: Array<[R; 10]>;
    /// `[[[R; 10]; NB]; NU]`.
    type Rows: Array<Self::Row>;
    /// Overwrites the last argument; meaning, frame and unit are those of [`Regressor`].
    fn regressor(&self, q: &Self::Q, u: &Self::U, u_dot: &Self::U, y: &mut Self::Rows);
}

/// The entries of the [`Regressor`] that the tree does not make zero, column after column. A body has entries for the speeds that
/// move it; for a speed that translates it without turning, only those of its mass and first moment.
///
/// Forces are sums of few entries times the parameters of all bodies, ten a body, one after the other:
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
    message = "`{Self}` was generated without `regressor_packed`; name it in `functions` and generate again"
)]
pub trait RegressorPacked<R: Real>: System<R> {
    /// `[R; n]`, one entry for each place.
    type Entries: Array<R>;
    /// The row of each entry, which is a speed, and its column, ten times the body and the parameter; ordered by column, within a column by speed.
    const PLACES: &'static [[usize; 2]];
    /// Overwrites the last argument; meaning, frame and unit are those of [`Regressor`].
    fn regressor_packed(&self, q: &Self::Q, u: &Self::U, u_dot: &Self::U, y: &mut Self::Entries);
}

/// Inertia forces and weight as they are linear in the base parameters: those columns of the [`Regressor`] that are independent.
///
/// Base parameters are the fewest combinations of inertial parameters on which forces depend, and all that can be identified
/// from them. Also known as minimal or reduced regressor, minimal inertial parameters.
#[diagnostic::on_unimplemented(
    message = "`{Self}` was generated without `base_regressor`; name it in `functions` and generate again"
)]
pub trait BaseRegressor<R: Real>: System<R> {
    /// `[R; BASE_PARAMETERS_LEN]`: of one speed.
    type Row: Array<R>;
    /// `[[R; BASE_PARAMETERS_LEN]; NU]`.
    type Rows: Array<Self::Row>;
    /// The base parameters in words, one a column: `mcx(upper) + 0.32 m(fore)`.
    const NAMES: &'static [&'static str];
    /// What the base parameters are made of, one after the other; the factors hold for the nominal parameters.
    const TERMS: &'static [crate::BaseTerm];
    /// Overwrites the last argument; meaning, frame and unit are those of [`BaseRegressor`].
    fn base_regressor(&self, q: &Self::Q, u: &Self::U, u_dot: &Self::U, y: &mut Self::Rows);
}

/// Forces of dampers, Coulomb friction and rotors as they are linear in their coefficients: along each speed the sum of its
/// three numbers, the speed, its sign and its rate, times its viscous damping, N m s or N s/m, its Coulomb friction, N m or N,
/// and its rotor inertia, kg m² or kg.
///
/// A coefficient is the sum over all joints that the speed moves. For a joint that follows another, damper and rotor count times the
/// square of its multiplier, and friction times its magnitude. The sign is branch-free, `u / (|u| + 1e-30)`: a half at a speed of `1e-30`,
/// zero at zero, without a dead band.
#[diagnostic::on_unimplemented(
    message = "`{Self}` was generated without `joint_regressor`; name it in `functions` and generate again"
)]
pub trait JointRegressor<R: Real>: System<R> {
    /// `[[R; 3]; NU]`.
    type Terms: Array<[R; 3]>;
    /// Overwrites the last argument; meaning, frame and unit are those of [`JointRegressor`].
    fn joint_regressor(&self, q: &Self::Q, u: &Self::U, u_dot: &Self::U, y: &mut Self::Terms);
}
