//! [`System`]: sizes, names and tree of a multibody system, and the two functions that every system has.
//!
//! A generated module implements it for its `Prepared<R>`, which holds everything that depends only on the parameters.
//! Every other function has its own trait in [`functions`](crate::functions); a module implements the traits of
//! the functions that it holds.

use crate::{Array, Cost, Frame, Joint, Load, Real};

/// A tree of `NB` rigid bodies with `NQ` generalized coordinates `q` and `NU` generalized speeds `u`.
///
/// Bodies, coordinates and speeds are numbered from 0 wherever they index an array. Angles are in rad,
/// translations in m, speeds in rad/s and m/s.
pub trait System<R: Real> {
    /// `[R; NQ]`: generalized coordinates, Eq. (1), in the order of [`Self::COORDINATE_NAMES`].
    type Q: Array<R>;
    /// `[R; NU]`: generalized speeds, their derivatives and generalized forces, in the order of
    /// [`Self::SPEED_NAMES`].
    type U: Array<R>;
    /// `[[R; NU]; NU]`: one number for each pair of speeds, row by row.
    type Matrix: Array<Self::U>;
    /// `[Load<R>; NB]`: one load per body.
    type Loads: Array<Load<R>>;
    /// `[R; NB]`: one number per body.
    type Scalars: Array<R>;
    /// `[[R; 3]; NB]`: one vector per body.
    type Vectors: Array<[R; 3]>;
    /// `[[[R; 3]; 3]; NB]`: one matrix per body, row by row.
    type Rotations: Array<[[R; 3]; 3]>;

    /// The name in the model.
    const NAME: &'static str;
    /// The `NB` bodies' names.
    const BODY_NAMES: &'static [&'static str];
    /// The `NQ` coordinates' names.
    const COORDINATE_NAMES: &'static [&'static str];
    /// The `NU` speeds' names.
    const SPEED_NAMES: &'static [&'static str];
    /// The body-connection array: for each of the `NB` bodies its lower body (parent), numbered **from 1**
    /// as in the notes, and 0 for the inertial frame.
    const LOWER_BODIES: &'static [usize];
    /// For each of the `NU` speeds the index, from 0, of the body that it moves relative to its lower body.
    const SPEED_BODIES: &'static [usize];

    /// For each of the `NB` bodies its joint: the places of its coordinates and speeds. Without it each speed is the rate of the coordinate
    /// of its place. A wrapper of another system must pass on that system's `JOINTS`.
    const JOINTS: &'static [Joint] = &[];
    /// The frames of bodies that are fixed to others and part of them.
    const FRAMES: &'static [Frame] = &[];
    /// The lower limits of the `NQ` coordinates, rad, m; infinite if there is no limit. A joint that follows another narrows that one's limits,
    /// here, above and for speeds; no equation of motion uses them; inverse kinematics does.
    const LOWER_LIMITS: &'static [f64] = &[];
    /// The upper limits of the `NQ` coordinates, rad, m.
    const UPPER_LIMITS: &'static [f64] = &[];
    /// The maximum magnitudes of the `NU` speeds, rad/s, m/s.
    const VELOCITY_LIMITS: &'static [f64] = &[];
    /// The maximum magnitudes of the `NU` generalized forces, N m, N.
    const EFFORT_LIMITS: &'static [f64] = &[];
    /// Coulomb friction along the `NU` speeds, N m, N, including that of mimic joints times the magnitude of their multiplier.
    const FRICTION: &'static [f64] = &[];
    /// Hash of the model, of every name, number, joint and place in it, independent of what is generated; 0 if unknown.
    const FINGERPRINT: u64 = 0;
    /// The cost of one call of each function of the module.
    const OPERATIONS: &'static [Cost] = &[];

    /// Writes the derivatives of the coordinates, Eqs. (44), (9), or those of Euler parameters.
    fn q_dot(&self, q: &Self::Q, u: &Self::U, q_dot: &mut Self::Q);

    /// Brings quaternions among the coordinates back to length one after an integrator's step; does nothing if there are none.
    ///
    /// Only near length one: a length of `1 + x` becomes one of about `1 - 3.4 x⁴`, which is one up to rounding for `x` below 1e-4, but
    /// a length of 3 becomes one of 351. [`manifold::scale_quaternions`](crate::manifold::scale_quaternions) works from any length.
    fn normalize(&self, q: &mut Self::Q) {
        let _ = q;
    }
}
