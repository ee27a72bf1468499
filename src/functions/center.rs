//! The mass centre of all bodies, and momenta about it.

use crate::{Real, System};

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
