//! The mass matrix, its products, solutions, inverse and factors, and the matrices of its motion.

use crate::{Array, Real, System};

/// Mass matrix `M` (`A` in the notes), symmetric, written whole, `m[row][column]`. Eq. (42); often called
/// the joint-space inertia matrix or, by its algorithm, CRBA.
///
/// Units kg m², kg m and kg, depending on the units of the two speeds.
#[diagnostic::on_unimplemented(
    message = "`{Self}` was generated without `mass_matrix`; name it in `functions`, alone and not in a sum, and generate again"
)]
pub trait MassMatrix<R: Real>: System<R> {
    /// Overwrites the last argument; meaning, frame and unit are those of [`MassMatrix`].
    fn mass_matrix(&self, q: &Self::Q, m: &mut Self::Matrix);
}

/// The entries of the [`MassMatrix`] on and below the diagonal that are not structurally zero, row by row. Eq. (42).
///
/// Entries of two speeds that move no common body are left out. For a humanoid a quarter of the matrix remains, in the form that
/// sparse solvers along the tree use. [`unpack`] makes the whole matrix.
#[diagnostic::on_unimplemented(
    message = "`{Self}` was generated without `mass_matrix_packed`; name it in `functions`, alone and not in a sum, and generate again"
)]
pub trait MassMatrixPacked<R: Real>: System<R> {
    /// `[R; n]`, one entry for each place.
    type Entries: Array<R>;
    /// The row and the column of each entry, column not above row; ordered by row, within a row by column.
    const PLACES: &'static [[usize; 2]];
    /// Overwrites the last argument; meaning, frame and unit are those of [`MassMatrix`].
    fn mass_matrix_packed(&self, q: &Self::Q, entries: &mut Self::Entries);
}

/// Writes the whole symmetric matrix with these `entries` at these `places`; all other entries become zero.
///
/// For packed mass matrices and their inverses, and for second derivatives. Entries without a place, and places outside the matrix, are
/// ignored.
pub fn unpack<R: Real, Row: Array<R>>(
    entries: &[R],
    places: &[[usize; 2]],
    m: &mut impl Array<Row>,
) {
    let rows = m.as_mut();
    for row in rows.iter_mut() {
        *row = Row::filled(R::from_f64(0.0));
    }
    for (&entry, &[row, column]) in entries.iter().zip(places) {
        for [row, column] in [[row, column], [column, row]] {
            let place = rows
                .get_mut(row)
                .and_then(|row| row.as_mut().get_mut(column));
            if let Some(place) = place {
                *place = entry;
            }
        }
    }
}

function_traits! {
    /// The [`MassMatrix`] times accelerations, `tau = M u_dot`, N m and N, rotors included; no matrix is formed. Eq. (42).
    ///
    /// Inverse dynamics without bias. Often called the mass-matrix-vector product; with `u` instead of `u_dot`, the
    /// generalized momentum.
    "`{Self}` was generated without `mass_matrix_product`; name it in `functions`, alone and not in a sum, and generate again"
    MassMatrixProduct: mass_matrix_product(q: &Self::Q, u_dot: &Self::U, tau: &mut Self::U);

    /// The accelerations from forces alone, `u_dot = M⁻¹ tau`, rad/s² and m/s²: forward dynamics without bias. Eq. (42).
    ///
    /// If `R` holds several numbers ([`Lanes`](crate::Lanes)), this solves several right-hand sides together: one per
    /// lane, with the same `q` or one of its own. Nothing is checked, as in [`ForwardDynamics`](super::ForwardDynamics).
    "`{Self}` was generated without `mass_matrix_solve`; name it in `functions`, alone and not in a sum, and generate again"
    MassMatrixSolve: mass_matrix_solve(q: &Self::Q, tau: &Self::U, u_dot: &mut Self::U);
}

/// The inverse of the [`MassMatrix`], symmetric, written whole, `inverse[row][column]`. Eq. (42); often
/// called Minv, or the inverse of the joint-space inertia matrix.
///
/// Units are those of accelerations over those of forces. Nothing is checked, as in [`ForwardDynamics`](super::ForwardDynamics).
#[diagnostic::on_unimplemented(
    message = "`{Self}` was generated without `mass_matrix_inverse`; name it in `functions`, alone and not in a sum, and generate again"
)]
pub trait MassMatrixInverse<R: Real>: System<R> {
    /// Overwrites the last argument; meaning, frame and unit are those of [`MassMatrixInverse`].
    fn mass_matrix_inverse(&self, q: &Self::Q, inverse: &mut Self::Matrix);
}

/// The entries of the [`MassMatrixInverse`] on and below the diagonal that are not structurally zero, row by row.
///
/// Entries of two speeds of separate trees on the inertial frame are left out. [`unpack`] makes the whole matrix.
#[diagnostic::on_unimplemented(
    message = "`{Self}` was generated without `mass_matrix_inverse_packed`; name it in `functions`, alone and not in a sum, and generate again"
)]
pub trait MassMatrixInversePacked<R: Real>: System<R> {
    /// `[R; n]`, one entry for each place.
    type Entries: Array<R>;
    /// The row and the column of each entry, column not above row; ordered by row, within a row by column.
    const PLACES: &'static [[usize; 2]];
    /// Overwrites the last argument; meaning, frame and unit are those of [`MassMatrixInverse`].
    fn mass_matrix_inverse_packed(&self, q: &Self::Q, entries: &mut Self::Entries);
}

/// The factors of the [`MassMatrix`], `M = Lᵀ D L` along the tree, a sparse Cholesky factorisation. Eq. (42).
///
/// D is on the diagonal, in the units of the mass matrix's, L beside it with an implied unit diagonal; an entry of L is a ratio of two speeds. There is no fill-in, except where mimic joints couple branches.
/// Rows are eliminated from the leaves inward, in the order [`Self::ORDER`]. [`solve_factored`] solves with the factors.
#[diagnostic::on_unimplemented(
    message = "`{Self}` was generated without `mass_matrix_factors`; name it in `functions`, alone and not in a sum, and generate again"
)]
pub trait MassMatrixFactors<R: Real>: System<R> {
    /// `[R; n]`, one entry for each place.
    type Entries: Array<R>;
    /// The two speeds of each entry, the higher-numbered first; ordered by that one, then by the other.
    const PLACES: &'static [[usize; 2]];
    /// The `NU` speeds in the order of their elimination. Of the two speeds of an entry of L, the one that comes first here
    /// is its row, the other its column.
    const ORDER: &'static [usize];
    /// Overwrites the last argument; meaning and units are those of [`MassMatrixFactors`].
    fn mass_matrix_factors(&self, q: &Self::Q, entries: &mut Self::Entries);
}

/// Coriolis matrix `C`, written whole, `c[row][column]`: `C u` is the [`Bias`](super::Bias) without weight, springs and dampers,
/// `M_dot = C + Cᵀ`, and `M_dot - 2 C` is skew-symmetric. An entry times its speed is a generalized force, N m or N. Eqs. (15), (20), (32), (33); often called centrifugal and Coriolis matrix.
///
/// It is the sum of `m Vᵀ V_dot` over all particles, with `V` their partial velocities. If all speeds are rates of coordinates, it is the matrix
/// that the Christoffel symbols of the first kind give.
#[diagnostic::on_unimplemented(
    message = "`{Self}` was generated without `coriolis_matrix`; name it in `functions`, alone and not in a sum, and generate again"
)]
pub trait CoriolisMatrix<R: Real>: System<R> {
    /// Overwrites the last argument; meaning, frame and unit are those of [`CoriolisMatrix`].
    fn coriolis_matrix(&self, q: &Self::Q, u: &Self::U, c: &mut Self::Matrix);
}

/// Rate of the [`MassMatrix`] for the motion `u`, `M_dot = C + Cᵀ`: symmetric, written whole,
/// `m_dot[row][column]`; the unit is that of the mass matrix, per second.
#[diagnostic::on_unimplemented(
    message = "`{Self}` was generated without `mass_matrix_dot`; name it in `functions`, alone and not in a sum, and generate again"
)]
pub trait MassMatrixDot<R: Real>: System<R> {
    /// Overwrites the last argument; meaning, frame and unit are those of [`MassMatrixDot`].
    fn mass_matrix_dot(&self, q: &Self::Q, u: &Self::U, m_dot: &mut Self::Matrix);
}

/// Solves `M x = b` with the factors of `M`, in place: `b` becomes `x`.
///
/// `entries`, `places` and `order` are those of [`MassMatrixFactors`]. Entries missing from the lists count as zero. For one `b` a state,
/// [`MassMatrixSolve`](super::MassMatrixSolve) is faster.
///
/// ```
/// use kane::{Array, Real, functions::{MassMatrixFactors, solve_factored}};
///
/// /// Accelerations of several forces, in one state.
/// fn accelerations<R: Real, S: MassMatrixFactors<R>>(system: &S, q: &S::Q, forces: &mut [S::U]) {
///     let mut entries = S::Entries::filled(R::from_f64(0.0));
///     system.mass_matrix_factors(q, &mut entries);
///     for force in forces {
///         solve_factored(entries.as_ref(), S::PLACES, S::ORDER, force.as_mut());
///     }
/// }
/// ```
pub fn solve_factored<R: Real>(entries: &[R], places: &[[usize; 2]], order: &[usize], b: &mut [R]) {
    let is_by_rows = order.iter().rev().copied().eq(0..b.len());
    if is_by_rows {
        solve_by_rows(entries, places, b);
    } else {
        solve_in_order(entries, places, order, b);
    }
}

/// The same where the last speed is eliminated first, as on most trees: entries are then in the order in which they are needed.
fn solve_by_rows<R: Real>(entries: &[R], places: &[[usize; 2]], b: &mut [R]) {
    for (&l, &[row, column]) in entries.iter().zip(places).rev() {
        if row != column
            && let Some(&own) = b.get(row)
            && let Some(rest) = b.get_mut(column)
        {
            *rest = *rest - l * own;
        }
    }
    let mut rest = entries;
    for row in places.chunk_by(|[one, _], [other, _]| one == other) {
        let Some((own, others)) = rest.split_at_checked(row.len()) else {
            return;
        };
        rest = others;
        // A row ends with its pivot.
        let (Some((&pivot, own)), Some((&[k, last], columns))) =
            (own.split_last(), row.split_last())
        else {
            continue;
        };
        let Some(&known) = b.get(k).filter(|_| k == last) else {
            continue;
        };
        let mut x = known / pivot;
        for (&l, &[_, column]) in own.iter().zip(columns).rev() {
            if let Some(&solved) = b.get(column) {
                x = x - l * solved;
            }
        }
        if let Some(solved) = b.get_mut(k) {
            *solved = x;
        }
    }
}

/// The same in any order.
fn solve_in_order<R: Real>(entries: &[R], places: &[[usize; 2]], order: &[usize], b: &mut [R]) {
    let entry = |k: usize, other: usize| {
        let place = places.binary_search(&[k.max(other), k.min(other)]).ok()?;
        entries.get(place).copied()
    };
    let outer = |place: usize| order.get(place + 1..).unwrap_or(&[]);
    for (place, &k) in order.iter().enumerate() {
        let Some(&own) = b.get(k) else { continue };
        for &other in outer(place) {
            if let (Some(l), Some(rest)) = (entry(k, other), b.get_mut(other)) {
                *rest = *rest - l * own;
            }
        }
    }
    for (place, &k) in order.iter().enumerate().rev() {
        let (Some(pivot), Some(&own)) = (entry(k, k), b.get(k)) else {
            continue;
        };
        let mut x = own / pivot;
        for &other in outer(place) {
            if let (Some(l), Some(solved)) = (entry(k, other), b.get(other)) {
                x = x - l * *solved;
            }
        }
        if let Some(solved) = b.get_mut(k) {
            *solved = x;
        }
    }
}
