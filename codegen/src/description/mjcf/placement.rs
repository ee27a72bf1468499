//! Frames in frames.

use crate::geometry::{IDENTITY, Rotation, Vector, apply, length, sum, then, transposed};

/// Where a frame stands in another one.
#[derive(Clone, Copy, Debug)]
pub(super) struct Placement {
    /// Its origin, in components of the other, m.
    pub(super) position: Vector,
    /// From the other's axes to its own.
    pub(super) rotation: Rotation,
}

impl Placement {
    /// Both frames are the same.
    pub(super) const SAME: Self = Self {
        position: [0.0; 3],
        rotation: IDENTITY,
    };

    /// A vector of the frame, in components of the other.
    pub(super) fn vector(&self, vector: Vector) -> Vector {
        apply(&transposed(&self.rotation), vector)
    }

    /// A point of the frame, seen from the other's origin.
    pub(super) fn point(&self, point: Vector) -> Vector {
        sum(self.position, self.vector(point))
    }

    /// A frame that stands in this one, as it stands in the other.
    pub(super) fn then(&self, inner: &Self) -> Self {
        Self {
            position: self.point(inner.position),
            rotation: then(&self.rotation, &inner.rotation),
        }
    }
}

/// The rotation about a unit axis by an angle with this sine and cosine.
pub(super) fn about(axis: Vector, [sine, cosine]: [f64; 2]) -> Rotation {
    let rest = 1.0 - cosine;
    let [x, y, z] = axis;
    let rows = [
        [
            cosine + rest * x * x,
            rest * x * y + sine * z,
            rest * x * z - sine * y,
        ],
        [
            rest * x * y - sine * z,
            cosine + rest * y * y,
            rest * y * z + sine * x,
        ],
        [
            rest * x * z + sine * y,
            rest * y * z - sine * x,
            cosine + rest * z * z,
        ],
    ];
    rows.map(|row| row.map(|entry| entry + 0.0))
}

/// The vector of length one with this direction; `None` where it is too short to have one, as MuJoCo sees it.
pub(super) fn unit(a: Vector) -> Option<Vector> {
    let a = moderate(a);
    let size = length(a);
    // A length of exactly one stays as it is.
    (size > 1e-14 && size.is_finite()).then(|| a.map(|entry| entry / size + 0.0))
}

/// The vector, or one of its direction where its length is beyond a float.
pub(super) fn moderate(a: Vector) -> Vector {
    if length(a).is_finite() {
        return a;
    }
    let entries = a.into_iter();
    let largest = entries.fold(0.0, |most: f64, entry| most.max(entry.abs()));
    a.map(|entry| entry / largest)
}
