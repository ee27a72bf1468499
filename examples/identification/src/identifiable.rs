//! What torques can tell: the independent columns of the regressors, and the least squares on them.
//!
//! The columns of `base_regressor` are independent, but not of those of the rotors: where a body's moment of inertia about its joint's axis
//! is felt at this joint alone, the joint's rotor is felt alike. Such a column is left out, and its rotor is added to what has its column.

use nalgebra::{DMatrix, DVector};

use crate::extremes::{largest, least};

/// A column is a sum of those before it where they leave no greater part of it.
const DEPENDENT: f64 = 1e-9;

/// `W = Q R S`: `Q` has orthonormal columns, `R` is upper triangular, and `S` makes the parameters that can be identified of all.
#[derive(Clone, Debug)]
pub struct Identifiable {
    /// The independent columns.
    pub columns: Vec<usize>,
    /// `Q`.
    pub q: DMatrix<f64>,
    /// `R`.
    pub r: DMatrix<f64>,
    /// `S`.
    pub sums: DMatrix<f64>,
}

impl Identifiable {
    /// By modified Gram-Schmidt, column by column, each twice: what rounding leaves of the first time goes with the second.
    pub fn of(w: &DMatrix<f64>) -> Self {
        let (mut columns, mut q) = (Vec::new(), Vec::<DVector<f64>>::new());
        let mut coefficients = DMatrix::zeros(w.ncols(), w.ncols());
        for j in 0..w.ncols() {
            let mut rest = w.column(j).into_owned();
            let length = rest.norm();
            for _ in 0..2 {
                for (i, q) in q.iter().enumerate() {
                    let along = q.dot(&rest);
                    rest.axpy(-along, q, 1.0);
                    coefficients[(i, j)] += along;
                }
            }
            if rest.norm() > DEPENDENT * length {
                coefficients[(q.len(), j)] = rest.norm();
                q.push(rest.normalize());
                columns.push(j);
            }
        }
        let coefficients = coefficients.rows(0, q.len());
        let r = coefficients.select_columns(&columns);
        let sums = solved(&r, &coefficients.into_owned());
        Self {
            columns,
            q: DMatrix::from_columns(&q),
            r,
            sums,
        }
    }

    /// The parameters by which `W` comes nearest to these torques.
    pub fn least_squares(&self, torques: &DVector<f64>) -> DVector<f64> {
        let sums = self.q.tr_mul(torques);
        self.r.solve_upper_triangular(&sums).expect(INDEPENDENT)
    }

    /// Their standard deviations, where those of the torques are one.
    pub fn deviations(&self) -> DVector<f64> {
        let size = self.columns.len();
        let inverse = solved(&self.r, &DMatrix::identity(size, size));
        DVector::from_fn(inverse.nrows(), |i, _| inverse.row(i).norm())
    }

    /// The condition number of the independent columns, which are in SI units.
    pub fn condition(&self) -> f64 {
        let values = self.r.singular_values();
        largest(&values) / least(&values)
    }
}

/// Why `R` has no zero on its diagonal.
const INDEPENDENT: &str = "the columns are independent";

/// `R⁻¹ B`.
fn solved(r: &DMatrix<f64>, b: &DMatrix<f64>) -> DMatrix<f64> {
    r.solve_upper_triangular(b).expect(INDEPENDENT)
}
