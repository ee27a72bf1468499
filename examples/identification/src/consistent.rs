//! From what torques tell to all parameters of a physically consistent arm.
//!
//! Least squares of noisy torques may give base parameters that no arm of positive density has, and base parameters leave most of a
//! body's ten parameters open. So the estimate is sought among consistent arms alone: the one with the least sum of squares of what it misses of the
//! torques and of what it is off the prior. Log-Cholesky parameters make every trial consistent, so that Gauss-Newton steps need no
//! constraints, and being near the prior does not depend on units or axes.

use nalgebra::{DMatrix, DVector};

use crate::{Identifiable, Physical};

/// The most Gauss-Newton steps,
const STEPS: usize = 200;
/// and the shortest part of one that is tried.
const SHORTEST: f64 = 1e-4;
/// Where a step lowers the cost by a smaller part, it was the last.
const GAIN: f64 = 1e-10;

/// The arm with the least `|R (S π - x)|² + |θ|² / deviation²`.
///
/// `x` is `found` by least squares, and `R` of `identifiable` counts in its standard deviations; `θ` are the log-Cholesky parameters, which
/// the `prior` has zero, and `π` the arm's parameters; `sums` is `S`, which makes those that are identified of all.
pub fn consistent(
    prior: &Physical,
    deviation: f64,
    identifiable: &Identifiable,
    sums: &DMatrix<f64>,
    found: &DVector<f64>,
) -> Physical {
    let weight = deviation.powi(-2);
    let weighted = &identifiable.r * sums;
    let target = &identifiable.r * found;
    let missed = |theta: &DVector<f64>| &weighted * prior.moved(theta).parameters() - &target;
    let cost = |theta: &DVector<f64>| missed(theta).norm_squared() + weight * theta.norm_squared();
    let mut theta = DVector::zeros(sums.ncols());
    let mut least = cost(&theta);
    for _ in 0..STEPS {
        let j = &weighted * prior.derivative(&theta);
        // `J Jᵀ` is the smaller of both products: more parameters are open than told.
        let mut product = &j * j.transpose();
        for i in 0..product.nrows() {
            product[(i, i)] += weight;
        }
        let Some(product) = product.cholesky() else {
            break;
        };
        let step = j.tr_mul(&product.solve(&(&j * &theta - missed(&theta)))) - &theta;
        let mut part = 1.0;
        while cost(&(&theta + part * &step)) >= least && part > SHORTEST {
            part /= 2.0;
        }
        let next = &theta + part * step;
        let lower = cost(&next);
        let gain = least - lower;
        if lower < least {
            (theta, least) = (next, lower);
        }
        if gain <= GAIN * least {
            break;
        }
    }
    prior.moved(&theta)
}
