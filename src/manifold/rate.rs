//! The rate of the direction that leads from fixed coordinates to moving ones.
//!
//! For an orientation it is `w + d × w / 2 + d × (d × w) / 12`: the inverse right Jacobian of SO(3), to the order of `d` that a
//! fourth-order step keeps. For every other speed it is the speed.

use super::{combined, put, three_rows, turnings};
use crate::three::{Vector, cross, transposed};
use crate::vector::{add_scaled, plus};
use crate::{Array, Real, System};

/// `a + b / 2 + c / 12`.
fn sum<R: Real>(a: Vector<R>, b: Vector<R>, c: Vector<R>) -> Vector<R> {
    let (half, twelfth) = (R::from_f64(0.5), R::from_f64(1.0 / 12.0));
    let entry = |a, b, c| a + (half * b + twelfth * c);
    [
        entry(a[0], b[0], c[0]),
        entry(a[1], b[1], c[1]),
        entry(a[2], b[2], c[2]),
    ]
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

/// The change of the rate at an orientation.
fn turned<R: Real>(
    (d, w): (Vector<R>, Vector<R>),
    (d_change, w_change): (Vector<R>, Vector<R>),
) -> Vector<R> {
    let once = plus(&cross(d_change, w), &cross(d, w_change));
    let twice = plus(&cross(d_change, cross(d, w)), &cross(d, once));
    sum(w_change, once, twice)
}

/// The change of the rate.
pub(crate) fn changed<R: Real, S: System<R>>(
    (d, u): (&S::U, &S::U),
    (d_change, u_change): (&S::U, &S::U),
) -> S::U {
    let mut rate = *u_change;
    for joint in turnings::<R, S>() {
        let (d, w) = (joint.turn(d), joint.turn(u));
        let change = (joint.turn(d_change), joint.turn(u_change));
        joint.set(&mut rate, turned((d, w), change));
    }
    rate
}

/// How the rate changes with `d` and `u`: a pair of blocks for each orientation, one per body.
pub(crate) struct RateMap<R: Real, S: System<R>> {
    by_d: S::Rotations,
    by_u: S::Rotations,
}

impl<R: Real, S: System<R>> RateMap<R, S> {
    pub(crate) fn at(d: &S::U, u: &S::U) -> Self {
        let (zero, one) = (R::from_f64(0.0), R::from_f64(1.0));
        let axes = [[one, zero, zero], [zero, one, zero], [zero, zero, one]];
        let none = S::Rotations::filled([[zero; 3]; 3]);
        let (mut by_d, mut by_u) = (none, none);
        for joint in turnings::<R, S>() {
            let at = (joint.turn(d), joint.turn(u));
            put(
                &mut by_d,
                joint.body,
                transposed(&axes.map(|axis| turned(at, (axis, [zero; 3])))),
            );
            put(
                &mut by_u,
                joint.body,
                transposed(&axes.map(|axis| turned(at, ([zero; 3], axis)))),
            );
        }
        Self { by_d, by_u }
    }

    /// Turns changes of the speeds, a column for each entry of a variable, into those of the rate, by rows, if those of `d` are `way`
    /// times `d_changes`.
    pub(crate) fn change_rows<Row: Array<R>, M: Array<Row>>(
        &self,
        (way, d_changes): (R, &M),
        changes: &mut M,
    ) {
        let blocks = (self.by_d.as_ref(), self.by_u.as_ref());
        for joint in turnings::<R, S>() {
            let (Some(by_d), Some(by_u)) = (blocks.0.get(joint.body), blocks.1.get(joint.body))
            else {
                continue;
            };
            let of_d = three_rows(d_changes, joint.u);
            let of_u = three_rows(changes, joint.u);
            let blocks = by_d.iter().zip(by_u);
            for (place, (by_d, by_u)) in joint.u.into_iter().zip(blocks) {
                if let Some(row) = changes.as_mut().get_mut(place) {
                    *row = combined(&of_u, *by_u);
                    add_scaled(row, way, &combined(&of_d, *by_d));
                }
            }
        }
    }
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
        let twice = plus(&cross(cross(d, w), m), &cross(w, once));
        joint.set(&mut of_d, sum([zero; 3], cross(w, m), twice));
    }
    (of_d, of_u)
}
