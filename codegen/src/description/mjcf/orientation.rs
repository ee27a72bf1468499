//! Orientations, in the five ways that MJCF has to write them.

use crate::description::Rotation;
use crate::description::mjcf::model::angles::euler;
use crate::description::mjcf::model::attributes::{Attributes, ORIENTATION};
use crate::description::mjcf::model::settings::Settings;
use crate::description::mjcf::placement::{Placement, about, moderate, unit};
use crate::description::xml::Reader;
use crate::diagnostic::Diagnostic;
use crate::geometry::{IDENTITY, Vector, cross, difference, dot, length, of_quaternion, scaled};

/// The frame that an element places with `pos` and an orientation.
pub(super) fn placement(
    reader: &mut Reader,
    attributes: &Attributes<'_>,
    settings: &Settings,
) -> Placement {
    let position = attributes.vector(reader, "pos");
    Placement {
        position: position.unwrap_or_default(),
        rotation: rotation(reader, attributes, settings),
    }
}

/// The orientation of an element; none where it says nothing.
pub(super) fn rotation(
    reader: &mut Reader,
    attributes: &Attributes<'_>,
    settings: &Settings,
) -> Rotation {
    let given = ORIENTATION.into_iter().filter(|name| attributes.has(name));
    let mut given: Vec<&str> = given.collect();
    given.sort_by_key(|name| attributes.place(name));
    let Some(name) = given.first().copied() else {
        return IDENTITY;
    };
    if let Some(other) = given.get(1) {
        let message = format!(
            "{} has `{name}` and `{other}`; expected one orientation",
            attributes.owner
        );
        let fault = Diagnostic::error(message)
            .at(attributes.place(other), "the second one")
            .at(attributes.place(name), "the first one");
        reader.faults.push(fault);
        return IDENTITY;
    }
    let unit = settings.angle;
    let rotation = match name {
        "quat" => attributes.vector(reader, name).map(of_quaternion),
        "axisangle" => attributes
            .vector(reader, name)
            .map(|[x, y, z, angle]| Some(about(self::unit([x, y, z])?, unit.sine_cosine(angle)))),
        "xyaxes" => attributes.vector(reader, name).map(xy_axes),
        "zaxis" => attributes.vector(reader, name).map(z_axis),
        _ => attributes.vector(reader, name).map(|angles: Vector| {
            Some(euler(&settings.euler, angles.map(|a| unit.sine_cosine(a))))
        }),
    };
    // Numbers that could not be read have their own faults.
    if rotation == Some(None) {
        let message = format!("{} is no orientation", attributes.what(name));
        let label = match name {
            "quat" => "expected a quaternion that is not zero",
            "xyaxes" => "expected two axes that are not parallel",
            _ => "expected an axis that is not zero",
        };
        let fault = Diagnostic::error(message).at(attributes.place(name), label);
        reader.faults.push(fault);
    }
    rotation.flatten().unwrap_or(IDENTITY)
}

fn xy_axes([x1, x2, x3, y1, y2, y3]: [f64; 6]) -> Option<Rotation> {
    let x = unit([x1, x2, x3])?;
    let y = moderate([y1, y2, y3]);
    let y = unit(difference(y, scaled(x, dot(x, y))))?;
    let z = cross(x, y).map(|entry| entry + 0.0);
    Some([x, y, z])
}

/// The least rotation that turns z into the given axis.
pub(super) fn z_axis(axis: Vector) -> Option<Rotation> {
    let [x, y, z] = unit(axis)?;
    let sine = length([x, y, 0.0]);
    // MuJoCo 4 takes for z itself, or for the axis against it, what is so near that the square of the sine is below 1e-14.
    if sine < 1e-7 {
        return Some(about(IDENTITY[0], [0.0, 1.0_f64.copysign(z)]));
    }
    Some(about([-y / sine, x / sine, 0.0], [sine, z]))
}
