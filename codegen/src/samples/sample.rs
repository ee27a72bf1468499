//! States, and what functions give there, as numbers.

use crate::functions::Argument;

/// A state, and what else functions are given there.
#[derive(Clone, Debug)]
pub(crate) struct Sample {
    /// Values of the parameters.
    pub(crate) parameters: Vec<f64>,
    /// Coordinates.
    pub(crate) q: Vec<f64>,
    /// Speeds.
    pub(crate) u: Vec<f64>,
    /// Their derivatives.
    pub(crate) u_dot: Vec<f64>,
    /// Generalized forces.
    pub(crate) tau: Vec<f64>,
    /// Force and moment of each body.
    pub(crate) loads: Vec<f64>,
    /// The relative angular velocity of each body.
    pub(crate) w_rel: Vec<f64>,
}

impl Sample {
    /// The numbers of an argument, one after the other.
    pub(crate) fn of(&self, argument: Argument) -> &[f64] {
        match argument {
            Argument::Q => &self.q,
            Argument::U => &self.u,
            Argument::UDot => &self.u_dot,
            Argument::Tau => &self.tau,
            Argument::Loads => &self.loads,
            Argument::RelativeAngularVelocity => &self.w_rel,
        }
    }
}

/// What a function writes.
#[derive(Clone, Debug)]
pub(crate) struct Sampled {
    /// For every state the numbers of every output, each with how far from it a function may be.
    pub(crate) values: Vec<Vec<Vec<(f64, f64)>>>,
    /// The lengths of every output's nested arrays.
    pub(crate) lengths: Vec<Vec<usize>>,
    /// How many entries of an output are summed to one number.
    pub(crate) entries: Vec<usize>,
}
