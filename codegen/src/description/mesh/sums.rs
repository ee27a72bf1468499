//! Sums over the faces of a mesh: surface, volume, moments. As MuJoCo, of pyramids over the faces.

use crate::description::mesh::surface::Face;
use crate::geometry::{Vector, cross, difference, dot};

/// What is smaller is none: m² of a surface, m³ of a volume.
pub(super) const LEAST: f64 = 1e-15;

/// How a face counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Weight {
    /// The volume of the pyramid, negative where the apex sees the face from behind.
    Signed,
    /// The same without its sign.
    Absolute,
    /// The area.
    Area,
}

/// A face on its own.
pub(super) struct Triangle {
    pub(super) area: f64,
    center: Vector,
    normal: Vector,
}

/// The sums about a point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sums {
    /// m³, or m² of a shell.
    pub(super) total: f64,
    /// Moments of a density of one: xx, yy, zz, xy, xz, yz.
    pub(super) inertia: [f64; 6],
}

/// Area, centre and normal of a triangle; without an area where it is too small.
pub(super) fn triangle([a, b, c]: [Vector; 3]) -> Triangle {
    let center = [0, 1, 2].map(|i| (a[i] + b[i] + c[i]) / 3.0);
    let normal = cross(difference(b, a), difference(c, a));
    let length = dot(normal, normal).sqrt();
    if length < LEAST {
        return Triangle {
            area: 0.0,
            center,
            normal,
        };
    }
    Triangle {
        area: 0.5 * length,
        center,
        normal: normal.map(|entry| entry / length),
    }
}

fn corners(points: &[Vector], face: &Face) -> [Vector; 3] {
    face.map(|number| points[number as usize])
}

/// The area of all faces, and the mean of their centres.
pub(super) fn surface(points: &[Vector], faces: &[Face]) -> (f64, Vector) {
    let (mut area, mut center) = (0.0, [0.0; 3]);
    for face in faces {
        let face = triangle(corners(points, face));
        for (sum, entry) in center.iter_mut().zip(face.center) {
            *sum += face.area * entry;
        }
        area += face.area;
    }
    if area >= LEAST {
        center = center.map(|entry| entry / area);
    }
    (area, center)
}

/// Volume (area of a shell) and mass centre of the pyramids from `apex`.
pub(super) fn center(
    points: &[Vector],
    faces: &[Face],
    apex: Vector,
    weight: Weight,
) -> (f64, Vector) {
    let (mut total, mut center) = (0.0, [0.0; 3]);
    for face in faces {
        let face = triangle(corners(points, face));
        let part = face.weight(apex, weight);
        total += part;
        for (i, sum) in center.iter_mut().enumerate() {
            *sum += part * (face.center[i] * 3.0 / 4.0 + apex[i] / 4.0);
        }
    }
    if total >= LEAST {
        center = center.map(|entry| entry / total);
    }
    (total, center)
}

/// Volume (area of a shell) and moments about `origin`, of pyramids from there.
pub(super) fn moments(points: &[Vector], faces: &[Face], origin: Vector, weight: Weight) -> Sums {
    const PAIRS: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];
    let divisor = if weight == Weight::Area { 12.0 } else { 20.0 };
    let mut total = 0.0;
    let mut products = [0.0; 6];
    for face in faces {
        let [d, e, f] = corners(points, face).map(|corner| difference(corner, origin));
        let part = triangle([d, e, f]).weight([0.0; 3], weight);
        total += part;
        for ((i, j), sum) in PAIRS.into_iter().zip(&mut products) {
            let squares = 2.0 * (d[i] * d[j] + e[i] * e[j] + f[i] * f[j]);
            let mixed =
                d[i] * e[j] + d[j] * e[i] + d[i] * f[j] + d[j] * f[i] + e[i] * f[j] + e[j] * f[i];
            *sum += part / divisor * (squares + mixed);
        }
    }
    let [xx, yy, zz, xy, xz, yz] = products;
    Sums {
        total,
        inertia: [yy + zz, xx + zz, xx + yy, -xy, -xz, -yz],
    }
}

impl Triangle {
    fn weight(&self, apex: Vector, weight: Weight) -> f64 {
        let volume = || dot(difference(self.center, apex), self.normal) * self.area / 3.0;
        match weight {
            Weight::Signed => volume(),
            Weight::Absolute => volume().abs(),
            Weight::Area => self.area,
        }
    }
}
