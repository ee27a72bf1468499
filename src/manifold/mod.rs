//! Coordinates as points of a manifold: their sums with directions, their differences, and the derivatives of both.
//!
//! A direction is a vector of `NU` speeds that stay constant for a unit of time. If the speeds are the rates of the coordinates, [`q_plus`] is
//! a sum and [`q_minus`] a difference. If a spherical or free joint has a quaternion, or angular velocities as speeds, its three speeds are a
//! rotation vector, by which its orientation turns. Its components are along the axes of `u`, those on the body's side of the joint. So the
//! `NU` numbers of a direction are independent of each other for every kind of joint. Differences, derivatives and gains have `NU` entries.
//!
//! All functions use only arithmetic of [`Real`], without branches on numbers, allocation or the platform's arc tangent. So the bits are the
//! same everywhere, also in lanes, and the module is `no_std`. Of a model it uses [`System::JOINTS`] alone. If a system lacks this table, all
//! its speeds count as rates of coordinates, and a system with more coordinates than speeds does not compile.
//!
//! ```
//! # #[cfg(feature = "cart_pole")] {
//! use kane::cart_pole::Prepared;
//! use kane::manifold::{q_minus, q_plus};
//!
//! let system = Prepared::<f64>::nominal();
//! let q = q_plus(&system, &[0.5, 0.25], &[1.0, -1.0]);
//! assert_eq!(q, [1.5, -0.75]);
//! assert_eq!(q_minus(&system, &[0.5, 0.25], &q), [1.0, -1.0]);
//! # }
//! ```

mod angle;
#[cfg(doctest)]
mod needs_joints;
pub(crate) mod rate;
mod tangent;
pub(crate) mod turn;

pub(crate) use angle::sign;
pub use tangent::TangentMap;
pub(crate) use turn::of_angles;

use core::marker::PhantomData;

use crate::joint::Chart;
use crate::three::Vector;
use crate::vector::zero;
use crate::{Array, Joint, Real, System};
use angle::length;
use turn::Quaternion;

/// An entry; zero beyond the end, which no table reaches, so that no panic remains in a linked program.
fn entry<R: Real, A: Array<R>>(array: &A, place: usize) -> R {
    let found = array.as_ref().get(place).copied();
    found.unwrap_or(R::from_f64(0.0))
}

/// Three rows of a matrix; zeros beyond its end.
fn three_rows<R: Real, Row: Array<R>, M: Array<Row>>(
    matrix: &M,
    [a, b, c]: [usize; 3],
) -> [Row; 3] {
    let row = |place: usize| matrix.as_ref().get(place).copied().unwrap_or_else(zero);
    [row(a), row(b), row(c)]
}

/// A combination of three rows.
fn combined<R: Real, Row: Array<R>>([a, b, c]: &[Row; 3], [f, g, h]: Vector<R>) -> Row {
    let mut sum = *a;
    let others = b.as_ref().iter().zip(c.as_ref());
    for (sum, (b, c)) in sum.as_mut().iter_mut().zip(others) {
        *sum = f * *sum + g * *b + h * *c;
    }
    sum
}

/// Overwrites an entry.
fn put<T, A: Array<T>>(array: &mut A, place: usize, value: T) {
    if let Some(entry) = array.as_mut().get_mut(place) {
        *entry = value;
    }
}

/// A joint whose speeds are not rates of its coordinates: the places of its orientation and angular velocity.
#[derive(Clone, Copy, Debug)]
struct TurningPlaces {
    /// The index of its body.
    body: usize,
    is_quaternion: bool,
    q: [usize; 4],
    u: [usize; 3],
}

impl TurningPlaces {
    fn of(body: usize, joint: &Joint) -> Option<Self> {
        let is_quaternion = match joint.chart {
            Chart::AngleRates => return None,
            Chart::Angles => false,
            Chart::EulerParameters => true,
        };
        let q = [joint.q[0]?, joint.q[1]?, joint.q[2]?];
        let last = if is_quaternion { joint.q[3]? } else { q[2] };
        Some(Self {
            body,
            is_quaternion,
            q: [q[0], q[1], q[2], last],
            u: [joint.u[0]?, joint.u[1]?, joint.u[2]?],
        })
    }

    fn angles<R: Real, A: Array<R>>(self, q: &A) -> Vector<R> {
        [self.q[0], self.q[1], self.q[2]].map(|place| entry(q, place))
    }

    fn quaternion<R: Real, A: Array<R>>(self, q: &A) -> Quaternion<R> {
        if self.is_quaternion {
            self.q.map(|place| entry(q, place))
        } else {
            of_angles(self.angles(q))
        }
    }

    /// The entries of its three speeds.
    fn turn<R: Real, A: Array<R>>(self, d: &A) -> Vector<R> {
        self.u.map(|place| entry(d, place))
    }

    /// Overwrites the entries of its three speeds.
    fn set<R: Real, A: Array<R>>(self, d: &mut A, turn: Vector<R>) {
        for (place, own) in self.u.into_iter().zip(turn) {
            put(d, place, own);
        }
    }
}

/// What a compiler knows of a system's joints.
struct Known<R, S>(PhantomData<(R, S)>);

impl<R: Real, S: System<R>> Known<R, S> {
    /// True if there is a joint whose speeds are not rates of its coordinates.
    const TURNS: bool = any_turns(S::JOINTS);

    /// True if the system says which coordinates and speeds its joints have.
    const IS_TOLD: bool = {
        let is_told = !S::JOINTS.is_empty();
        assert!(
            is_told || S::Q::LEN == S::U::LEN,
            "kane: this system has not as many coordinates as speeds, so it needs `JOINTS`"
        );
        is_told
    };
}

const fn any_turns(joints: &[Joint]) -> bool {
    let mut place = 0;
    while place < joints.len() {
        if !matches!(joints[place].chart, Chart::AngleRates) {
            return true;
        }
        place += 1;
    }
    false
}

/// The joints whose speeds are not rates of their coordinates. Where there are none, no code remains.
fn turnings<R: Real, S: System<R>>() -> impl Iterator<Item = TurningPlaces> {
    let turns = Known::<R, S>::IS_TOLD && Known::<R, S>::TURNS;
    let joints = if turns { S::JOINTS } else { &[] };
    let joints = joints.iter().enumerate();
    joints.filter_map(|(body, joint)| TurningPlaces::of(body, joint))
}

/// Scales every quaternion of `q` to length one, up to rounding, whatever its length between 1e-28 and the scalar's largest number over
/// ten. All other coordinates stay.
///
/// For a `q` from elsewhere: a file, an estimator, a random draw. [`System::normalize`] costs less, but works only near length one, as after
/// an integrator's step. A quaternion of four zeros, which is no orientation, stays zero. Quaternions are
/// found in [`System::JOINTS`].
///
/// ```
/// # #[cfg(feature = "cart_pole")] {
/// # use kane::cart_pole::Prepared;
/// use kane::manifold::scale_quaternions;
///
/// let system = Prepared::<f64>::nominal();
/// let mut q = [0.5, 2.0]; // a slider and a hinge, no quaternion
/// scale_quaternions(&system, &mut q);
/// assert_eq!(q, [0.5, 2.0]);
/// # }
/// ```
pub fn scale_quaternions<R: Real, S: System<R>>(system: &S, q: &mut S::Q) {
    let _ = system;
    for joint in turnings::<R, S>().filter(|joint| joint.is_quaternion) {
        let e = joint.quaternion(q);
        let length = length(e);
        for (place, own) in joint.q.into_iter().zip(e) {
            put(q, place, own / length);
        }
    }
}

/// The places, in `q` and in `u`, of coordinates whose rates are speeds.
pub(crate) fn rates<R: Real, S: System<R>>() -> impl Iterator<Item = (usize, usize)> {
    let all = if Known::<R, S>::IS_TOLD { 0 } else { S::U::LEN };
    let told = S::JOINTS.iter().flat_map(Joint::rates);
    (0..all).map(|place| (place, place)).chain(told)
}

/// Coordinates after unit time at the constant speeds `direction`, starting from `q`; for another time, pass speeds times that time.
///
/// Directions are rad and m along the axes of `u`. Quaternions keep their length up to rounding; angles continue from
/// their values, also beyond π. Angles with angular velocities as speeds are singular at `cos(theta_2) = 0`, and none of them
/// changes by more than π at once.
#[must_use]
pub fn q_plus<R: Real, S: System<R>>(system: &S, q: &S::Q, direction: &S::U) -> S::Q {
    let _ = system;
    let mut moved = *q;
    rates::<R, S>().for_each(|(place, speed)| {
        put(&mut moved, place, entry(q, place) + entry(direction, speed));
    });
    for joint in turnings::<R, S>() {
        let by = turn::exp(joint.turn(direction));
        let turned = turn::product(joint.quaternion(q), by);
        if joint.is_quaternion {
            for (place, own) in joint.q.into_iter().zip(turned) {
                put(&mut moved, place, own);
            }
        } else {
            let angles = turn::angles_near(turned, joint.angles(q));
            for (place, own) in joint.q.into_iter().zip(angles) {
                put(&mut moved, place, own);
            }
        }
    }
    moved
}

/// The direction, rad and m along the axes of `u`, by which [`q_plus`] leads `from` one `q` `to` another: `to` minus `from`.
///
/// Orientations are connected by the shorter rotation, of at most half a revolution, also if quaternions differ in sign. Lengths of
/// quaternions do not matter, unless their product is below 1e-30 or overflows.
#[must_use]
pub fn q_minus<R: Real, S: System<R>>(system: &S, from: &S::Q, to: &S::Q) -> S::U {
    let _ = system;
    let mut direction: S::U = zero();
    rates::<R, S>().for_each(|(place, speed)| {
        put(&mut direction, speed, entry(to, place) - entry(from, place));
    });
    for joint in turnings::<R, S>() {
        let back = turn::inverse(joint.quaternion(from));
        let turn = turn::log(turn::product(back, joint.quaternion(to)));
        joint.set(&mut direction, turn);
    }
    direction
}
