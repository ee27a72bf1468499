//! Rotations in plain numbers: what a description's frames come to, worked out without the generator.
//!
//! A matrix has as rows the axes of the frame it leads to, in components of the frame it leads from.

use crate::random::Random;

pub type Vector = [f64; 3];
pub type Rotation = [Vector; 3];

pub const IDENTITY: Rotation = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

pub fn times(matrix: &Rotation, v: Vector) -> Vector {
    matrix.map(|row| dot(row, v))
}

/// `a b`: first `b`, then `a`.
pub fn product(a: &Rotation, b: &Rotation) -> Rotation {
    let columns = transposed(b);
    a.map(|row| columns.map(|column| dot(row, column)))
}

pub fn transposed(matrix: &Rotation) -> Rotation {
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| matrix[j][i]))
}

pub fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn cross(a: Vector, b: Vector) -> Vector {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

pub fn sum(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|i| a[i] + b[i])
}

pub fn scaled(factor: f64, v: Vector) -> Vector {
    v.map(|x| factor * x)
}

pub fn unit(v: Vector) -> Vector {
    scaled(1.0 / dot(v, v).sqrt(), v)
}

/// To axes that are turned by `angle` about `axis`, a unit vector: Rodrigues, transposed.
pub fn about(axis: Vector, angle: f64) -> Rotation {
    let (sin, cos) = libm::sincos(angle);
    let columns = IDENTITY.map(|e| {
        let along = scaled((1.0 - cos) * dot(axis, e), axis);
        sum(sum(scaled(cos, e), along), scaled(-sin, cross(axis, e)))
    });
    transposed(&columns)
}

/// About x, then the new y, then the newest z.
pub fn angles_123(angles: Vector) -> Rotation {
    let [first, second, third] = [0, 1, 2].map(|i| about(IDENTITY[i], angles[i]));
    product(&third, &product(&second, &first))
}

/// Hamilton's product, scalar first.
pub fn hamilton(a: [f64; 4], b: [f64; 4]) -> [f64; 4] {
    let (v, w) = ([a[1], a[2], a[3]], [b[1], b[2], b[3]]);
    let [x, y, z] = sum(sum(scaled(a[0], w), scaled(b[0], v)), cross(v, w));
    [a[0] * b[0] - dot(v, w), x, y, z]
}

/// To axes that are turned by a unit quaternion: `e* v e`.
pub fn of_quaternion(e: [f64; 4]) -> Rotation {
    let conjugate = [e[0], -e[1], -e[2], -e[3]];
    let columns = IDENTITY.map(|v| {
        let turned = hamilton(hamilton(conjugate, [0.0, v[0], v[1], v[2]]), e);
        [turned[1], turned[2], turned[3]]
    });
    transposed(&columns)
}

/// The unit quaternion of three angles.
pub fn quaternion_of(angles: Vector) -> [f64; 4] {
    [0, 1, 2].into_iter().fold([1.0, 0.0, 0.0, 0.0], |e, axis| {
        let (sin, cos) = libm::sincos(0.5 * angles[axis]);
        let mut step = [cos, 0.0, 0.0, 0.0];
        step[1 + axis] = sin;
        hamilton(e, step)
    })
}

/// The angular velocity for a unit rate of each of three angles, turned components, by columns.
pub fn rate_columns(angles: Vector) -> [Vector; 3] {
    let [_, second, third] = [0, 1, 2].map(|i| about(IDENTITY[i], angles[i]));
    let first = times(&product(&third, &second), IDENTITY[0]);
    [first, times(&third, IDENTITY[1]), IDENTITY[2]]
}

/// Any rotation, to the last digit.
pub fn any(random: &mut Random) -> Rotation {
    loop {
        let e = [0; 4].map(|_| random.symmetric());
        let length = e.iter().map(|x| x * x).sum::<f64>().sqrt();
        if (0.1..1.0).contains(&length) {
            return of_quaternion(e.map(|x| x / length));
        }
    }
}

/// One of the 24 rotations by quarter turns.
pub fn quarters(random: &mut Random) -> Rotation {
    let first = random.below(3);
    let second = (first + 1 + random.below(2)) % 3;
    let sign = |random: &mut Random| if random.chance(0.5) { 1.0 } else { -1.0 };
    let mut rows = [[0.0; 3]; 3];
    rows[0][first] = sign(random);
    rows[1][second] = sign(random);
    // Minus zero is no number that anybody writes.
    rows[2] = cross(rows[0], rows[1]).map(|entry| entry + 0.0);
    rows
}
