//! Functions of frames: pose, velocity, acceleration, Jacobian, forces.
//!
//! A frame `F` is one of the types in the generated module's `frames`, for vectors in inertial components. [`Local`] gives
//! components along the frame's own axes; [`Seen`] gives quantities relative to another frame.

use core::marker::PhantomData;

use crate::{Array, Real, System};

/// Selects components along the frame's own axes, not the inertial ones: `Velocity<R, Local<frames::Tool0>>`.
#[derive(Clone, Copy, Debug)]
pub struct Local<F>(PhantomData<F>);

/// Selects a frame relative to another frame, along the axes of the other: `Jacobian<R, Seen<frames::Tool0, frames::Camera>>`.
#[derive(Clone, Copy, Debug)]
pub struct Seen<F, From>(PhantomData<(F, From)>);

/// Pose of the frame `F`.
///
/// `rotation` maps inertial components to components along the frame's axes, row by row; `position` is from the inertial
/// origin to the frame's origin, inertial components, m. For [`Seen`] the other frame replaces the inertial frame.
/// Often called the frame placement, or forward kinematics.
#[diagnostic::on_unimplemented(
    message = "`{Self}` was generated without `pose(FRAME)` for `{F}`; name it in `functions`, alone and not in a sum, and generate again"
)]
pub trait Pose<R: Real, F>: System<R> {
    /// Writes the pose at `q`.
    fn pose(&self, q: &Self::Q, rotation: &mut [[R; 3]; 3], position: &mut [R; 3]);
}

/// Velocity of the frame `F` in the inertial frame.
///
/// `linear` is the velocity of the frame's origin, m/s, `angular` its angular velocity, rad/s, both in inertial components, or for
/// [`Local`] along the frame's own axes. Often called the twist.
#[diagnostic::on_unimplemented(
    message = "`{Self}` was generated without `velocity(FRAME)` for `{F}`; name it in `functions`, alone and not in a sum, and generate again"
)]
pub trait Velocity<R: Real, F>: System<R> {
    /// Writes the velocity at `q`, `u`.
    fn velocity(&self, q: &Self::Q, u: &Self::U, linear: &mut [R; 3], angular: &mut [R; 3]);
}

/// Acceleration of the frame `F` in the inertial frame.
///
/// `linear` is the rate of the velocity of the frame's origin, m/s², without gravity, `angular` its angular acceleration,
/// rad/s², both in inertial components, or for [`Local`] along the frame's own axes.
#[diagnostic::on_unimplemented(
    message = "`{Self}` was generated without `acceleration(FRAME)` for `{F}`; name it in `functions`, alone and not in a sum, and generate again"
)]
pub trait Acceleration<R: Real, F>: System<R> {
    /// Writes the acceleration at `q`, `u`, `u_dot`.
    fn acceleration(
        &self,
        q: &Self::Q,
        u: &Self::U,
        u_dot: &Self::U,
        linear: &mut [R; 3],
        angular: &mut [R; 3],
    );
}

/// Jacobian of the frame `F`: its product with `u` is the frame's [`Velocity`].
///
/// One row per component, one column per speed: m/s and rad/s per unit of that speed. For [`Local`] the components are along the frame's own axes, for
/// [`Seen`] the velocity is relative to the other frame, along the axes of the other. Often called the geometric Jacobian.
#[diagnostic::on_unimplemented(
    message = "`{Self}` was generated without `jacobian(FRAME)` for `{F}`; name it in `functions`, alone and not in a sum, and generate again"
)]
pub trait Jacobian<R: Real, F>: System<R> {
    /// The speeds that move the frame as it is seen, in order: all other columns are zero.
    const SPEEDS: &'static [usize];
    /// Writes the Jacobian at `q`, whole.
    fn jacobian(&self, q: &Self::Q, linear: &mut [Self::U; 3], angular: &mut [Self::U; 3]);
}

/// The columns of the [`Jacobian`] of the frame `F` that belong to the speeds that move it.
#[diagnostic::on_unimplemented(
    message = "`{Self}` was generated without `jacobian_packed(FRAME)` for `{F}`; name it in `functions`, alone and not in a sum, and generate again"
)]
pub trait JacobianPacked<R: Real, F>: System<R> {
    /// `[R; n]`, an entry for each of [`Self::SPEEDS`].
    type Columns: Array<R>;
    /// The speeds that move the frame as it is seen, in order.
    const SPEEDS: &'static [usize];
    /// Writes the columns at `q`.
    fn jacobian_packed(
        &self,
        q: &Self::Q,
        linear: &mut [Self::Columns; 3],
        angular: &mut [Self::Columns; 3],
    );
}

/// Jacobian of a point fixed in the frame `F`, for moving contacts.
///
/// Like [`Jacobian`], for the point instead of the frame's origin.
#[diagnostic::on_unimplemented(
    message = "`{Self}` was generated without `point_jacobian(FRAME)` for `{F}`; name it in `functions`, alone and not in a sum, and generate again"
)]
pub trait PointJacobian<R: Real, F>: System<R> {
    /// The speeds that move the frame as it is seen, in order: all other columns are zero.
    const SPEEDS: &'static [usize];
    /// Writes the Jacobian at `q`; `point` is from the frame's origin, along the frame's axes, m.
    fn point_jacobian(
        &self,
        q: &Self::Q,
        point: &[R; 3],
        linear: &mut [Self::U; 3],
        angular: &mut [Self::U; 3],
    );
}

/// The [`Acceleration`] of the frame `F` for `u_dot = 0`: along the same axes, [`Jacobian`] times `u_dot` plus this is the acceleration.
///
/// Often called the drift, or `J_dot q_dot`: along inertial axes it is the rate of the Jacobian times `u`. For [`Local`], whose axes turn, the
/// linear part of that rate times `u` is `w × v` less than this.
#[diagnostic::on_unimplemented(
    message = "`{Self}` was generated without `jacobian_dot_u(FRAME)` for `{F}`; name it in `functions`, alone and not in a sum, and generate again"
)]
pub trait JacobianDotU<R: Real, F>: System<R> {
    /// Writes the acceleration at `q`, `u`.
    fn jacobian_dot_u(&self, q: &Self::Q, u: &Self::U, linear: &mut [R; 3], angular: &mut [R; 3]);
}

/// Generalized forces of a wrench on the frame `F`: the transposed [`Jacobian`] times the wrench, N m and N.
///
/// The force, N, acts at the frame's origin; it and the moment, N m, are in inertial components, or for [`Local`] along the
/// frame's own axes.
#[diagnostic::on_unimplemented(
    message = "`{Self}` was generated without `generalized_force(FRAME)` for `{F}`; name it in `functions`, alone and not in a sum, and generate again"
)]
pub trait GeneralizedForce<R: Real, F>: System<R> {
    /// Writes `tau` at `q`.
    fn generalized_force(&self, q: &Self::Q, force: &[R; 3], moment: &[R; 3], tau: &mut Self::U);
}

/// `J M⁻¹ Jᵀ` of the [`Jacobian`] of the frame `F`, or of several, `(F, G)`: the accelerations that unit wrenches on them cause.
///
/// Symmetric, six rows per frame, the linear ones first; 1/kg, 1/(kg m), 1/(kg m²). For several contacts it is often called the
/// Delassus matrix, for one frame the inverse operational-space inertia.
#[diagnostic::on_unimplemented(
    message = "`{Self}` was generated without `operational_inverse_inertia(FRAME)` for `{F}`; name it in `functions`, alone and not in a sum, and generate again"
)]
pub trait OperationalInverseInertia<R: Real, F>: System<R> {
    /// `[R; 6]`, or `[R; 6 n]` for `n` frames.
    type Row: Array<R>;
    /// As many of these rows.
    type Rows: Array<Self::Row>;
    /// Writes the matrix at `q`, whole.
    fn operational_inverse_inertia(&self, q: &Self::Q, inverse_inertia: &mut Self::Rows);
}

/// The readings of an inertial measurement unit at the frame `F`.
///
/// `specific_force` is the acceleration of the frame's origin minus gravity, m/s², `angular_velocity` that of the frame, rad/s;
/// both along the frame's own axes. At rest the specific force points up.
#[diagnostic::on_unimplemented(
    message = "`{Self}` was generated without `imu(FRAME)` for `{F}`; name it in `functions`, alone and not in a sum, and generate again"
)]
pub trait Imu<R: Real, F>: System<R> {
    /// Writes the readings at `q`, `u`, `u_dot`.
    fn imu(
        &self,
        q: &Self::Q,
        u: &Self::U,
        u_dot: &Self::U,
        specific_force: &mut [R; 3],
        angular_velocity: &mut [R; 3],
    );
}
