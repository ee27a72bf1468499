//! Discrete linear-quadratic regulators: the algebraic Riccati equation, by doubling.
//!
//! Of `x' = A x + B f` and the cost `½ Σ (xᵀ Q x + fᵀ R f)`. Each round doubles the number of steps that the cost looks ahead.

use nalgebra::DMatrix;

/// The gains `K` of `f = -K x`, and the cost `½ xᵀ P x` that is left; `None` where some matrix has no inverse.
pub fn regulator(
    a: &DMatrix<f64>,
    b: &DMatrix<f64>,
    q: &DMatrix<f64>,
    r: &DMatrix<f64>,
) -> Option<(DMatrix<f64>, DMatrix<f64>)> {
    let n = a.nrows();
    let one = DMatrix::identity(n, n);
    let r_inverse = r.clone().try_inverse()?;
    let (mut ahead, mut pushed, mut cost) = (a.clone(), b * r_inverse * b.transpose(), q.clone());
    // 2^40 steps are an eternity for any regulator.
    for _ in 0..40 {
        let factors = (&one + &pushed * &cost).lu();
        let (by_ahead, by_pushed) = (factors.solve(&ahead)?, factors.solve(&pushed)?);
        let more = ahead.transpose() * &cost * &by_ahead;
        pushed += &ahead * by_pushed * ahead.transpose();
        ahead *= by_ahead;
        cost += &more;
        cost = 0.5 * (&cost + cost.transpose());
        pushed = 0.5 * (&pushed + pushed.transpose());
        if more.norm() <= 1e-14 * cost.norm() {
            break;
        }
    }
    let of_b = b.transpose() * &cost;
    let gains = (r + &of_b * b).cholesky()?.solve(&(of_b * a));
    Some((gains, cost))
}
