//! The rate of the direction that leads from fixed coordinates to moving ones.
//!
//! For an orientation it is `w + d × w / 2 + d × (d × w) / 12`: the inverse right Jacobian of SO(3), to the order of `d` that a
//! fourth-order step keeps. For every other speed it is the speed.

use super::turn::Vector;
use super::turnings;
use crate::{Array, Real, System};

fn cross<R: Real>(a: Vector<R>, b: Vector<R>) -> Vector<R> {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// `a + b / 2 + c / 12`.
fn sum<R: Real>(a: Vector<R>, b: Vector<R>, c: Vector<R>) -> Vector<R> {
    let (half, twelfth) = (R::from_f64(0.5), R::from_f64(1.0 / 12.0));
    [0, 1, 2].map(|i| a[i] + (half * b[i] + twelfth * c[i]))
}

fn plus<R: Real>(a: Vector<R>, b: Vector<R>) -> Vector<R> {
    [0, 1, 2].map(|i| a[i] + b[i])
}

/// The rate at the direction `d`, of a system that moves with `u`.
pub(crate) fn of<R: Real, S: System<R>>(d: &S::U, u: &S::U) -> S::U {
    let mut rate = *u;
    for joint in turnings::<R, S>() {
        let (d, w) = (joint.turn(d), joint.turn(u));
        let once = cross(d, w);
        joint.set(&mut rate, sum(w, once, cross(d, once)));
    }
    rate
}

/// The change of the rate.
pub(crate) fn changed<R: Real, S: System<R>>(
    (d, u): (&S::U, &S::U),
    (d_change, u_change): (&S::U, &S::U),
) -> S::U {
    let mut rate = *u_change;
    for joint in turnings::<R, S>() {
        let (d, w) = (joint.turn(d), joint.turn(u));
        let (d_change, w_change) = (joint.turn(d_change), joint.turn(u_change));
        let once = plus(cross(d_change, w), cross(d, w_change));
        let twice = plus(cross(d_change, cross(d, w)), cross(d, once));
        joint.set(&mut rate, sum(w_change, once, twice));
    }
    rate
}

/// Turns a multiplier of the rate into those of `d` and of `u`.
pub(crate) fn back<R: Real, S: System<R>>(
    (d, u): (&S::U, &S::U),
    multiplier: &S::U,
) -> (S::U, S::U) {
    let zero = R::from_f64(0.0);
    let (mut of_d, mut of_u) = (S::U::filled(zero), *multiplier);
    for joint in turnings::<R, S>() {
        let (d, w, m) = (joint.turn(d), joint.turn(u), joint.turn(multiplier));
        let once = cross(m, d);
        joint.set(&mut of_u, sum(m, once, cross(once, d)));
        let twice = plus(cross(cross(d, w), m), cross(w, once));
        joint.set(&mut of_d, sum([zero; 3], cross(w, m), twice));
    }
    (of_d, of_u)
}
