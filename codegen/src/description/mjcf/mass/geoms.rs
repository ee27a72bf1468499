//! `geom`: the mass that a shape adds to its body.

use std::ops::Range;

use crate::description::mjcf::contents::Inside;
use crate::description::mjcf::mass::fit::fitted;
use crate::description::mjcf::mass::geom_type::{GeomType, TYPES};
use crate::description::mjcf::mass::segment::Segment;
use crate::description::mjcf::mass::solid::{Amount, Primitive, Solid, uniform};
use crate::description::mjcf::model::Model;
use crate::description::mjcf::model::attributes::Attributes;
use crate::description::mjcf::model::defaults::ElementKind;
use crate::description::mjcf::model::models::Models;
use crate::description::mjcf::model::settings::{Settings, Switch, TRUTH};
use crate::description::mjcf::orientation::{placement, z_axis};
use crate::description::mjcf::placement::Placement;
use crate::description::xml::Reader;
use crate::diagnostic::{Diagnostic, Span, Spanned};
use crate::geometry::{IDENTITY, Vector, length};

/// Density where a geom says nothing, kg/m³.
const WATER: f64 = 1000.0;

/// Volume from which on MuJoCo lets a geom have the mass that it is given, m³ (m² of a shell).
const LEAST: f64 = 1e-14;

/// What moves and has such a volume may be in millimetres, m³: the largest ships have less, and ten metres a side in millimetres are most.
const HUGE: Range<f64> = 2e6..1e12;

/// And such a mass, kg: what is lighter has a density of its own.
const HEAVY: f64 = 1e6;

/// What counts for a body.
#[derive(Clone, Copy, Debug)]
pub(in crate::description::mjcf) struct Counted {
    /// Whether the body moves.
    pub(in crate::description::mjcf) moves: bool,
    /// Whether it matters what mass a geom has.
    pub(in crate::description::mjcf) mass_matters: bool,
    /// The first and the last group of geoms.
    pub(in crate::description::mjcf) groups: [f64; 2],
}

/// The attributes of a geom of `body`, with warnings of those that are not known.
pub(in crate::description::mjcf) fn attributes<'d>(
    reader: &mut Reader,
    models: &Models<'d>,
    geom: &Inside<'d>,
    body: &str,
) -> Attributes<'d> {
    let owner = geom.owner("geom", body);
    let model = &models.list[geom.around.model];
    for child in model.files.children(geom.element) {
        if child.name() != "plugin" {
            reader.unknown_child(child, &owner, &[]);
        }
    }
    let class = geom.around.class;
    let defaults = &model.defaults;
    defaults.attributes(reader, geom.element, &owner, ElementKind::Geom, class)
}

/// The mass of a geom; `None` where it has none, or where it is faulty.
pub(in crate::description::mjcf) fn solid(
    reader: &mut Reader,
    geom: &Attributes<'_>,
    model: &Model<'_>,
    around: &Placement,
    Counted {
        moves,
        mass_matters,
        groups,
    }: Counted,
) -> Option<Solid> {
    let settings = &model.settings;
    let group = geom
        .number(reader, "group")
        .map_or(0.0, |group| group.value);
    if group < groups[0] || group > groups[1] {
        return None;
    }
    let kind = match geom.keyword(reader, "type", &TYPES) {
        Some(kind) => kind.value,
        // One that cannot be read is told already, and whatever is meant leads from one point to another.
        None if geom.has("type") && geom.has("fromto") => GeomType::Capsule,
        None => GeomType::Sphere,
    };
    let amount = amount(reader, geom);
    if kind == GeomType::Surface && moves {
        reader.faults.push(moving_plane(geom));
        return None;
    }
    if kind == GeomType::Surface || matches!(amount, Amount::Mass(0.0) | Amount::Density(0.0)) {
        return None;
    }
    if kind == GeomType::HeightField {
        if mass_matters {
            reader.faults.push(height_field(geom));
        }
        return None;
    }
    let has_own_mass = moves && settings.total_mass.is_none();
    let is_of_mesh = kind == GeomType::Mesh || geom.has("mesh");
    if is_of_mesh && !mass_matters {
        reader.faults.push(at_rest(geom));
        return None;
    }
    refuse_shell(reader, geom, kind);
    if is_of_mesh {
        let solid = of_mesh(reader, geom, model, around, kind, amount)?;
        if let (true, Amount::Density(density)) = (has_own_mass, amount) {
            warn_of_huge(reader, geom, amount, solid.mass / density);
        }
        return Some(solid);
    }
    let (placement, half) = span_of(reader, geom, settings, kind)?;
    let shape = shape(reader, geom, kind, half)?;
    if is_too_small(reader, geom, amount, shape.volume()) {
        return None;
    }
    if has_own_mass {
        warn_of_huge(reader, geom, amount, shape.volume());
    }
    Some(shape.solid(amount, &around.then(&placement)))
}

fn amount(reader: &mut Reader, geom: &Attributes<'_>) -> Amount {
    for name in ["mass", "density"] {
        let value = geom.number(reader, name);
        if let Some(value) = value.filter(|value| value.value < 0.0) {
            let message = format!(
                "{} is {:?}; expected no less than 0",
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

/// The warning of a geom whose mass follows from a mesh and does not matter.
fn at_rest(geom: &Attributes<'_>) -> Diagnostic {
    let owner = &geom.owner;
    let message = format!(
        "the mass of {owner} follows from a mesh, which is not read; its body does not move"
    );
    let warning = Diagnostic::warning(message).at(mesh_place(geom), "taken without mass");
    warning.one_of(
        "geoms of bodies at rest whose meshes are not read",
        &**owner,
    )
}

/// True where a geom is given a mass that MuJoCo does not let it have, with a warning.
fn is_too_small(reader: &mut Reader, geom: &Attributes<'_>, amount: Amount, volume: f64) -> bool {
    let is_too_small = matches!(amount, Amount::Mass(_)) && volume <= LEAST;
    if is_too_small {
        let message = format!(
            "{} has a volume of {volume:.2e} m³; as in MuJoCo it gets no mass with less than {LEAST:e}",
            geom.owner
        );
        let warning = Diagnostic::warning(message).at(geom.place("mass"), "taken without mass");
        let help = "check the size, or the `scale` of the mesh, or give the body an `inertial`";
        let warning = warning.help(help);
        let kind = "geoms that are too small for a mass";
        reader.faults.push(warning.one_of(kind, &*geom.owner));
    }
    is_too_small
}

/// Warns where a mass follows from sizes that look like millimetres; where it is given, the inertia is looked at later.
fn warn_of_huge(reader: &mut Reader, geom: &Attributes<'_>, amount: Amount, volume: f64) {
    let Amount::Density(density) = amount else {
        return;
    };
    let mass = density * volume;
    if !HUGE.contains(&volume) || mass < HEAVY {
        return;
    }
    let message = format!(
        "{} has a volume of {volume:.0e} m³, and by its density a mass of {mass:.0e} kg; is it in millimetres?",
        geom.owner
    );
    let place = ["size", "mesh"].into_iter().find(|name| geom.has(name));
    let place = place.map_or(geom.span, |name| geom.place(name));
    let warning = Diagnostic::warning(message).at(place, "expected metres");
    let kind = "geoms look as if they were in millimetres";
    reader.faults.push(warning.one_of(kind, &*geom.owner));
}

fn moving_plane(geom: &Attributes<'_>) -> Diagnostic {
    let message = format!(
        "{} is a plane on a body that moves, as MuJoCo lets none",
        geom.owner
    );
    let fault = Diagnostic::error(message).at(geom.place("type"), "on a body that moves");
    fault.help("move it to the world, or leave it out")
}

fn height_field(geom: &Attributes<'_>) -> Diagnostic {
    let message = format!(
        "{} is a height field, whose mass is not computed",
        geom.owner
    );
    let fault = Diagnostic::error(message).at(geom.place("type"), "on a body that moves");
    fault.help("give the geom `mass=\"0\"`, or the body an `inertial`")
}

fn mesh_place(geom: &Attributes<'_>) -> Span {
    let place = ["mesh", "type"].into_iter().find(|name| geom.has(name));
    place.map_or(geom.span, |name| geom.place(name))
}

fn refuse_shell(reader: &mut Reader, geom: &Attributes<'_>, kind: GeomType) {
    let shell = geom.keyword(reader, "shellinertia", &TRUTH);
    let Some(shell) = shell.filter(|shell| shell.value == Switch::On) else {
        return;
    };
    let message = format!(
        "{} is `true`; the inertia of a shell is not supported",
        geom.what("shellinertia")
    );
    let fault = Diagnostic::error(message).at(shell.span, "not supported");
    reader.faults.push(fault.help(if kind == GeomType::Mesh {
        "write `inertia=\"shell\"` at the mesh"
    } else {
        "give the body an `inertial`"
    }));
}

/// The mass of a geom that is a mesh, or a shape that stands for one.
fn of_mesh(
    reader: &mut Reader,
    geom: &Attributes<'_>,
    model: &Model<'_>,
    around: &Placement,
    kind: GeomType,
    amount: Amount,
) -> Option<Solid> {
    let settings = &model.settings;
    if geom.has("fromto") {
        let message = format!("{} has `fromto` beside a mesh", geom.owner);
        let fault = Diagnostic::error(message).at(geom.place("fromto"), "expected `pos`");
        reader.faults.push(fault);
        return None;
    }
    let own = placement(reader, geom, settings);
    let mesh = model.meshes.shape(reader, geom, settings)?;
    let place = around.then(&own);
    if kind == GeomType::Mesh {
        let frame = Placement {
            position: mesh.center,
            rotation: IDENTITY,
        };
        if is_too_small(reader, geom, amount, mesh.volume) {
            return None;
        }
        return Some(uniform(
            mesh.volume,
            mesh.inertia,
            amount,
            &place.then(&frame),
        ));
    }
    let scale = geom
        .number(reader, "fitscale")
        .map_or(1.0, |scale| scale.value);
    let to_bounds = settings.fit_bounds == Switch::On;
    let Some((shape, frame)) = fitted(kind, &mesh, to_bounds, scale) else {
        let message = format!(
            "{} has no size where it is fitted to its mesh; expected more than 0",
            geom.owner
        );
        let fault = Diagnostic::error(message).at(mesh_place(geom), "fitted to this mesh");
        reader.faults.push(fault.help("choose another `type`"));
        return None;
    };
    if is_too_small(reader, geom, amount, shape.volume()) {
        return None;
    }
    Some(shape.solid(amount, &place.then(&frame)))
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
    let position: Option<Vector> = geom.vector(reader, "pos");
    if position.is_some_and(|position| position != [0.0; 3]) {
        let message = format!("{} has both `pos` and `fromto`", geom.owner);
        let fault = Diagnostic::error(message)
            .at(geom.place("pos"), "expected one of them")
            .at(geom.place("fromto"), "the other one");
        reader.faults.push(fault);
        return None;
    }
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
        GeomType::Surface | GeomType::HeightField | GeomType::Mesh => None,
    }
}
