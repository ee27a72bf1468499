//! Functions of the origins of frames, without what is angular: for feet and other points.
//!
//! Frames, axes and [`Local`], [`Seen`] are those of the functions of whole frames.
//!
//! [`Local`]: super::Local
//! [`Seen`]: super::Seen

use crate::{Array, Real, System};

/// Position of the origin of the frame `F`: the `position` of its [`Pose`](super::Pose), m.
#[diagnostic::on_unimplemented(
    message = "`{Self}` was generated without `position(FRAME)` for `{F}`; name it in `functions`, alone and not in a sum, and generate again"
)]
pub trait Position<R: Real, F>: System<R> {
    /// Writes the position at `q`.
    fn position(&self, q: &Self::Q, position: &mut [R; 3]);
}

/// Velocity of the origin of the frame `F`: the `linear` of its [`Velocity`](super::Velocity), m/s.
#[diagnostic::on_unimplemented(
    message = "`{Self}` was generated without `linear_velocity(FRAME)` for `{F}`; name it in `functions`, alone and not in a sum, and generate again"
)]
pub trait LinearVelocity<R: Real, F>: System<R> {
    /// Writes the velocity at `q`, `u`.
    fn linear_velocity(&self, q: &Self::Q, u: &Self::U, linear: &mut [R; 3]);
}

/// Acceleration of the origin of the frame `F`, without gravity: the `linear` of its [`Acceleration`](super::Acceleration), m/s².
#[diagnostic::on_unimplemented(
    message = "`{Self}` was generated without `linear_acceleration(FRAME)` for `{F}`; name it in `functions`, alone and not in a sum, and generate again"
)]
pub trait LinearAcceleration<R: Real, F>: System<R> {
    /// Writes the acceleration at `q`, `u`, `u_dot`.
    fn linear_acceleration(&self, q: &Self::Q, u: &Self::U, u_dot: &Self::U, linear: &mut [R; 3]);
}

/// Jacobian of the origin of the frame `F`: the `linear` of its [`Jacobian`](super::Jacobian).
///
/// Its product with `u` is the [`LinearVelocity`]. Often called the translational Jacobian.
#[diagnostic::on_unimplemented(
    message = "`{Self}` was generated without `linear_jacobian(FRAME)` for `{F}`; name it in `functions`, alone and not in a sum, and generate again"
)]
pub trait LinearJacobian<R: Real, F>: System<R> {
    /// The speeds that move the frame as it is seen, in order: all other columns are zero.
    const SPEEDS: &'static [usize];
    /// Writes the Jacobian at `q`, whole.
    fn linear_jacobian(&self, q: &Self::Q, linear: &mut [Self::U; 3]);
}

/// The columns of the [`LinearJacobian`] of the frame `F` that belong to the speeds that move the frame.
#[diagnostic::on_unimplemented(
    message = "`{Self}` was generated without `linear_jacobian_packed(FRAME)` for `{F}`; name it in `functions`, alone and not in a sum, and generate again"
)]
pub trait LinearJacobianPacked<R: Real, F>: System<R> {
    /// `[R; n]`, an entry for each of [`Self::SPEEDS`].
    type Columns: Array<R>;
    /// The speeds that move the frame as it is seen, in order.
    const SPEEDS: &'static [usize];
    /// Writes the columns at `q`.
    fn linear_jacobian_packed(&self, q: &Self::Q, linear: &mut [Self::Columns; 3]);
}

/// The [`LinearAcceleration`] of the frame `F` for `u_dot = 0`: along the same axes, [`LinearJacobian`] times `u_dot` plus this is the acceleration.
///
/// Along inertial axes it is the rate of the Jacobian times `u`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` was generated without `linear_jacobian_dot_u(FRAME)` for `{F}`; name it in `functions`, alone and not in a sum, and generate again"
)]
pub trait LinearJacobianDotU<R: Real, F>: System<R> {
    /// Writes the acceleration at `q`, `u`.
    fn linear_jacobian_dot_u(&self, q: &Self::Q, u: &Self::U, linear: &mut [R; 3]);
}

/// Generalized forces of a force, N, at the origin of the frame `F`: the transposed [`LinearJacobian`] times the force, N m and N.
#[diagnostic::on_unimplemented(
    message = "`{Self}` was generated without `linear_generalized_force(FRAME)` for `{F}`; name it in `functions`, alone and not in a sum, and generate again"
)]
pub trait LinearGeneralizedForce<R: Real, F>: System<R> {
    /// Writes `tau` at `q`.
    fn linear_generalized_force(&self, q: &Self::Q, force: &[R; 3], tau: &mut Self::U);
}

/// `J M⁻¹ Jᵀ` of the [`LinearJacobian`] of the frame `F`, or of several, `(F, G)`: the accelerations that unit forces at their origins
/// cause.
///
/// Symmetric, three rows per frame, 1/kg. For several point contacts it is often called the Delassus matrix.
#[diagnostic::on_unimplemented(
    message = "`{Self}` was generated without `linear_operational_inverse_inertia(FRAME)` for `{F}`; name it in `functions`, alone and not in a sum, and generate again"
)]
pub trait LinearOperationalInverseInertia<R: Real, F>: System<R> {
    /// `[R; 3]`, or `[R; 3 n]` for `n` frames.
    type Row: Array<R>;
    /// As many of these rows.
    type Rows: Array<Self::Row>;
    /// Writes the matrix at `q`, whole.
    fn linear_operational_inverse_inertia(&self, q: &Self::Q, inverse_inertia: &mut Self::Rows);
}
