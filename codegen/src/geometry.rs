//! Vectors of three numbers, and constant rotations.
//!
//! A rotation has as rows the axes of the frame it leads to, in components of the frame it leads from: it maps components in
//! the latter to components in the former. Afterwards: no result holds a minus zero, and an exact factor leaves the other exact.

/// Three components.
pub type Vector = [f64; 3];

/// A rotation matrix by rows: each row is an axis of the frame that it leads to, in components of the frame that it
/// leads from.
pub type Rotation = [[f64; 3]; 3];

/// No rotation.
pub const IDENTITY: Rotation = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// The first rotation, then the second, which is given in the axes that the first leads to.
pub fn then(first: &Rotation, second: &Rotation) -> Rotation {
    let columns = transposed(first);
    second.map(|row| columns.map(|column| dot(row, column)))
}

/// The way back.
pub fn transposed(rotation: &Rotation) -> Rotation {
    [0, 1, 2].map(|i| rotation.map(|row| row[i]))
}

/// Components after the rotation of a vector given by its components before it.
pub fn apply(rotation: &Rotation, v: Vector) -> Vector {
    rotation.map(|row| dot(row, v))
}

/// `a + b`.
pub fn sum(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|i| a[i] + b[i] + 0.0)
}

/// `a - b`.
pub fn difference(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|i| a[i] - b[i] + 0.0)
}

/// `factor a`.
pub fn scaled(a: Vector, factor: f64) -> Vector {
    a.map(|entry| entry * factor + 0.0)
}

/// `a · b`.
pub fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + 0.0
}

/// `a × b`.
pub fn cross([ax, ay, az]: Vector, [bx, by, bz]: Vector) -> Vector {
    [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx]
}

/// `|a|`.
pub fn length(a: Vector) -> f64 {
    libm::sqrt(dot(a, a))
}

/// The 1-2-3 body-fixed rotation by three angles, rad, Eq. (4).
pub fn body_fixed_123(angles: Vector) -> Rotation {
    let [(s1, c1), (s2, c2), (s3, c3)] = angles.map(|angle| (libm::sin(angle), libm::cos(angle)));
    [
        [c2 * c3, c1 * s3 + s1 * s2 * c3, s1 * s3 - c1 * s2 * c3],
        [-c2 * s3, c1 * c3 - s1 * s2 * s3, s1 * c3 + c1 * s2 * s3],
        [s2, -s1 * c2, c1 * c2],
    ]
}

/// From a quaternion of any length, scalar first, that maps components after the rotation to those before it; `None` for
/// one too short. The division comes last: quaternions of right angles give whole numbers.
pub fn of_quaternion(quaternion: [f64; 4]) -> Option<Rotation> {
    let [w, x, y, z] = quaternion;
    let square = w * w + x * x + y * y + z * z;
    if square.is_infinite() && quaternion.iter().all(|part| part.is_finite()) {
        // A power of two, which rounds none of what counts: no square overflows then.
        let scale = libm::exp2(-600.0);
        return of_quaternion(quaternion.map(|part| part * scale));
    }
    (square > 1e-28 && square.is_finite())
        .then(|| of_unit_quaternion(quaternion).map(|row| row.map(|entry| entry / square + 0.0)))
}

/// The same of a quaternion of length one; of another, the rotation times the square of its length.
pub fn of_unit_quaternion([w, x, y, z]: [f64; 4]) -> Rotation {
    [
        [
            w * w + x * x - y * y - z * z,
            2.0 * (x * y + w * z),
            2.0 * (x * z - w * y),
        ],
        [
            2.0 * (x * y - w * z),
            w * w - x * x + y * y - z * z,
            2.0 * (y * z + w * x),
        ],
        [
            2.0 * (x * z + w * y),
            2.0 * (y * z - w * x),
            w * w - x * x - y * y + z * z,
        ],
    ]
}

/// The symmetric matrix of xx, yy, zz, xy, xz, yz.
pub fn symmetric([xx, yy, zz, xy, xz, yz]: [f64; 6]) -> [Vector; 3] {
    [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
}

/// The inertia tensor, xx, yy, zz, xy, xz, yz, of a unit mass at a point: what parallel axes add.
pub fn of_unit_mass([x, y, z]: Vector) -> [f64; 6] {
    [
        y * y + z * z,
        x * x + z * z,
        x * x + y * y,
        -x * y,
        -x * z,
        -y * z,
    ]
}
