//! What becomes of constant rotations: the frame of an axis, and the snapping of what rounded angles leave.

use crate::geometry::{IDENTITY, Rotation, Vector, cross, dot, length, transposed};

/// A rotation to axes of which the one at the returned place is `axis` (of any length): as few of them as possible
/// are turned. About a coordinate axis, or its opposite, that place is its own. Last comes by how much snapping changed an
/// entry of the axis.
pub(crate) fn toward(axis: Vector, tolerance: f64) -> (Rotation, usize, f64) {
    let largest = axis
        .iter()
        .fold(0.0, |most: f64, part| most.max(part.abs()));
    // Scaled first, so that no square overflows or vanishes.
    let scaled = axis.map(|part| part / largest);
    let size = length(scaled);
    let given = scaled.map(|part| part / size);
    let unit = snapped_unit(given, tolerance);
    let change = (0..3).fold(0.0, |most: f64, i| most.max((unit[i] - given[i]).abs()));
    if let Some(place) = unit.iter().position(|part| part.abs() == 1.0) {
        let mut turned = IDENTITY;
        if unit[place] < 0.0 {
            // Half a turn about the next axis.
            turned[place][place] = -1.0;
            turned[(place + 2) % 3][(place + 2) % 3] = -1.0;
        }
        return (turned, place, change);
    }
    // The other two: normal to the axis and to the coordinate axis along which it has least, and normal to both.
    let least = (0..3).fold(0, |least, i| {
        if unit[i].abs() < unit[least].abs() {
            i
        } else {
            least
        }
    });
    let mut along = [0.0; 3];
    along[least] = 1.0;
    let first = cross(along, unit);
    let size = length(first);
    let first = first.map(|part| part / size);
    ([first, cross(unit, first), unit], 2, change)
}

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

/// The nearest orthonormal matrix of one that is not, by more than rounding: rotations may be written with few digits.
pub(crate) fn orthonormal(rotation: &Rotation) -> Rotation {
    let columns = transposed(rotation);
    let gram = columns.map(|a| columns.map(|b| dot(a, b)));
    let entries = gram.iter().flatten().zip(IDENTITY.iter().flatten());
    let defect = entries.fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
    if defect < 1e-14 {
        return *rotation;
    }
    // What is off by 1e-6 is off by 1e-12 after one step, and by rounding after two.
    nearer_to_orthonormal(&nearer_to_orthonormal(rotation))
}

/// `R (3 - R^T R) / 2`: a step of Newton's iteration for the nearest orthonormal matrix.
fn nearer_to_orthonormal(rotation: &Rotation) -> Rotation {
    let columns = transposed(rotation);
    let gram = columns.map(|a| columns.map(|b| dot(a, b)));
    rotation.map(|row| {
        std::array::from_fn(|j| {
            1.5 * row[j] - 0.5 * (0..3).map(|k| row[k] * gram[k][j]).sum::<f64>()
        })
    })
}

/// A unit vector with its entries near zero made exact.
fn snapped_unit(unit: Vector, tolerance: f64) -> Vector {
    let pinned = unit.map(|part| if part.abs() < tolerance { 0.0 } else { part });
    if pinned == unit {
        return unit;
    }
    let size = length(pinned);
    pinned.map(|part| part / size)
}

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
    use crate::geometry::{body_fixed_123, then};

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
    fn an_axis_that_leans_keeps_its_lean() {
        // Its first entry is within 1e-9 of one, its second is not of zero.
        let (frame, place, change) = toward([1.0, 4e-5, 0.0], 1e-9);
        assert!((frame[place][1] - 4e-5).abs() < 1e-12 && change == 0.0);
        let (frame, place, change) = toward([1.0, 4e-10, 0.0], 1e-9);
        assert!(frame[place] == [1.0, 0.0, 0.0] && change == 4e-10);
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

    #[test]
    fn the_frame_of_an_axis_is_right_handed_and_has_it() {
        for axis in [
            [0.0, 0.0, -2.0],
            [0.0, -1.0, 0.0],
            [-1.0, 0.0, 0.0],
            [0.3, -0.4, 0.5],
            [1e200, 1e200, 0.0],
        ] {
            let (frame, place, _) = toward(axis, 1e-9);
            let largest = axis
                .iter()
                .fold(0.0, |most: f64, part: &f64| most.max(part.abs()));
            let scaled = axis.map(|part| part / largest);
            let size = length(scaled);
            for (entry, part) in frame[place].iter().zip(scaled) {
                assert!((entry - part / size).abs() < 1e-15);
            }
            let third = cross(frame[0], frame[1]);
            for (entry, part) in frame[2].iter().zip(third) {
                assert!((entry - part).abs() < 1e-15);
            }
        }
    }
}
