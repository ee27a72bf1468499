//! Springs, dampers, rotors, friction and limits of a motion.

use crate::tree::value::Value;

/// What acts along one motion of a joint, and how far it goes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mechanics {
    /// Stiffness of a spring, N m/rad, N/m.
    pub stiffness: Value,
    /// Where the spring is at rest, rad, m.
    pub rest: Value,
    /// Viscous damping, N m s/rad, N s/m.
    pub damping: Value,
    /// Inertia of a rotor as the joint feels it, kg m², kg.
    pub armature: Value,
    /// Coulomb friction, N m, N: data only.
    pub friction: f64,
    /// The least and the greatest value of the coordinate, rad, m: data only; infinite where there is no limit.
    pub range: [f64; 2],
    /// The greatest speed, rad/s, m/s: data only.
    pub velocity: f64,
    /// The greatest force, N m, N: data only.
    pub effort: f64,
}

impl Mechanics {
    /// True where a rotor turns with the coordinate.
    pub fn has_rotor(&self) -> bool {
        self.armature != Value::Baked(0.0)
    }
}

impl Default for Mechanics {
    /// Nothing acts, and nothing is limited.
    fn default() -> Self {
        let zero = Value::Baked(0.0);
        Self {
            stiffness: zero,
            rest: zero,
            damping: zero,
            armature: zero,
            friction: 0.0,
            range: [f64::NEG_INFINITY, f64::INFINITY],
            velocity: f64::INFINITY,
            effort: f64::INFINITY,
        }
    }
}
