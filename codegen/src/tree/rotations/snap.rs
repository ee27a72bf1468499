//! Entries of constant rotations that are near 0, 1 or -1 become exact: what rounded angles leave.

use crate::geometry::Rotation;
use crate::tree::rotations::orthonormal::{defect, nearer_to_orthonormal};

/// How far columns may be from orthonormal: rounding leaves less.
const ROUNDING: f64 = 4e-15;

const ORTHONORMAL_STEPS: usize = 100;

/// Which entries are zero.
type Zeros = [[bool; 3]; 3];

/// The rotation with its entries near 0, 1 and -1 made exact, and the largest change of any entry.
///
/// The others are then moved, by no more, until the rows are orthonormal again. Where these zeros leave no rotation, the largest of them
/// stays as it is: `cos a cos b` may be near zero where neither factor is, but only they could make it zero.
pub fn snapped(rotation: &Rotation, tolerance: f64) -> (Rotation, f64) {
    let mut zeros = rotation.map(|row| row.map(|entry| entry.abs() < tolerance || entry == 0.0));
    if tolerance == 0.0 || pinned(rotation, &zeros) == *rotation {
        return (*rotation, 0.0);
    }
    loop {
        let snapped = with_zeros(rotation, &zeros);
        if defect(&snapped) <= ROUNDING {
            let (new, old) = (snapped.as_flattened(), rotation.as_flattened());
            let changes = new.iter().zip(old).map(|(new, old)| (new - old).abs());
            return (snapped, changes.fold(0.0, f64::max));
        }
        let Some([i, j]) = largest(rotation, &zeros) else {
            return (*rotation, 0.0);
        };
        zeros[i][j] = false;
    }
}

/// With these entries zero, and one or minus one what is alone in its row or column: near one, the angle may be far from zero.
fn pinned(rotation: &Rotation, zeros: &Zeros) -> Rotation {
    let is_alone = |i: usize, j: usize| {
        let others = |line: [bool; 3], own: usize| (0..3).all(|k| k == own || line[k]);
        others(zeros[i], j) || others([zeros[0][j], zeros[1][j], zeros[2][j]], i)
    };
    std::array::from_fn(|i| {
        std::array::from_fn(|j| match (zeros[i][j], is_alone(i, j)) {
            (true, _) => 0.0,
            (false, true) => 1.0_f64.copysign(rotation[i][j]),
            (false, false) => rotation[i][j],
        })
    })
}

/// In turn the nearest orthonormal matrix and the exact entries, until nothing moves.
fn with_zeros(rotation: &Rotation, zeros: &Zeros) -> Rotation {
    let mut snapped = pinned(rotation, zeros);
    for _ in 0..ORTHONORMAL_STEPS {
        let next = pinned(&nearer_to_orthonormal(&snapped), zeros);
        if next == snapped {
            break;
        }
        snapped = next;
    }
    snapped
}

/// The largest entry that is made zero.
fn largest(rotation: &Rotation, zeros: &Zeros) -> Option<[usize; 2]> {
    let places = (0..3).flat_map(|i| (0..3).map(move |j| [i, j]));
    let changed = places.filter(|&[i, j]| zeros[i][j] && rotation[i][j] != 0.0);
    changed.max_by(|a, b| {
        let [a, b] = [a, b].map(|&[i, j]| rotation[i][j].abs());
        a.total_cmp(&b)
    })
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
