//! Quadratic costs between limits, by Newton's steps that are projected onto them.
//!
//! `min ½ xᵀ H x + gᵀ x` with `lower ≤ x ≤ upper`, a few entries: what is at a limit and pressed against it is left out, the rest takes
//! Newton's step, which is cut at the limits, and shortened until the cost falls.

use nalgebra::{Cholesky, Const, SMatrix, SVector};

/// A minimum, and which entries are within their limits.
#[derive(Clone, Debug)]
pub struct Minimum<const M: usize> {
    /// Where it is.
    pub x: SVector<f64, M>,
    /// True for entries that no limit holds.
    pub is_free: [bool; M],
    /// The factors of `H` on the free entries, one on the others.
    factors: Cholesky<f64, Const<M>>,
}

impl<const M: usize> Minimum<M> {
    /// `H⁻¹` on the free entries times a matrix; zero on the others.
    pub fn solve<const N: usize>(&self, mut b: SMatrix<f64, M, N>) -> SMatrix<f64, M, N> {
        for (row, is_free) in self.is_free.into_iter().enumerate() {
            if !is_free {
                b.row_mut(row).fill(0.0);
            }
        }
        self.factors.solve(&b)
    }
}

/// The minimum; `None` where `H` is not positive definite on the free entries.
pub fn minimum<const M: usize>(
    h: &SMatrix<f64, M, M>,
    g: &SVector<f64, M>,
    lower: &SVector<f64, M>,
    upper: &SVector<f64, M>,
) -> Option<Minimum<M>> {
    let cut = |x: SVector<f64, M>| x.zip_zip_map(lower, upper, |x, low, high| x.max(low).min(high));
    let cost = |x: &SVector<f64, M>| (0.5 * (h * x) + g).dot(x);
    let mut x = cut(SVector::zeros());
    let mut found = None;
    // Each round ends with another set of free entries, or with the minimum of this one.
    for _ in 0..4 * M + 4 {
        let gradient = h * x + g;
        let is_free: [bool; M] = std::array::from_fn(|i| {
            !(x[i] <= lower[i] && gradient[i] > 0.0 || x[i] >= upper[i] && gradient[i] < 0.0)
        });
        let own = SMatrix::from_fn(|i, j| match (is_free[i] && is_free[j], i == j) {
            (true, _) => h[(i, j)],
            (false, true) => 1.0,
            (false, false) => 0.0,
        });
        let factors = Cholesky::new(own)?;
        let here = Minimum {
            x,
            is_free,
            factors,
        };
        let step = -here.solve(gradient);
        found = Some(here);
        if step.norm() <= 1e-12 * (1.0 + x.norm()) {
            break;
        }
        let mut part = 1.0;
        let next = loop {
            let next = cut(x + part * step);
            // A tenth of the fall that the slope promises.
            if cost(&next) <= cost(&x) + 0.1 * gradient.dot(&(next - x)) || part < 1e-6 {
                break next;
            }
            part *= 0.5;
        };
        x = next;
    }
    found
}
