//! The drive of a joint.

/// The coefficients of a drive, in the order of [`kane::functions::JointRegressor`].
pub const COEFFICIENTS: usize = 3;

/// What turns a joint: its friction, and its rotor as the joint feels it through the gear.
#[derive(Clone, Copy, Debug)]
pub struct Drive {
    /// Viscous damping, N m s.
    pub viscous: f64,
    /// Coulomb friction, N m.
    pub coulomb: f64,
    /// Inertia of the rotor, kg m².
    pub rotor: f64,
}

impl Drive {
    /// What it takes of the motor's torque at a speed, rad/s, and an acceleration, rad/s², N m.
    pub fn torque(&self, speed: f64, acceleration: f64) -> f64 {
        let friction = self.viscous * speed + self.coulomb * speed.signum();
        friction + self.rotor * acceleration
    }

    /// Its coefficients.
    pub fn coefficients(&self) -> [f64; COEFFICIENTS] {
        [self.viscous, self.coulomb, self.rotor]
    }
}
