//! Conversion of states between angles and quaternions: angles to Euler parameters and back, rates to angular velocities and back.
//!
//! [`convert`] takes a state of one system and gives the same state of another system, generated from the same model with different
//! charts. It needs the feature `std` for its arc tangent; generated functions never do. Orientations are exact up to rounding. Near
//! `cos(theta_2) = 0`, where angles are singular, the rates of the angles lose digits.

use crate::joint::Chart;
use crate::manifold::of_angles;
use crate::{Array, Joint, Real, System};

/// An orientation of three free rotations, and its angular velocity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turning {
    /// Unit quaternion, scalar first, Hamilton's product: components on the body's side to those on the lower body's.
    pub e: [f64; 4],
    /// Relative angular velocity, components on the body's side, rad/s, Eq. (8).
    pub w: [f64; 3],
}

impl Turning {
    /// From 1-2-3 body-fixed angles, rad, and the relative angular velocity.
    #[must_use]
    pub fn from_angles(theta: [f64; 3], w: [f64; 3]) -> Self {
        Self {
            e: of_angles(theta),
            w,
        }
    }

    /// From 1-2-3 body-fixed angles, rad, and their rates, rad/s: Eq. (8).
    #[must_use]
    pub fn from_rates(theta: [f64; 3], rates: [f64; 3]) -> Self {
        let ((s2, c2), (s3, c3)) = (sin_cos(theta[1]), sin_cos(theta[2]));
        let [d1, d2, d3] = rates;
        let w = [c2 * c3 * d1 + s3 * d2, c3 * d2 - c2 * s3 * d1, s2 * d1 + d3];
        Self::from_angles(theta, w)
    }

    /// The 1-2-3 body-fixed angles, rad: `theta_2` from -π/2 to π/2, the others from -π to π.
    ///
    /// At `cos(theta_2) = 0` only the sum or difference of the others is defined: `theta_1` is arbitrary, and `theta_3` matches it.
    #[must_use]
    pub fn angles(&self) -> [f64; 3] {
        let [e0, e1, e2, e3] = unit(self.e);
        // Entries of C(e)^T, Eq. (4): s2, -s1 c2, c1 c2.
        let s2 = 2.0 * (e1 * e3 + e0 * e2);
        let (s1c2, c1c2) = (
            2.0 * (e0 * e1 - e2 * e3),
            e0 * e0 - e1 * e1 - e2 * e2 + e3 * e3,
        );
        let theta2 = s2.atan2(s1c2.hypot(c1c2));
        let theta1 = s1c2.atan2(c1c2);
        // About the axis that the first two angles, as found, lead to: also where those mean little.
        let (s1, c1) = sin_cos(theta1);
        let xy = 2.0 * (e1 * e2 + e0 * e3);
        let xz = 2.0 * (e1 * e3 - e0 * e2);
        let yy = e0 * e0 - e1 * e1 + e2 * e2 - e3 * e3;
        let yz = 2.0 * (e2 * e3 + e0 * e1);
        let theta3 = (c1 * xy + s1 * xz).atan2(c1 * yy + s1 * yz);
        [theta1, theta2, theta3]
    }

    /// The rates of the angles, rad/s, Eq. (9); meaningless near `cos(theta_2) = 0`: there they are huge or not finite.
    #[must_use]
    pub fn rates(&self) -> [f64; 3] {
        let [_, theta2, theta3] = self.angles();
        let ((s2, c2), (s3, c3)) = (sin_cos(theta2), sin_cos(theta3));
        let [w1, w2, w3] = self.w;
        let d1 = (c3 * w1 - s3 * w2) / c2;
        [d1, s3 * w1 + c3 * w2, w3 - s2 * d1]
    }
}

/// The sines and cosines of generated code, not the platform's.
fn sin_cos(angle: f64) -> (f64, f64) {
    Real::sin_cos(angle)
}

fn unit(e: [f64; 4]) -> [f64; 4] {
    let length = e.iter().map(|entry| entry * entry).sum::<f64>().sqrt();
    e.map(|entry| entry / length)
}

/// Why a state cannot be converted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ConvertError {
    /// The systems differ in their bodies or joints, by number or name.
    OtherJoints {
        /// The index, from 0, of the first joint that differs.
        joint: usize,
    },
}

impl core::fmt::Display for ConvertError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::OtherJoints { joint } => {
                write!(
                    f,
                    "the systems differ in more than their charts: joint {joint} is another"
                )
            }
        }
    }
}

impl core::error::Error for ConvertError {}

/// Converts the state `q`, `u` of `From` to the same state of `To`, two systems of one model that differ in their charts.
///
/// A quaternion of four zeros is no orientation: its angles are not numbers.
///
/// # Errors
/// If the systems' joints differ in more than their charts.
pub fn convert<From: System<f64>, To: System<f64>>(
    q: &From::Q,
    u: &From::U,
) -> Result<(To::Q, To::U), ConvertError> {
    let (mut to_q, mut to_u) = (To::Q::filled(0.0), To::U::filled(0.0));
    // A system written by hand may have bodies and no table of their joints.
    let n_bodies = From::BODY_NAMES.len().max(To::BODY_NAMES.len());
    for index in 0..n_bodies {
        let other = ConvertError::OtherJoints { joint: index };
        let (Some(from), Some(to)) = (From::JOINTS.get(index), To::JOINTS.get(index)) else {
            return Err(other);
        };
        let moving = |joint: &Joint| joint.u.map(|place| place.is_some());
        let are_alike = from.name == to.name && moving(from) == moving(to);
        if !are_alike || !has_its_places::<From>(from) || !has_its_places::<To>(to) {
            return Err(other);
        }
        // What stands at other places than the orientation is copied, and that too in the same chart.
        let (q_places, u_places) = if from.chart == to.chart {
            (0..7, 0..6)
        } else {
            let turning = read::<From>(from, q, u).ok_or(other)?;
            write::<To>(to, turning, &mut to_q, &mut to_u).ok_or(other)?;
            (4..7, 3..6)
        };
        for place in u_places {
            if let (Some(from), Some(to)) = (from.u[place], to.u[place]) {
                to_u[to] = u[from];
            }
        }
        for place in q_places {
            if let (Some(from), Some(to)) = (from.q[place], to.q[place]) {
                to_q[to] = q[from];
            }
        }
    }
    Ok((to_q, to_u))
}

/// True for a joint of which all places are in `q` and `u`.
fn has_its_places<S: System<f64>>(joint: &Joint) -> bool {
    let (mut of_q, mut of_u) = (joint.q.iter().flatten(), joint.u.iter().flatten());
    of_q.all(|&place| place < S::Q::LEN) && of_u.all(|&place| place < S::U::LEN)
}

fn three<T: Copy>(places: &[Option<T>]) -> Option<[T; 3]> {
    Some([(*places.first()?)?, (*places.get(1)?)?, (*places.get(2)?)?])
}

fn read<S: System<f64>>(joint: &Joint, q: &S::Q, u: &S::U) -> Option<Turning> {
    let speeds = three(&joint.u)?.map(|place| u[place]);
    let angles = three(&joint.q)?.map(|place| q[place]);
    Some(match joint.chart {
        Chart::AngleRates => Turning::from_rates(angles, speeds),
        Chart::Angles => Turning::from_angles(angles, speeds),
        Chart::EulerParameters => Turning {
            e: [angles[0], angles[1], angles[2], q[joint.q[3]?]],
            w: speeds,
        },
    })
}

fn write<S: System<f64>>(
    joint: &Joint,
    turning: Turning,
    q: &mut S::Q,
    u: &mut S::U,
) -> Option<()> {
    let (places, speeds) = (three(&joint.q)?, three(&joint.u)?);
    let (coordinates, rates) = match joint.chart {
        Chart::AngleRates => (turning.angles(), turning.rates()),
        Chart::Angles => (turning.angles(), turning.w),
        Chart::EulerParameters => {
            let [e0, e1, e2, e3] = unit(turning.e);
            q[joint.q[3]?] = e3;
            ([e0, e1, e2], turning.w)
        }
    };
    for i in 0..3 {
        q[places[i]] = coordinates[i];
        u[speeds[i]] = rates[i];
    }
    Some(())
}
