//! The little numerical work that the identities need: dense symmetric matrices, and derivatives along a line.

use crate::compare::larger;

/// A dense matrix, row by row.
#[derive(Clone, Debug)]
pub struct Matrix {
    pub n: usize,
    pub entries: Vec<f64>,
}

impl Matrix {
    pub fn new(n: usize, entries: Vec<f64>) -> Self {
        assert_eq!(entries.len(), n * n, "a square matrix");
        Self { n, entries }
    }

    pub fn identity(n: usize) -> Self {
        let entry = |place: usize| {
            if place.is_multiple_of(n + 1) {
                1.0
            } else {
                0.0
            }
        };
        Self::new(n, (0..n * n).map(entry).collect())
    }

    #[must_use]
    pub fn transposed(&self) -> Self {
        let entry = |place: usize| self.at(place % self.n, place / self.n);
        Self::new(self.n, (0..self.n * self.n).map(entry).collect())
    }

    #[must_use]
    pub fn product(&self, other: &Self) -> Self {
        let other = other.transposed();
        let rows = self.entries.chunks_exact(self.n);
        let rows = rows.flat_map(|row| other.times(row));
        Self::new(self.n, rows.collect())
    }

    /// With another one times a factor.
    #[must_use]
    pub fn plus_scaled(&self, factor: f64, other: &Self) -> Self {
        assert_eq!(self.n, other.n, "matrices of one size");
        let pairs = self.entries.iter().zip(&other.entries);
        Self::new(
            self.n,
            pairs.map(|(own, other)| own + factor * other).collect(),
        )
    }

    pub fn at(&self, row: usize, column: usize) -> f64 {
        self.entries[row * self.n + column]
    }

    pub fn times(&self, x: &[f64]) -> Vec<f64> {
        self.entries
            .chunks_exact(self.n)
            .map(|row| dot(row, x))
            .collect()
    }

    /// The largest sum of magnitudes in a row.
    pub fn norm(&self) -> f64 {
        let sum = |row: &[f64]| row.iter().map(|entry| entry.abs()).sum();
        self.entries.chunks_exact(self.n).map(sum).fold(0.0, larger)
    }

    /// `L` with `L L^T` the matrix, which only a positive definite one has.
    pub fn cholesky(&self) -> Option<Cholesky> {
        let mut l = vec![vec![0.0; self.n]; self.n];
        for row in 0..self.n {
            for column in 0..=row {
                let (above, below) = (&l[column][..column], &l[row][..column]);
                let rest = self.at(row, column) - dot(above, below);
                l[row][column] = if row == column {
                    if rest.is_nan() || rest <= 0.0 {
                        return None;
                    }
                    rest.sqrt()
                } else {
                    rest / l[column][column]
                };
            }
        }
        Some(Cholesky { l })
    }
}

/// A lower triangular factor.
#[derive(Clone, Debug)]
pub struct Cholesky {
    l: Vec<Vec<f64>>,
}

impl Cholesky {
    pub fn log_determinant(&self) -> f64 {
        self.l
            .iter()
            .enumerate()
            .map(|(place, row)| 2.0 * row[place].ln())
            .sum()
    }

    pub fn solve(&self, b: &[f64]) -> Vec<f64> {
        let n = self.l.len();
        let mut x = b.to_vec();
        for row in 0..n {
            x[row] = (x[row] - dot(&self.l[row][..row], &x[..row])) / self.l[row][row];
        }
        for row in (0..n).rev() {
            x[row] /= self.l[row][row];
            let solved = x[row];
            for (column, entry) in self.l[row][..row].iter().enumerate() {
                x[column] -= entry * solved;
            }
        }
        x
    }
}

/// The condition number of a positive definite matrix in the Euclidean norm, by iteration: never more than it is.
pub fn condition(matrix: &Matrix) -> f64 {
    let cholesky = matrix
        .cholesky()
        .expect("a mass matrix is positive definite");
    let iterate = |map: &dyn Fn(&[f64]) -> Vec<f64>| {
        let mut x: Vec<f64> = (0..matrix.n).map(|place| 1.0 + place as f64).collect();
        let mut size = 1.0;
        for _ in 0..100 {
            let norm = dot(&x, &x).sqrt();
            for x in &mut x {
                *x /= norm;
            }
            x = map(&x);
            size = dot(&x, &x).sqrt();
        }
        size
    };
    iterate(&|x| matrix.times(x)) * iterate(&|x| cholesky.solve(x))
}

pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The step of [`derivative`].
pub const STEP: f64 = 0.01;

/// The derivative of `f` at zero by the central difference of order 12.
///
/// Its error is `(6!)² / 13! h¹² f⁽¹³⁾`, 8e-5 of `(w h)¹² w` for an oscillation `sin(w x)`: with h = 0.01 and w = 10 (the
/// speeds of ten joints of unit speed added up) 1e-15. Rounding of `f` to 1e-16 weighs 2.5 / h: 2e-14 of `f`'s largest value.
pub fn derivative(f: impl Fn(f64) -> Vec<f64>) -> Vec<f64> {
    let mut sum: Vec<f64> = Vec::new();
    let mut weight = 1.0;
    for k in 1..=6_u8 {
        let k = f64::from(k);
        // (-1)^(k+1) (6!)² / (k (6-k)! (6+k)!), from the one before.
        weight *= (7.0 - k) / (6.0 + k);
        let sign = if k % 2.0 == 0.0 { -1.0 } else { 1.0 };
        let factor = sign * weight / (k * STEP);
        let (ahead, behind) = (f(k * STEP), f(-k * STEP));
        sum.resize(ahead.len(), 0.0);
        for (sum, (ahead, behind)) in sum.iter_mut().zip(ahead.iter().zip(&behind)) {
            *sum += factor * (ahead - behind);
        }
    }
    sum
}

/// The step of [`second_derivative`].
pub const SECOND_STEP: f64 = 0.02;

/// The second derivative of `f` at zero by the central difference of order 12.
///
/// Its error is `2 (6!)² / 14! h¹² f⁽¹⁴⁾`, 1.2e-5 of `(w h)¹² w²`: for an oscillation of w = 5 and h = 0.02 3e-16. Rounding of `f` to
/// 1e-16 weighs 6 / h²: 1.5e-12 of `f`'s largest value.
pub fn second_derivative(f: impl Fn(f64) -> f64) -> f64 {
    let (mut sum, mut weight, middle) = (0.0, 1.0, f(0.0));
    for k in 1..=6_u8 {
        let k = f64::from(k);
        // (-1)^(k+1) 2 (6!)² / (k² (6-k)! (6+k)!), from the one before.
        weight *= (7.0 - k) / (6.0 + k);
        let sign = if k % 2.0 == 0.0 { -1.0 } else { 1.0 };
        let factor = sign * 2.0 * weight / (k * k * SECOND_STEP * SECOND_STEP);
        let both = f(k * SECOND_STEP) + f(-k * SECOND_STEP);
        sum += factor * (both - 2.0 * middle);
    }
    sum
}

/// How many columns are independent: by elimination with complete pivoting, where what is at most `nothing` counts as zero.
pub fn rank(mut columns: Vec<Vec<f64>>, nothing: f64) -> usize {
    let mut rank = 0;
    while rank < columns.len() {
        let entries = columns.iter().enumerate().skip(rank);
        let entries = entries.flat_map(|(place, column)| {
            let rows = column.iter().enumerate();
            rows.map(move |(row, entry)| (entry.abs(), place, row))
        });
        let largest = entries.max_by(|a, b| a.0.total_cmp(&b.0));
        let Some((_, place, row)) = largest.filter(|(size, ..)| *size > nothing) else {
            break;
        };
        columns.swap(rank, place);
        let (done, rest) = columns.split_at_mut(rank + 1);
        let pivot = &done[rank];
        for column in rest {
            let factor = column[row] / pivot[row];
            for (entry, own) in column.iter_mut().zip(pivot) {
                *entry -= factor * own;
            }
            column[row] = 0.0;
        }
        rank += 1;
    }
    rank
}
