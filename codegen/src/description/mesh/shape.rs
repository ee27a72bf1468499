//! What a mesh weighs: volume, mass centre, principal axes and moments.

use crate::description::mesh::effort::Effort;
use crate::description::mesh::fault::Fault;
use crate::description::mesh::sums::{self, LEAST, Weight};
use crate::description::mesh::surface::{Face, Surface};
use crate::description::mesh::{hull, oriented, principal};
use crate::geometry::{Rotation, Vector, apply, difference};

/// What of a mesh has mass.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Filling {
    /// Its convex hull.
    Convex,
    /// What its faces enclose.
    Exact,
    /// Pyramids from the faces' centre, those behind it counted once more.
    Legacy,
    /// The faces.
    Shell,
}

/// What happens to the points of a file, in this order.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Change {
    /// Subtracted, m.
    pub(crate) origin: Vector,
    /// From the file's axes to those of the mesh.
    pub(crate) rotation: Rotation,
    /// Along the mesh's axes.
    pub(crate) scale: Vector,
}

/// What a mesh weighs.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MeshShape {
    /// m³; m² of a shell.
    pub(crate) volume: f64,
    /// The mass centre, m.
    pub(crate) center: Vector,
    /// About the mass centre, for a mass of one: xx, yy, zz, xy, xz, yz, m².
    pub(crate) inertia: [f64; 6],
    /// From the mesh's axes to the principal ones, that of the largest moment first.
    pub(crate) axes: Rotation,
    /// About the principal axes, for a mass of one, m².
    pub(crate) moments: Vector,
    /// The least and largest coordinates along the principal axes, from the mass centre, m.
    pub(crate) bounds: [Vector; 2],
}

/// What a mesh weighs, after the change. `most_corners` is how many points its hull may have.
pub(crate) fn shape(
    surface: &Surface,
    filling: Filling,
    change: &Change,
    most_corners: usize,
    effort: &mut Effort,
) -> Result<MeshShape, Fault> {
    let points: Vec<Vector> = surface.points.iter().map(|p| p.map(f64::from)).collect();
    if filling == Filling::Exact {
        oriented::check(surface, &points)?;
    }
    let hull = if filling == Filling::Convex || surface.faces.is_empty() {
        hull_of(surface, most_corners, effort)?
    } else {
        Vec::new()
    };
    let mut faces = if surface.faces.is_empty() {
        hull.clone()
    } else {
        surface.faces.clone()
    };
    let mut filled = if filling == Filling::Convex {
        hull
    } else {
        faces.clone()
    };
    let points: Vec<Vector> = points
        .into_iter()
        .map(|point| {
            let point = apply(&change.rotation, difference(point, change.origin));
            [0, 1, 2].map(|i| point[i] * change.scale[i])
        })
        .collect();
    // What was counter-clockwise is clockwise in a mirror.
    if change.scale.iter().product::<f64>() <= 0.0 {
        for face in faces.iter_mut().chain(&mut filled) {
            face.swap(1, 2);
        }
    }
    weigh(&points, &faces, &filled, filling)
}

fn hull_of(
    surface: &Surface,
    most_corners: usize,
    effort: &mut Effort,
) -> Result<Vec<Face>, Fault> {
    let hull = hull::hull(&surface.points, effort)?;
    let mut corners: Vec<u32> = hull.iter().flatten().copied().collect();
    corners.sort_unstable();
    corners.dedup();
    if corners.len() > most_corners {
        let found = format!(
            "has a convex hull of {} points, of which `maxhullvert` lets {most_corners} count; a part of a hull is not supported",
            corners.len()
        );
        return Err(
            Fault::new(found).help("leave `maxhullvert` out, or give the body an `inertial`")
        );
    }
    Ok(hull)
}

fn weigh(
    points: &[Vector],
    faces: &[Face],
    filled: &[Face],
    filling: Filling,
) -> Result<MeshShape, Fault> {
    let weight = match filling {
        Filling::Convex | Filling::Exact => Weight::Signed,
        Filling::Legacy => Weight::Absolute,
        Filling::Shell => Weight::Area,
    };
    let (area, apex) = sums::surface(points, faces);
    if area.is_nan() || area < LEAST {
        return Err(Fault::new(format!(
            "has a surface of {} m²; expected more",
            told(area)
        )));
    }
    let (volume, center) = sums::center(points, filled, apex, weight);
    if volume < 0.0 {
        let found = format!("has a volume of {} m³: its faces look inward", told(volume));
        return Err(Fault::new(found).help("turn the faces round, or write `inertia=\"convex\"`"));
    }
    if volume.is_nan() || volume < LEAST {
        let found = format!("has a volume of {} m³; expected more", told(volume));
        return Err(
            Fault::new(found).help("check the `scale`; write `inertia=\"shell\"` for a surface")
        );
    }
    let sums = sums::moments(points, filled, center, weight);
    let inertia = sums.inertia.map(|entry| entry / sums.total);
    let (moments, axes) = principal::axes(inertia);
    let [a, b, c] = moments;
    // But for rounding none is more than the two others.
    let is_real = |moment: f64| moment > 0.0 && moment <= (a + b + c) * (0.5 + 1e-7);
    if ![a, b, c].into_iter().all(is_real) {
        let found = format!(
            "has principal moments {}, {} and {} m² for a mass of one, which no body has",
            told(a),
            told(b),
            told(c)
        );
        return Err(Fault::new(found).help("close the surface, or write `inertia=\"convex\"`"));
    }
    Ok(MeshShape {
        volume: sums.total,
        center,
        inertia,
        axes,
        moments,
        bounds: bounds(points, center, &axes),
    })
}

/// A number to read: that it is zero, or how large about.
fn told(number: f64) -> String {
    if number == 0.0 {
        "0".to_owned()
    } else if (1e-2..1e4).contains(&number.abs()) {
        format!("{number:.3}")
    } else {
        format!("{number:.2e}")
    }
}

/// The least and largest coordinates along these axes.
fn bounds(points: &[Vector], center: Vector, axes: &Rotation) -> [Vector; 2] {
    let mut bounds = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
    for point in points {
        let seen = apply(axes, difference(*point, center));
        for (i, entry) in seen.into_iter().enumerate() {
            bounds[0][i] = bounds[0][i].min(entry);
            bounds[1][i] = bounds[1][i].max(entry);
        }
    }
    bounds
}
