//! Entries of constant rotations that are near 0, 1 or -1 become exact: what rounded angles leave.

use crate::geometry::Rotation;
use crate::tree::rotations::orthonormal::nearer_to_orthonormal;

/// The rotation with its entries near 0, 1 and -1 made exact, and the largest change of any entry.
///
/// The others are then moved, by no more, until the rows are orthonormal again, or as nearly so as the exact entries
/// permit: an entry 1 beside one that the tolerance does not reach leaves rows that are longer than 1 by half its square.
pub fn snapped(rotation: &Rotation, tolerance: f64) -> (Rotation, f64) {
    let zero = rotation.map(|row| row.map(|entry| entry.abs() < tolerance || entry == 0.0));
    // An entry is one where the others of its row or column are zero: near one alone, the angle may be far from zero.
    let is_alone = |i: usize, j: usize| {
        let others = |line: [bool; 3], own: usize| (0..3).all(|k| k == own || line[k]);
        others(zero[i], j) || others([zero[0][j], zero[1][j], zero[2][j]], i)
    };
    let pin = |matrix: Rotation| -> Rotation {
        std::array::from_fn(|i| {
            std::array::from_fn(|j| match (zero[i][j], is_alone(i, j)) {
                (true, _) => 0.0,
                (false, true) => 1.0_f64.copysign(matrix[i][j]),
                (false, false) => matrix[i][j],
            })
        })
    };
    if tolerance == 0.0 || pin(*rotation) == *rotation {
        return (*rotation, 0.0);
    }
    let mut snapped = pin(*rotation);
    // In turn the nearest orthonormal matrix and the exact entries: where these leave no rotation, it ends near one.
    for _ in 0..ORTHONORMAL_STEPS {
        let next = pin(nearer_to_orthonormal(&snapped));
        if next == snapped {
            break;
        }
        snapped = next;
    }
    let change = snapped
        .iter()
        .flatten()
        .zip(rotation.iter().flatten())
        .fold(0.0, |most: f64, (new, old)| most.max((new - old).abs()));
    (snapped, change)
}

const ORTHONORMAL_STEPS: usize = 100;

/// Sine and cosine of an angle, exact where one of them is as near to zero as this.
pub fn snapped_sin_cos(angle: f64, tolerance: f64) -> (f64, f64) {
    let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
    if sine.abs() < tolerance {
        (0.0, 1.0_f64.copysign(cosine))
    } else if cosine.abs() < tolerance {
        (1.0_f64.copysign(sine), 0.0)
    } else {
        (sine, cosine)
    }
}
