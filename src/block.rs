//! [`Block`]: where the compact columns of a partial velocity matrix belong.
//!
//! [`expand`] takes the columns and the pattern of one function, such as [`PartialVelocity`](crate::functions::PartialVelocity), and writes one
//! body's dense `3 x NU` matrix. Blocks that are always zero (Eqs. 16 and 30) are neither computed nor stored. Use a dense matrix for checks
//! and for other libraries, not in the control loop.

use crate::Real;

/// One structurally nonzero block of a body's partial velocity matrix: up to three columns of three components.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Block {
    /// The body of the matrix, index from 0.
    pub body: usize,
    /// Index from 0 of the notes' `2 NB` partitions: body `J`'s angles are `J`, its translations `NB + J`.
    pub partition: usize,
    /// Index from 0 in `u` of the block's first speed.
    pub speed: usize,
    /// 1 to 3: how many coordinates of the partition are free or mimic others. Their speeds are consecutive.
    pub columns: usize,
    /// Index of the block's first column in the compact array.
    pub first: usize,
}

/// Writes the dense `3 x NU` matrix of one body, `dense[component][speed]`, zeros included.
///
/// If other joints mimic a coordinate, its speed has several columns, which are added.
/// `columns` and `blocks` are the output and the pattern of the same function. A block that does
/// not fit into `columns` or into `NU` is skipped: it cannot come from the same function.
///
/// ```
/// use kane::{Block, block};
///
/// let columns = [[1.0, 2.0, 3.0]];
/// let blocks = [Block { body: 0, partition: 0, speed: 1, columns: 1, first: 0 }];
/// let mut dense = [[9.0; 2]; 3];
/// block::expand(&columns, &blocks, 0, &mut dense);
/// assert_eq!(dense, [[0.0, 1.0], [0.0, 2.0], [0.0, 3.0]]);
/// ```
pub fn expand<R: Real, const NU: usize>(
    columns: &[[R; 3]],
    blocks: &[Block],
    body: usize,
    dense: &mut [[R; NU]; 3],
) {
    *dense = [[R::from_f64(0.0); NU]; 3];
    each_column(columns, blocks, body, |speed, column| {
        for (row, value) in dense.iter_mut().zip(column) {
            if let Some(entry) = row.get_mut(speed) {
                *entry = *entry + *value;
            }
        }
    });
}

/// Like [`expand`], into a nalgebra matrix or a mutable view of one. Speeds beyond its columns are skipped.
#[cfg(feature = "nalgebra")]
pub fn expand_matrix<R, NU, S>(
    columns: &[[R; 3]],
    blocks: &[Block],
    body: usize,
    dense: &mut nalgebra::Matrix<R, nalgebra::U3, NU, S>,
) where
    R: Real + nalgebra::Scalar,
    NU: nalgebra::Dim,
    S: nalgebra::RawStorageMut<R, nalgebra::U3, NU>,
{
    dense.fill(R::from_f64(0.0));
    let n_speeds = dense.ncols();
    each_column(columns, blocks, body, |speed, column| {
        if speed < n_speeds {
            for (component, value) in column.iter().enumerate() {
                dense[(component, speed)] = dense[(component, speed)] + *value;
            }
        }
    });
}

/// Calls `place(speed, column)` for each stored column of `body`.
fn each_column<R>(
    columns: &[[R; 3]],
    blocks: &[Block],
    body: usize,
    mut place: impl FnMut(usize, &[R; 3]),
) {
    for block in blocks.iter().filter(|block| block.body == body) {
        let stored = columns.iter().skip(block.first).take(block.columns);
        for (offset, column) in stored.enumerate() {
            place(block.speed + offset, column);
        }
    }
}
