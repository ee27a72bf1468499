//! The two arms: what their modules do not say of them.

use kane::functions::{BaseRegressor, InertialParameters, InverseDynamics, JointRegressor};

use crate::{Drive, panda, ur5};

/// An arm of revolute joints, one a body.
pub trait Arm:
    BaseRegressor<f64> + JointRegressor<f64> + InverseDynamics<f64> + InertialParameters<f64>
{
    /// The truth of the joints' drives, of which a URDF says nothing: of the size that is usual for such arms.
    const DRIVES: &'static [Drive];
    /// The middle of all motions, rad,
    const CENTER: &'static [f64];
    /// and how far from it a joint may turn, rad: within its limits. Nothing looks whether the arm meets itself or a table.
    const REACH: &'static [f64];
    /// The arm, with its nominal parameters.
    fn nominal() -> Self;
}

/// Viscous damping, N m s, Coulomb friction, N m, and rotor inertia, kg m².
const fn drive(viscous: f64, coulomb: f64, rotor: f64) -> Drive {
    Drive {
        viscous,
        coulomb,
        rotor,
    }
}

impl Arm for ur5::Prepared<f64> {
    const DRIVES: &'static [Drive] = &[
        drive(8.0, 9.0, 0.8),
        drive(8.0, 9.0, 0.8),
        drive(6.0, 6.0, 0.5),
        drive(1.2, 1.5, 0.1),
        drive(1.2, 1.5, 0.1),
        drive(1.2, 1.5, 0.1),
    ];
    const CENTER: &'static [f64] = &[0.0, -1.5, 1.3, -1.4, -1.6, 0.0];
    const REACH: &'static [f64] = &[2.0, 0.9, 1.0, 1.5, 1.5, 2.5];
    fn nominal() -> Self {
        Self::nominal()
    }
}

impl Arm for panda::Prepared<f64> {
    const DRIVES: &'static [Drive] = &[
        drive(1.5, 0.8, 0.6),
        drive(1.5, 0.9, 0.6),
        drive(1.2, 0.7, 0.5),
        drive(1.2, 0.8, 0.5),
        drive(0.5, 0.4, 0.2),
        drive(0.4, 0.3, 0.2),
        drive(0.4, 0.3, 0.2),
    ];
    const CENTER: &'static [f64] = &[0.0, -0.3, 0.0, -1.7, 0.0, 1.8, 0.0];
    const REACH: &'static [f64] = &[2.0, 1.0, 1.8, 1.2, 2.0, 1.5, 2.5];
    fn nominal() -> Self {
        Self::nominal()
    }
}
