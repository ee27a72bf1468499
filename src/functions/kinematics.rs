//! Orientations, positions and motions of bodies.

use crate::{Array, Block, Real, System};

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

    /// How far each body's angles are from their singularity: `|cos(theta_2)|` where `theta_1` and
    /// `theta_3` are both free, 1 elsewhere. Eq. (9).
    "`{Self}` was generated without `singularity`; name it in `functions`, alone and not in a sum, and generate again"
    Singularity: singularity(q: &Self::Q, distances: &mut Self::Scalars);
}
