//! Shapes that stand for meshes: as large as the mesh, or as a box of its inertia.

use crate::description::mesh::MeshShape;
use crate::description::mjcf::mass::geom_type::GeomType;
use crate::description::mjcf::mass::solid::Primitive;
use crate::description::mjcf::placement::Placement;
use crate::geometry::{Vector, apply, sum, transposed};

/// A shape fitted to a mesh, `scale` times as large, and where it stands in the mesh's frame; `None` for a shape that none can
/// have: a plane, or one without a size.
pub(in crate::description::mjcf) fn fitted(
    kind: GeomType,
    mesh: &MeshShape,
    to_bounds: bool,
    scale: f64,
) -> Option<(Primitive, Placement)> {
    let (size, center) = if to_bounds {
        let [low, high] = mesh.bounds;
        let middle: Vector = [0, 1, 2].map(|i| f64::midpoint(low[i], high[i]));
        let half: Vector = [0, 1, 2].map(|i| high[i] - middle[i]);
        let offset = apply(&transposed(&mesh.axes), middle);
        (bounding(kind, half), sum(mesh.center, offset))
    } else {
        (alike(kind, inertia_box(mesh.moments)), mesh.center)
    };
    let [a, b, c] = size.map(|entry| entry * scale);
    let shape = match kind {
        GeomType::Sphere => Primitive::Sphere { radius: a },
        GeomType::Capsule => Primitive::Capsule { radius: a, half: b },
        GeomType::Cylinder => Primitive::Cylinder { radius: a, half: b },
        GeomType::Ellipsoid => Primitive::Ellipsoid([a, b, c]),
        GeomType::Box => Primitive::Box([a, b, c]),
        GeomType::Surface | GeomType::HeightField | GeomType::Mesh => return None,
    };
    let needed = match kind {
        GeomType::Sphere => 1,
        GeomType::Capsule | GeomType::Cylinder => 2,
        _ => 3,
    };
    let placement = Placement {
        position: center,
        rotation: mesh.axes,
    };
    let has_size = [a, b, c].iter().take(needed).all(|entry| *entry > 0.0);
    has_size.then_some((shape, placement))
}

/// Half the sides of the box with these moments for a mass of one, m.
fn inertia_box([a, b, c]: Vector) -> Vector {
    let half = |rest: f64| 0.5 * (6.0 * rest).sqrt();
    [half(b + c - a), half(a + c - b), half(a + b - c)]
}

/// The sizes of a shape with nearly the inertia of a box.
fn alike(kind: GeomType, half: Vector) -> Vector {
    let [x, y, z] = half;
    match kind {
        GeomType::Sphere => [(x + y + z) / 3.0, 0.0, 0.0],
        GeomType::Capsule => {
            let radius = f64::midpoint(x, y);
            [radius, (z - radius / 2.0).max(0.0), 0.0]
        }
        GeomType::Cylinder => [f64::midpoint(x, y), z, 0.0],
        _ => half,
    }
}

/// The sizes of a shape that is as wide as a box.
fn bounding(kind: GeomType, half: Vector) -> Vector {
    let [x, y, z] = half;
    match kind {
        GeomType::Sphere => [x.max(y).max(z), 0.0, 0.0],
        GeomType::Capsule => [x.max(y), z - x.max(y), 0.0],
        GeomType::Cylinder => [x.max(y), z, 0.0],
        _ => half,
    }
}
