//! Frames and vectors as numbers.
//!
//! A rotation has the axes of the frame that it leads to as rows, in components of the frame that it leads from: the
//! transpose of MuJoCo's matrix.

use crate::description::Rotation;

/// Three components.
pub(super) type Vector = [f64; 3];

/// No rotation.
pub(super) const SAME_AXES: Rotation = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

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
        rotation: SAME_AXES,
    };

    /// A vector of the frame, in components of the other.
    pub(super) fn vector(&self, vector: Vector) -> Vector {
        let [x, y, z] = self.rotation;
        // No minus zero.
        [0, 1, 2].map(|i| x[i] * vector[0] + y[i] * vector[1] + z[i] * vector[2] + 0.0)
    }

    /// A point of the frame, seen from the other's origin.
    pub(super) fn point(&self, point: Vector) -> Vector {
        sum(self.position, self.vector(point))
    }

    /// A frame that stands in this one, as it stands in the other.
    pub(super) fn then(&self, inner: &Self) -> Self {
        Self {
            position: self.point(inner.position),
            rotation: product(&inner.rotation, &self.rotation),
        }
    }
}

/// The rotation `first`, then `second`, which is given in the axes that `first` leads to.
pub(super) fn product(second: &Rotation, first: &Rotation) -> Rotation {
    second.map(|row| {
        [0, 1, 2].map(|i| row[0] * first[0][i] + row[1] * first[1][i] + row[2] * first[2][i] + 0.0)
    })
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

pub(super) fn sum(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|i| a[i] + b[i] + 0.0)
}

pub(super) fn difference(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|i| a[i] - b[i] + 0.0)
}

pub(super) fn scaled(a: Vector, factor: f64) -> Vector {
    a.map(|entry| entry * factor + 0.0)
}

pub(super) fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn cross(a: Vector, b: Vector) -> Vector {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

pub(super) fn length(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

/// The vector of length one with this direction; `None` where it is too short to have one, as MuJoCo sees it.
pub(super) fn unit(a: Vector) -> Option<Vector> {
    let length = length(a);
    // A length of exactly one stays as it is.
    (length > 1e-14 && length.is_finite()).then(|| a.map(|entry| entry / length + 0.0))
}
