//! The arrays that generated functions take and write, as vectors and matrices of nalgebra.
//!
//! Vectors are viewed without copying. Generated matrices are row-major, nalgebra's are column-major, so
//! a view without copying is the transpose; for the mass matrix, which is symmetric, that is the
//! matrix itself. There are deliberately no strided views: nalgebra 0.35 multiplies those out of
//! bounds (nalgebra#1616). nalgebra's vectors convert from and into `[R; N]`:
//! `let q: [f64; 7] = vector.into()`.
//!
//! Generated functions also take nalgebra's vectors `SVector<R, N>` in place, without a copy: up to 16 entries as `v.as_ref()` and `v.as_mut()`,
//! of any length as `&v.data.0[0]` and `&mut v.data.0[0]`:
//!
//! ```
//! # #[cfg(feature = "cart_pole")] {
//! use kane::cart_pole::{self, Prepared};
//! use nalgebra::Vector2;
//!
//! let system = Prepared::<f64>::nominal();
//! let (q, u, tau) = (Vector2::new(0.0, 0.1), Vector2::new(0.0, 0.0), Vector2::new(1.0, 0.0));
//! let mut u_dot = Vector2::zeros();
//! cart_pole::forward_dynamics(&system, q.as_ref(), u.as_ref(), tau.as_ref(), u_dot.as_mut());
//! let mut same = Vector2::zeros();
//! cart_pole::forward_dynamics(&system, &q.data.0[0], &u.data.0[0], &tau.data.0[0], &mut same.data.0[0]);
//! assert!(u_dot == same && u_dot[0] != 0.0);
//! # }
//! ```
//!
//! ```
//! use kane::view;
//!
//! let mass_matrix = [[2.0, 1.0], [1.0, 3.0]];
//! let u_dot = [1.0, -1.0];
//! let tau: [f64; 2] = (view::transposed(&mass_matrix) * view::vector(&u_dot)).into();
//! assert_eq!(tau, [1.0, -2.0]);
//! ```
//!
//! [`stacked`] makes a Jacobian of six rows, [`step_by_state`] the matrix `A` of a discrete step, [`step_by_tau`] the matrix `B`. The last two need the
//! type of the result, because a compiler does not find `2 N` by itself: `let a: SMatrix<f64, 14, 14> = step_by_state(&derivatives)`.
//!
//! Without `std`, decompositions and norms need nalgebra's feature `libm`.

use nalgebra::{
    Const, MatrixView, MatrixViewMut, Rotation3, SMatrix, Scalar, VectorView, VectorViewMut,
};

use crate::{Array, discrete::StepDerivatives};

/// `q`, `u`, `tau`, or one body's vector, as a column vector.
#[must_use]
pub fn vector<R: Scalar, const N: usize>(array: &[R; N]) -> VectorView<'_, R, Const<N>> {
    VectorView::<R, Const<N>>::from_slice(array)
}

/// Like [`vector`], for writing.
#[must_use]
pub fn vector_mut<R: Scalar, const N: usize>(array: &mut [R; N]) -> VectorViewMut<'_, R, Const<N>> {
    VectorViewMut::<R, Const<N>>::from_slice(array)
}

/// The transpose of an array of rows: entry `(i, j)` is `rows[j][i]`.
///
/// For the mass matrix this is the matrix itself; for a body's rotation matrix its inverse, which maps body
/// components to inertial ones.
#[must_use]
pub fn transposed<R: Scalar, const ROWS: usize, const COLUMNS: usize>(
    rows: &[[R; COLUMNS]; ROWS],
) -> MatrixView<'_, R, Const<COLUMNS>, Const<ROWS>> {
    MatrixView::<R, Const<COLUMNS>, Const<ROWS>>::from_slice(rows.as_flattened())
}

/// Like [`transposed`], for writing.
#[must_use]
pub fn transposed_mut<R: Scalar, const ROWS: usize, const COLUMNS: usize>(
    rows: &mut [[R; COLUMNS]; ROWS],
) -> MatrixViewMut<'_, R, Const<COLUMNS>, Const<ROWS>> {
    MatrixViewMut::<R, Const<COLUMNS>, Const<ROWS>>::from_slice(rows.as_flattened_mut())
}

/// Copies an array of rows into a matrix: entry `(i, j)` is `rows[i][j]`.
#[must_use]
pub fn matrix<R: Scalar, const ROWS: usize, const COLUMNS: usize>(
    rows: &[[R; COLUMNS]; ROWS],
) -> SMatrix<R, ROWS, COLUMNS> {
    transposed(rows).transpose()
}

/// Copies a matrix into an array of rows.
#[must_use]
pub fn to_rows<R: Scalar, const ROWS: usize, const COLUMNS: usize>(
    matrix: &SMatrix<R, ROWS, COLUMNS>,
) -> [[R; COLUMNS]; ROWS] {
    matrix.transpose().into()
}

/// Copies two arrays of three rows into one matrix of six: a Jacobian from its linear and angular rows, in the order in which they are
/// given. Linear rows come first in Pinocchio and here, angular ones in Drake.
///
/// ```
/// use kane::view;
///
/// let (linear, angular) = ([[1.0], [2.0], [3.0]], [[4.0], [5.0], [6.0]]);
/// let jacobian = view::stacked(&linear, &angular);
/// assert_eq!(jacobian[(1, 0)], 2.0);
/// assert_eq!(jacobian[(5, 0)], 6.0);
/// ```
#[must_use]
pub fn stacked<R: Scalar, const COLUMNS: usize>(
    first: &[[R; COLUMNS]; 3],
    second: &[[R; COLUMNS]; 3],
) -> SMatrix<R, 6, COLUMNS> {
    let rows = [first, second];
    SMatrix::from_fn(|i, j| rows[i / 3][i % 3][j].clone())
}

/// Copies one body's rotation matrix into nalgebra's type.
///
/// Like `R_K`, Eq. (2), it maps inertial components to body components. The nine numbers are copied as they are, orthonormal up
/// to rounding.
#[must_use]
pub fn rotation<R: Scalar>(rows: &[[R; 3]; 3]) -> Rotation3<R> {
    Rotation3::from_matrix_unchecked(matrix(rows))
}

/// Copies the derivatives of a discrete step by the state into `A`, for `N` speeds and `N2 = 2 N`: changes of `q` come before those of `u`.
/// Write the type of the result, as below, or the compiler asks for `N2`.
///
/// ```
/// use kane::discrete::StepDerivatives;
/// use kane::view::step_by_state;
/// use nalgebra::SMatrix;
///
/// let block = |number| [[number]];
/// let derivatives = StepDerivatives {
///     q_by_q: block(1.0), q_by_u: block(2.0), q_by_tau: block(3.0),
///     u_by_q: block(4.0), u_by_u: block(5.0), u_by_tau: block(6.0),
/// };
/// let a: SMatrix<f64, 2, 2> = step_by_state(&derivatives);
/// assert_eq!(a, SMatrix::<f64, 2, 2>::new(1.0, 2.0, 4.0, 5.0));
///
/// // The same of any system with one speed.
/// fn of<S: kane::System<f64>>(derivatives: &StepDerivatives<S::Matrix>) -> SMatrix<f64, 2, 2> {
///     step_by_state(derivatives)
/// }
/// ```
#[must_use]
pub fn step_by_state<R: Scalar + Copy, Row: Array<R>, M: Array<Row>, const N2: usize>(
    derivatives: &StepDerivatives<M>,
) -> SMatrix<R, N2, N2> {
    const { assert!(N2 == 2 * M::LEN, "`A` has two rows a speed") };
    let d = derivatives;
    let (n, blocks) = (M::LEN, [[&d.q_by_q, &d.q_by_u], [&d.u_by_q, &d.u_by_u]]);
    SMatrix::from_fn(|row, column| blocks[row / n][column / n][row % n][column % n])
}

/// Copies the derivatives of a discrete step by the forces into `B`, for `N` speeds and `N2 = 2 N`: two rows and one column per speed.
/// Write the type of the result, as for [`step_by_state`]: `let b: SMatrix<f64, N2, N> = ..`.
#[must_use]
pub fn step_by_tau<
    R: Scalar + Copy,
    Row: Array<R>,
    M: Array<Row>,
    const N: usize,
    const N2: usize,
>(
    derivatives: &StepDerivatives<M>,
) -> SMatrix<R, N2, N> {
    const { assert!(N == M::LEN && N2 == 2 * N, "`B` has two rows a speed") };
    let blocks = [&derivatives.q_by_tau, &derivatives.u_by_tau];
    SMatrix::from_fn(|row, column| blocks[row / N][row % N][column])
}
