//! The normal equations of a step: `(Jᵀ W J + λ 1) u = Jᵀ W e`, and their solution.

use crate::{Array, Real};

/// The error at some `q`: for each goal along the axes of its components, the inertial ones or, for
/// [`Seen`](crate::functions::Seen), those of the other frame.
#[derive(Clone, Copy, Debug, PartialEq)]
#[must_use = "only the error tells whether the goals were reached"]
pub struct Remaining<R> {
    /// The largest component of the position error, over all goals with a position, m.
    pub position: R,
    /// The largest component of the orientation error, over all goals with an orientation, rad. A rotation by a
    /// large angle counts as `2 sin(angle / 2)`.
    pub orientation: R,
    /// What steps reduce: half the sum of the squared distances and angles of all goals, each times its weight. A large angle counts as
    /// `4 sin(angle / 4)`, whose square has the slope that steps follow.
    pub weighted: R,
}

impl<R: Real + PartialOrd> Remaining<R> {
    /// True if no component exceeds `tolerance`, m and rad.
    #[must_use]
    pub fn is_within(&self, tolerance: R) -> bool {
        self.position <= tolerance && self.orientation <= tolerance
    }

    pub(super) fn raise_position(&mut self, way: &[R; 3]) {
        raise(&mut self.position, way);
    }

    pub(super) fn raise_orientation(&mut self, turn: &[R; 3]) {
        raise(&mut self.orientation, turn);
    }
}

/// Raises `peak` to the greatest magnitude of `values`, if that is greater; what is not a number stays.
fn raise<R: Real + PartialOrd>(peak: &mut R, values: &[R; 3]) {
    for value in values {
        let (before, value) = (*peak, value.abs());
        let lost = before.partial_cmp(&before).is_none();
        *peak = if lost || value <= before {
            before
        } else {
            value
        };
    }
}

/// Keeps the damping above zero where no speed moves a goal.
const TINY: f64 = 1e-30;

/// `Jᵀ W J`, `Jᵀ W e`, and how large `e` is: sums over all components of all goals.
#[derive(Clone, Copy, Debug)]
pub struct Equations<R, const NU: usize> {
    /// On and below the diagonal.
    matrix: [[R; NU]; NU],
    right: [R; NU],
    pub(super) remaining: Remaining<R>,
}

impl<R: Real, const NU: usize> Equations<R, NU> {
    pub(super) fn none() -> Self {
        let zero = R::from_f64(0.0);
        Self {
            matrix: [[zero; NU]; NU],
            right: [zero; NU],
            remaining: Remaining {
                position: zero,
                orientation: zero,
                weighted: zero,
            },
        }
    }

    /// Adds that `row u` is to be `error`; the row is zero but for `speeds`, in order.
    pub(super) fn add(&mut self, row: &[R; NU], error: R, weight: R, speeds: &[usize]) {
        let weighted = weight * error;
        for (count, &i) in speeds.iter().enumerate() {
            let entry = weight * row[i];
            self.right[i] = self.right[i] + row[i] * weighted;
            for &j in &speeds[..=count] {
                self.matrix[i][j] = self.matrix[i][j] + entry * row[j];
            }
        }
    }

    /// Adds what remains of a goal to what steps reduce.
    pub(super) fn weigh(&mut self, weight: R, square: R) {
        let half = R::from_f64(0.5);
        self.remaining.weighted = self.remaining.weighted + half * weight * square;
    }

    /// The greatest entry on the diagonal; a tiny number where all are zero.
    pub(super) fn scale(&self) -> R
    where
        R: PartialOrd,
    {
        let least = R::from_f64(TINY);
        let diagonal = self.matrix.iter().enumerate().map(|(i, row)| row[i]);
        diagonal.fold(least, |most, own| if own > most { own } else { most })
    }

    /// The speeds that solve the equations with `damping` on the diagonal; held speeds keep their values.
    pub(super) fn solve(&self, damping: R, held: &[Option<R>; NU]) -> [R; NU] {
        let (zero, one) = (R::from_f64(0.0), R::from_f64(1.0));
        let mut matrix: [[R; NU]; NU] = Array::from_fn(|i| {
            Array::from_fn(|j| match (held[i], held[j], i == j) {
                (None, None, true) => self.matrix[i][i] + damping,
                (None, None, false) => self.matrix[i][j],
                (_, _, true) => one,
                (_, _, false) => zero,
            })
        });
        let right = Array::from_fn(|i| {
            held[i].unwrap_or_else(|| {
                held.iter()
                    .enumerate()
                    .fold(self.right[i], |sum, (j, value)| {
                        let entry = self.matrix[i.max(j)][i.min(j)];
                        value.map_or(sum, |value| sum - entry * value)
                    })
            })
        });
        factor(&mut matrix);
        substitute(&matrix, right)
    }
}

/// Overwrites the part on and below the diagonal with `L D Lᵀ`: `D` on it, the unit triangular `L` below.
fn factor<R: Real, const NU: usize>(matrix: &mut [[R; NU]; NU]) {
    for i in 0..NU {
        let mut row = matrix[i];
        for j in 0..i {
            // `row[..j]` is `L D` by now, `row[j]` what is left of the entry.
            row[j] = (0..j).fold(row[j], |sum, k| sum - row[k] * matrix[j][k]);
        }
        let mut pivot = row[i];
        for j in 0..i {
            let entry = row[j] / matrix[j][j];
            pivot = pivot - entry * row[j];
            row[j] = entry;
        }
        row[i] = pivot;
        matrix[i] = row;
    }
}

/// The solution, from [`factor`]'s result.
fn substitute<R: Real, const NU: usize>(factors: &[[R; NU]; NU], right: [R; NU]) -> [R; NU] {
    let mut x = right;
    for i in 0..NU {
        x[i] = (0..i).fold(x[i], |sum, j| sum - factors[i][j] * x[j]);
    }
    for i in 0..NU {
        x[i] = x[i] / factors[i][i];
    }
    for i in (0..NU).rev() {
        x[i] = (i + 1..NU).fold(x[i], |sum, j| sum - factors[j][i] * x[j]);
    }
    x
}
