//! `springdamper`: a spring and a damper that give a joint its time constant and damping ratio.
//!
//! As in MuJoCo the joint's inertia is one over its entry in the diagonal of the inverse mass matrix in the reference pose, rotors
//! among it ([`free_inertia`](super::free_inertia)).

/// MuJoCo divides by nothing smaller.
const LEAST: f64 = 1e-15;

/// What MuJoCo computes a spring and a damper from.
#[derive(Clone, Copy, Debug)]
pub(in crate::description::mjcf) struct SpringDamper {
    /// s.
    pub(in crate::description::mjcf) time_constant: f64,
    pub(in crate::description::mjcf) damping_ratio: f64,
}

impl SpringDamper {
    /// N m/rad or N/m, for a joint of this inertia, kg m² or kg.
    pub(in crate::description::mjcf) fn stiffness(&self, inertia: f64) -> f64 {
        let time = self.time_constant * self.damping_ratio;
        inertia / (time * time).max(LEAST)
    }

    /// N m s/rad or N s/m.
    pub(in crate::description::mjcf) fn damping(&self, inertia: f64) -> f64 {
        2.0 * inertia / self.time_constant.max(LEAST)
    }
}
