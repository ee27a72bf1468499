//! `geom`: the mass that a shape adds to its body.

use crate::description::mjcf::attributes::Attributes;
use crate::description::mjcf::orientation::{placement, z_axis};
use crate::description::mjcf::placement::Placement;
use crate::description::mjcf::segment::Segment;
use crate::description::mjcf::settings::{Settings, TRUTH};
use crate::description::mjcf::solid::{Amount, Primitive, Solid};
use crate::description::xml::Reader;
use crate::diagnostic::{Diagnostic, Spanned};
use crate::geometry::{IDENTITY, length};

/// Density where a geom says nothing, kg/m³.
const WATER: f64 = 1000.0;

/// What a geom is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum GeomType {
    Sphere,
    Capsule,
    Cylinder,
    Ellipsoid,
    Box,
    /// A plane or a height field: without mass.
    Surface,
    /// A mesh or a signed distance field: its shape stands in another file.
    Mesh,
}

const TYPES: [(&str, GeomType); 9] = [
    ("sphere", GeomType::Sphere),
    ("capsule", GeomType::Capsule),
    ("cylinder", GeomType::Cylinder),
    ("ellipsoid", GeomType::Ellipsoid),
    ("box", GeomType::Box),
    ("plane", GeomType::Surface),
    ("hfield", GeomType::Surface),
    ("mesh", GeomType::Mesh),
    ("sdf", GeomType::Mesh),
];

/// Whether it matters what mass a geom has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Moves {
    Yes,
    /// Its body is at rest.
    No,
}

/// The mass of a geom; `None` where it has none, or where it is faulty.
pub(super) fn solid(
    reader: &mut Reader,
    geom: &Attributes<'_>,
    settings: &Settings,
    around: &Placement,
    moves: Moves,
) -> Option<Solid> {
    let group = geom
        .number(reader, "group")
        .map_or(0.0, |group| group.value);
    if group < settings.groups[0] || group > settings.groups[1] {
        return None;
    }
    let kind = match geom.keyword(reader, "type", &TYPES) {
        Some(kind) => kind.value,
        // One that cannot be read is told already, and whatever is meant leads from one point to another.
        None if geom.has("type") && geom.has("fromto") => GeomType::Capsule,
        None => GeomType::Sphere,
    };
    let amount = amount(reader, geom);
    if kind == GeomType::Surface || matches!(amount, Amount::Mass(0.0) | Amount::Density(0.0)) {
        return None;
    }
    if kind == GeomType::Mesh || geom.has("mesh") {
        reader.faults.push(mesh(geom, moves));
        return None;
    }
    if let Some(shell) = geom.keyword(reader, "shellinertia", &TRUTH)
        && shell.value == TRUTH[0].1
    {
        let message = format!(
            "{} is `true`; the inertia of a shell is not supported",
            geom.what("shellinertia")
        );
        let fault = Diagnostic::error(message).at(shell.span, "not supported");
        reader
            .faults
            .push(fault.help("give the body an `inertial`"));
    }
    let (placement, half) = span_of(reader, geom, settings, kind)?;
    let shape = shape(reader, geom, kind, half)?;
    Some(shape.solid(amount, &around.then(&placement)))
}

fn amount(reader: &mut Reader, geom: &Attributes<'_>) -> Amount {
    for name in ["mass", "density"] {
        let value = geom.number(reader, name);
        if let Some(value) = value.filter(|value| value.value < 0.0) {
            let message = format!(
                "{} is {}; expected no less than 0",
                geom.what(name),
                value.value
            );
            let fault = Diagnostic::error(message).at(value.span, "negative");
            reader.faults.push(fault);
            // What would follow from it is no news.
            return Amount::Mass(0.0);
        }
        match value {
            Some(mass) if name == "mass" => return Amount::Mass(mass.value),
            Some(density) => return Amount::Density(density.value),
            None => {}
        }
    }
    Amount::Density(WATER)
}

fn mesh(geom: &Attributes<'_>, moves: Moves) -> Diagnostic {
    let owner = &geom.owner;
    let place = ["mesh", "type"].into_iter().find(|name| geom.has(name));
    let place = place.map_or(geom.span, |name| geom.place(name));
    let message = format!("the mass of {owner} follows from a mesh, which is not read");
    match moves {
        Moves::Yes => Diagnostic::error(message)
            .at(place, "not supported")
            .help("give the body an `inertial`, or the geom `mass=\"0\"`"),
        Moves::No => Diagnostic::warning(format!("{message}; its body does not move"))
            .at(place, "taken without mass")
            .one_of(
                "meshes of bodies that do not move are taken without mass",
                &**owner,
            ),
    }
}

/// Where a geom stands, and half its length where it leads from one point to another.
fn span_of(
    reader: &mut Reader,
    geom: &Attributes<'_>,
    settings: &Settings,
    kind: GeomType,
) -> Option<(Placement, Option<f64>)> {
    if !geom.has("fromto") {
        return Some((placement(reader, geom, settings), None));
    }
    let segment = Segment::read(reader, geom, kind == GeomType::Sphere)?;
    let along = segment.along();
    let rotation = z_axis(along)?;
    let placement = Placement {
        position: segment.center(),
        // The first two axes do not matter: the shapes are the same about the third.
        rotation: if along[0] == 0.0 && along[1] == 0.0 {
            IDENTITY
        } else {
            rotation
        },
    };
    Some((placement, Some(length(along) / 2.0)))
}

/// The shape with its sizes; `half` is half its length where that is known already.
fn shape(
    reader: &mut Reader,
    geom: &Attributes<'_>,
    kind: GeomType,
    half: Option<f64>,
) -> Option<Primitive> {
    let needed = match kind {
        GeomType::Sphere => 1,
        _ if half.is_some() => 1,
        GeomType::Capsule | GeomType::Cylinder => 2,
        _ => 3,
    };
    let sizes = if geom.has("size") {
        geom.up_to(reader, "size", 3)?
    } else {
        Vec::new()
    };
    let name = TYPES.iter().find(|(_, known)| *known == kind);
    let name = name.map_or("geom", |(name, _)| name);
    if sizes.len() < needed {
        let message = format!(
            "{} has {} {}; a {name} needs {needed}",
            geom.what("size"),
            sizes.len(),
            if sizes.len() == 1 { "entry" } else { "entries" }
        );
        let fault = Diagnostic::error(message).at(geom.place("size"), "too few");
        reader.faults.push(fault);
        return None;
    }
    let bad = sizes.iter().take(needed).find(|size| size.value <= 0.0);
    if let Some(Spanned { value, span }) = bad {
        let message = format!(
            "{} has the entry {value}; expected more than 0",
            geom.what("size")
        );
        let fault = Diagnostic::error(message).at(*span, "not positive");
        reader.faults.push(fault);
        return None;
    }
    let size = |index: usize| sizes.get(index).map_or(0.0, |size| size.value);
    let three = match half {
        Some(half) => [size(0), size(0), half],
        None => [size(0), size(1), size(2)],
    };
    let (radius, half) = (size(0), half.unwrap_or(size(1)));
    match kind {
        GeomType::Sphere => Some(Primitive::Sphere { radius }),
        GeomType::Capsule => Some(Primitive::Capsule { radius, half }),
        GeomType::Cylinder => Some(Primitive::Cylinder { radius, half }),
        GeomType::Ellipsoid => Some(Primitive::Ellipsoid(three)),
        GeomType::Box => Some(Primitive::Box(three)),
        GeomType::Surface | GeomType::Mesh => None,
    }
}
