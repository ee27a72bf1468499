//! All parameters of a physically consistent arm, by log-Cholesky parameters.
//!
//! A body is `P = U V Vᵀ Uᵀ`: `U Uᵀ` is the prior's pseudo-inertia, and `V` is upper triangular. Its parameters `θ` are the logarithms of its
//! diagonal and the entries above it, ten numbers without units, zero where the body is the prior's. Any ten make `P` positive definite.
//! A drive's coefficient is the prior's times `exp(θ)`.

use nalgebra::{DMatrix, DVector, Matrix4};

use crate::{
    Arm,
    drive::COEFFICIENTS,
    pseudo_inertia::{self, PARAMETERS},
    stack::base_parameters,
};

/// Bodies and drives of an arm.
#[derive(Clone, Debug)]
pub struct Physical {
    /// The pseudo-inertia of each body.
    pub bodies: Vec<Matrix4<f64>>,
    /// Each joint's coefficients.
    pub drives: Vec<[f64; COEFFICIENTS]>,
}

impl Physical {
    /// All parameters, body after body, then drive after drive.
    pub fn parameters(&self) -> DVector<f64> {
        let bodies = self.bodies.iter().flat_map(pseudo_inertia::parameters);
        let all = bodies.chain(self.drives.iter().copied().flatten());
        DVector::from_iterator(self.len(), all)
    }

    /// The number of parameters.
    fn len(&self) -> usize {
        PARAMETERS * self.bodies.len() + COEFFICIENTS * self.drives.len()
    }

    /// The arm with these `θ`, where this one is the prior.
    ///
    /// # Panics
    /// If a body of this one is not physically consistent.
    #[must_use]
    pub fn moved(&self, theta: &DVector<f64>) -> Self {
        let mut rest = theta.as_slice();
        let bodies = self.bodies.iter().map(|p| {
            let factor = upper(p) * triangle(take(&mut rest)).0;
            factor * factor.transpose()
        });
        let bodies = bodies.collect();
        let drives = self.drives.iter().map(|of_joint| {
            let theta: [f64; COEFFICIENTS] = take(&mut rest);
            std::array::from_fn(|i| of_joint[i] * theta[i].exp())
        });
        let drives = drives.collect();
        Self { bodies, drives }
    }

    /// The derivatives of the parameters of [`moved`](Self::moved) by `θ`, a column each.
    ///
    /// # Panics
    /// As there.
    pub fn derivative(&self, theta: &DVector<f64>) -> DMatrix<f64> {
        let mut rest = theta.as_slice();
        let mut derivative = DMatrix::zeros(self.len(), self.len());
        for (k, p) in self.bodies.iter().enumerate() {
            let u = upper(p);
            let (v, derivatives) = triangle(take(&mut rest));
            for (i, v_dot) in derivatives.iter().enumerate() {
                let half = u * v_dot * v.transpose() * u.transpose();
                let column = pseudo_inertia::parameters(&(half + half.transpose()));
                for (j, entry) in column.into_iter().enumerate() {
                    derivative[(PARAMETERS * k + j, PARAMETERS * k + i)] = entry;
                }
            }
        }
        let first = PARAMETERS * self.bodies.len();
        for (i, coefficient) in self.drives.as_flattened().iter().enumerate() {
            derivative[(first + i, first + i)] = coefficient * rest[i].exp();
        }
        derivative
    }
}

fn take<const N: usize>(rest: &mut &[f64]) -> [f64; N] {
    let (first, others) = rest.split_first_chunk().expect("one number a parameter");
    *rest = others;
    *first
}

/// The upper triangular `U` with `P = U Uᵀ`: the Cholesky factor, with rows and columns in reverse.
fn upper(p: &Matrix4<f64>) -> Matrix4<f64> {
    let turned = |m: &Matrix4<f64>| Matrix4::from_fn(|i, j| m[(3 - i, 3 - j)]);
    let lower = turned(p).cholesky().expect("a body of positive density");
    turned(&lower.l())
}

/// The places above the diagonal of `V`.
const ABOVE: [(usize, usize); 6] = [(0, 1), (0, 2), (1, 2), (0, 3), (1, 3), (2, 3)];

/// `V` and its derivatives: `θ` begins with the logarithms of the diagonal.
fn triangle(theta: [f64; PARAMETERS]) -> (Matrix4<f64>, [Matrix4<f64>; PARAMETERS]) {
    let mut v = Matrix4::zeros();
    let mut derivatives = [v; PARAMETERS];
    for (k, theta) in theta.into_iter().enumerate() {
        let (place, value, slope) = match k.checked_sub(4) {
            None => ((k, k), theta.exp(), theta.exp()),
            Some(above) => (ABOVE[above], theta, 1.0),
        };
        v[place] = value;
        derivatives[k][place] = slope;
    }
    (v, derivatives)
}

/// The matrix that makes base parameters and drives' coefficients of all parameters.
pub fn base<A: Arm>() -> DMatrix<f64> {
    let (bodies, drives) = (A::BODY_NAMES.len(), COEFFICIENTS * A::SPEED_NAMES.len());
    let (first, base) = (PARAMETERS * bodies, base_parameters::<A>());
    let mut sums = DMatrix::zeros(base + drives, first + drives);
    for term in A::TERMS {
        sums[(term.base, PARAMETERS * term.body + term.parameter)] = term.factor;
    }
    for i in 0..drives {
        sums[(base + i, first + i)] = 1.0;
    }
    sums
}
