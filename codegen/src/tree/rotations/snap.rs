//! Entries of constant rotations that are near 0, 1 or -1 become exact: what rounded angles leave.

use crate::geometry::Rotation;
use crate::tree::rotations::orthonormal::nearer_to_orthonormal;

/// The rotation with its entries near 0, 1 and -1 made exact, and the largest change of any entry.
///
/// The others are then moved, by no more, until the rows are orthonormal again, or as nearly so as the exact entries
/// permit: an entry 1 beside one that the tolerance does not reach leaves rows that are longer than 1 by half its square.
pub(crate) fn snapped(rotation: &Rotation, tolerance: f64) -> (Rotation, f64) {
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

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_2;

    use super::*;
    use crate::geometry::{IDENTITY, body_fixed_123, then, transposed};
    use crate::tree::rotations::orthonormal::orthonormal;

    /// Right angles as files have them: with ten digits, and with four.
    const ROUNDED: [f64; 2] = [FRAC_PI_2 - 4.9e-12, FRAC_PI_2 + 3.7e-6];

    #[test]
    fn a_rounded_right_angle_becomes_exact() {
        let rounded = body_fixed_123([ROUNDED[0], 0.0, 0.3]);
        let (snapped, change) = snapped(&rounded, 1e-9);
        assert!(snapped[2] == [0.0, -1.0, 0.0] && snapped[0][1] == 0.0);
        assert!(change > 1e-12 && change < 1e-11);
    }

    #[test]
    fn what_is_snapped_is_orthonormal_again() {
        let (snapped, _) = snapped(&body_fixed_123([ROUNDED[1], 0.2, -0.7]), 1e-5);
        let back = transposed(&snapped);
        for (i, row) in then(&back, &snapped).iter().enumerate() {
            for (j, entry) in row.iter().enumerate() {
                // A few roundings of numbers below one.
                assert!((entry - IDENTITY[i][j]).abs() < 1e-15);
            }
        }
    }

    #[test]
    fn a_coarse_tolerance_snaps_no_angle_that_is_farther() {
        // Its cosine is within the tolerance of one, its sine is not of zero.
        let rotation = body_fixed_123([0.0141, 0.0, 0.0]);
        assert_eq!(snapped(&rotation, 1e-4), (rotation, 0.0));
        assert_eq!(
            snapped_sin_cos(0.0141, 1e-4),
            (libm::sin(0.0141), libm::cos(0.0141))
        );
    }

    #[test]
    fn a_rotation_of_few_digits_is_made_orthonormal() {
        let exact = body_fixed_123([0.3, -0.8, 1.2]);
        let rounded = exact.map(|row| row.map(|entry| (entry * 1e6).round() / 1e6));
        let found = orthonormal(&rounded);
        for (i, row) in then(&transposed(&found), &found).iter().enumerate() {
            for (j, entry) in row.iter().enumerate() {
                assert!((entry - IDENTITY[i][j]).abs() < 1e-15);
            }
        }
        assert_eq!(orthonormal(&exact), exact);
    }

    #[test]
    fn nothing_is_snapped_at_zero_tolerance() {
        let rounded = body_fixed_123([ROUNDED[0], 0.1, 0.3]);
        assert_eq!(snapped(&rounded, 0.0), (rounded, 0.0));
    }
}
