//! A linear-quadratic regulator whose gains are computed on board: of the cart and the pole, from the step's own `A`, `B`.
//!
//! Riccati's recursion from the end of a long time, with one force: a division a step, and no matrix to invert.

use kane::Real;
use kane::discrete::{StepDerivatives, euler};

use super::cart_pole_steps::Prepared;

/// A state's four numbers: cart and pole, then their speeds.
type Row<R> = [R; 4];

/// The time of a step, s.
const DT: f64 = 0.02;

/// How many steps the recursion looks ahead: eight seconds.
const HORIZON: usize = 400;

/// The gains `K` of the force `-K x` near upright, as two rows: of the coordinates, of the speeds.
#[inline(never)]
pub(super) fn gains<R: Real>(system: &Prepared<R>) -> [[R; 2]; 2] {
    let zero = R::from_f64(0.0);
    let mut step = StepDerivatives::filled([[zero; 2]; 2]);
    let (mut q, mut u) = ([zero; 2], [zero; 2]);
    let dt = R::from_f64(DT);
    euler::linearized(system, &[zero; 2], dt, (&mut q, &mut u), &mut step);
    let joined = |[a, b]: [R; 2], [c, d]: [R; 2]| [a, b, c, d];
    let [[q0, q1], [u0, u1]] = [[&step.q_by_q, &step.q_by_u], [&step.u_by_q, &step.u_by_u]];
    let a: [Row<R>; 4] = [
        joined(q0[0], q1[0]),
        joined(q0[1], q1[1]),
        joined(u0[0], u1[0]),
        joined(u0[1], u1[1]),
    ];
    let b = [
        step.q_by_tau[0][0],
        step.q_by_tau[1][0],
        step.u_by_tau[0][0],
        step.u_by_tau[1][0],
    ];
    let [k0, k1, k2, k3] = regulator(&a, &b);
    [[k0, k1], [k2, k3]]
}

fn dot<R: Real>(a: &Row<R>, b: &Row<R>) -> R {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3]
}

/// `a + factor b`. Arrays are walked, not indexed, so that no panic stays in the program.
fn plus_scaled<R: Real>(mut a: Row<R>, factor: R, b: &Row<R>) -> Row<R> {
    for (a, b) in a.iter_mut().zip(b) {
        *a = *a + factor * *b;
    }
    a
}

/// A vector times a matrix by rows.
fn times_rows<R: Real>(v: &Row<R>, matrix: &[Row<R>; 4]) -> Row<R> {
    let rows = v.iter().zip(matrix);
    rows.fold([R::from_f64(0.0); 4], |sum, (v, row)| {
        plus_scaled(sum, *v, row)
    })
}

fn transposed<R: Real>(matrix: &[Row<R>; 4]) -> [Row<R>; 4] {
    let [a, b, c, d] = matrix;
    [
        [a[0], b[0], c[0], d[0]],
        [a[1], b[1], c[1], d[1]],
        [a[2], b[2], c[2], d[2]],
        [a[3], b[3], c[3], d[3]],
    ]
}

/// With the costs one of a state's numbers and a tenth of the force.
fn regulator<R: Real>(a: &[Row<R>; 4], b: &Row<R>) -> Row<R> {
    let (zero, one) = (R::from_f64(0.0), R::from_f64(1.0));
    let unit = [
        [one, zero, zero, zero],
        [zero, one, zero, zero],
        [zero, zero, one, zero],
        [zero, zero, zero, one],
    ];
    let columns = transposed(a);
    let (mut cost, mut gains) = (unit, [zero; 4]);
    for _ in 0..HORIZON {
        let of_b = times_rows(b, &cost);
        let pivot = R::from_f64(0.1) + dot(&of_b, b);
        gains = times_rows(&of_b, a).map(|entry| entry / pivot);
        // A - B K, and with it the cost of a step earlier: Q + Aᵀ P (A - B K).
        let mut held = *a;
        for (row, b) in held.iter_mut().zip(b) {
            *row = plus_scaled(*row, -*b, &gains);
        }
        let left = cost.each_ref().map(|cost| times_rows(cost, &held));
        cost = unit;
        for (row, column) in cost.iter_mut().zip(&columns) {
            *row = plus_scaled(*row, one, &times_rows(column, &left));
        }
    }
    gains
}

/// The state, coordinates and speeds, after three seconds with these gains.
#[inline(never)]
pub(super) fn held<R: Real>(system: &Prepared<R>, gains: &[[R; 2]; 2]) -> [[R; 2]; 2] {
    let (zero, dt) = (R::from_f64(0.0), R::from_f64(DT));
    let (mut q, mut u) = ([zero, R::from_f64(0.1)], [zero; 2]);
    for _ in 0..150 {
        let [[k0, k1], [k2, k3]] = *gains;
        let force = k0 * q[0] + k1 * q[1] + k2 * u[0] + k3 * u[1];
        euler::step(system, &[-force, zero], dt, &mut q, &mut u);
    }
    [q, u]
}

#[cfg(test)]
mod tests {
    use super::{Prepared, gains, held};

    /// From a tenth of a radian to less than a hundredth of it in three seconds; the cart is on its way back.
    #[test]
    fn the_pole_stands() {
        let system = Prepared::<f64>::nominal();
        let double = held(&system, &gains(&system));
        let system = Prepared::<f32>::nominal();
        let single = held(&system, &gains(&system)).map(|half| half.map(f64::from));
        for [[place, angle], [speed, turning]] in [double, single] {
            assert!(
                angle.abs() < 0.01 && turning.abs() < 0.01,
                "{angle} {turning}"
            );
            assert!(place.abs() < 0.1 && speed.abs() < 0.1, "{place} {speed}");
        }
    }
}
