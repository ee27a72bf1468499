//! What a geom can be.

/// What a geom is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::description::mjcf) enum GeomType {
    Sphere,
    Capsule,
    Cylinder,
    Ellipsoid,
    Box,
    /// A plane: without mass.
    Surface,
    HeightField,
    /// A mesh, or one that is known by the distance from it.
    Mesh,
}

/// The names of all.
pub(in crate::description::mjcf) const TYPES: [(&str, GeomType); 9] = [
    ("sphere", GeomType::Sphere),
    ("capsule", GeomType::Capsule),
    ("cylinder", GeomType::Cylinder),
    ("ellipsoid", GeomType::Ellipsoid),
    ("box", GeomType::Box),
    ("plane", GeomType::Surface),
    ("hfield", GeomType::HeightField),
    ("mesh", GeomType::Mesh),
    ("sdf", GeomType::Mesh),
];
