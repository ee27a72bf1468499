//! Principal axes, by MuJoCo's iteration (Jacobi's, on a quaternion): of a body that has the same moment about several axes it
//! finds the same ones.

use crate::geometry::{Rotation, Vector, of_unit_quaternion, symmetric};

/// What is left as it is, of the largest entry: products of inertia, and differences of moments that have the wrong order.
const SMALL: f64 = 1e-17;
const SAME: f64 = 1e-12;
const MOST_STEPS: usize = 500;
/// Sine and cosine of the half of a right angle.
const EIGHTH: f64 = std::f64::consts::FRAC_1_SQRT_2;

type Quaternion = [f64; 4];

/// Moments, the largest first, and axes of a symmetric matrix xx, yy, zz, xy, xz, yz; the rows of the rotation are the axes.
pub(super) fn axes(tensor: [f64; 6]) -> (Vector, Rotation) {
    let matrix = symmetric(tensor);
    let mut quaternion = [1.0, 0.0, 0.0, 0.0];
    let mut moments = [0, 1, 2].map(|i| tensor[i]);
    let largest = moments
        .iter()
        .fold(0.0_f64, |most, entry| entry.abs().max(most));
    for _ in 0..MOST_STEPS {
        let seen = seen(&matrix, &of_unit_quaternion(quaternion));
        moments = [seen[0][0], seen[1][1], seen[2][2]];
        let [xy, xz, yz] = [seen[0][1], seen[0][2], seen[1][2]].map(f64::abs);
        let (row, column, axis) = if xy > xz && xy > yz {
            (0, 1, 2)
        } else if xz > yz {
            (0, 2, 1)
        } else {
            (1, 2, 0)
        };
        let product = seen[row][column];
        if product.abs() <= SMALL * largest {
            break;
        }
        let tau = (seen[column][column] - seen[row][row]) / (2.0 * product);
        let root = (1.0 + tau * tau).sqrt();
        let tangent = if tau >= 0.0 {
            1.0 / (tau + root)
        } else {
            -1.0 / (root - tau)
        };
        let cosine = 1.0 / (1.0 + tangent * tangent).sqrt();
        // The sine of half the angle, without the loss of `1 - cosine`.
        let half = tangent.abs() * cosine / (2.0 * (1.0 + cosine)).sqrt();
        // About y the second axis turns to the first.
        let half = if (tau >= 0.0) == (axis == 1) {
            half
        } else {
            -half
        };
        let mut step = [(1.0 - half * half).sqrt(), 0.0, 0.0, 0.0];
        step[axis + 1] = half;
        quaternion = unit(product_of(quaternion, unit(step)));
    }
    for lead in [0, 1, 0] {
        if moments[lead] + SAME * largest < moments[lead + 1] {
            moments.swap(lead, lead + 1);
            let mut step = [EIGHTH, 0.0, 0.0, 0.0];
            step[(lead + 2) % 3 + 1] = EIGHTH;
            quaternion = unit(product_of(quaternion, step));
        }
    }
    (moments, of_unit_quaternion(quaternion))
}

/// The matrix in turned axes.
fn seen(matrix: &[[f64; 3]; 3], axes: &Rotation) -> [[f64; 3]; 3] {
    let half = axes.map(|axis| {
        [0, 1, 2].map(|j| axis[0] * matrix[0][j] + axis[1] * matrix[1][j] + axis[2] * matrix[2][j])
    });
    half.map(|row| axes.map(|axis| row[0] * axis[0] + row[1] * axis[1] + row[2] * axis[2]))
}

fn product_of(a: Quaternion, b: Quaternion) -> Quaternion {
    [
        a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
        a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
        a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
        a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0],
    ]
}

fn unit(a: Quaternion) -> Quaternion {
    let length = (a[0] * a[0] + a[1] * a[1] + a[2] * a[2] + a[3] * a[3]).sqrt();
    a.map(|entry| entry / length)
}
