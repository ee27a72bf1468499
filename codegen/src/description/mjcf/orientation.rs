//! Orientations, in the five ways that MJCF has to write them.

use crate::description::Rotation;
use crate::description::mjcf::attributes::{Attributes, ORIENTATION};
use crate::description::mjcf::placement::{Placement, about, unit};
use crate::description::mjcf::settings::Settings;
use crate::description::xml::Reader;
use crate::diagnostic::Diagnostic;
use crate::geometry::{
    IDENTITY, Vector, cross, difference, dot, length, of_quaternion, scaled, then,
};

/// In which unit angles are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum AngleUnit {
    Degree,
    Radian,
}

/// An axis of a sequence of rotations.
#[derive(Clone, Copy, Debug)]
pub(super) struct EulerAxis {
    axis: Vector,
    /// In which axes it is given.
    fixed: EulerFrame,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum EulerFrame {
    /// Those turned so far.
    Turned,
    /// Those of the outer frame.
    Outer,
}

/// One after the other about the body's x, y and z: MJCF's default.
pub(super) const XYZ: [EulerAxis; 3] = [
    EulerAxis::turned([1.0, 0.0, 0.0]),
    EulerAxis::turned([0.0, 1.0, 0.0]),
    EulerAxis::turned([0.0, 0.0, 1.0]),
];

impl EulerAxis {
    const fn turned(axis: Vector) -> Self {
        Self {
            axis,
            fixed: EulerFrame::Turned,
        }
    }

    /// The axis of one letter of `eulerseq`.
    pub(super) fn letter(letter: char) -> Option<Self> {
        let axis = match letter.to_ascii_lowercase() {
            'x' => IDENTITY[0],
            'y' => IDENTITY[1],
            'z' => IDENTITY[2],
            _ => return None,
        };
        let fixed = if letter.is_ascii_uppercase() {
            EulerFrame::Outer
        } else {
            EulerFrame::Turned
        };
        Some(Self { axis, fixed })
    }
}

impl AngleUnit {
    /// An angle in radians.
    pub(super) fn radians(self, angle: f64) -> f64 {
        match self {
            Self::Degree => angle.to_radians(),
            Self::Radian => angle,
        }
    }

    /// Sine and cosine; exact for whole right angles in degrees, so that their zeros are zeros.
    pub(super) fn sine_cosine(self, angle: f64) -> [f64; 2] {
        if self == Self::Degree && angle % 90.0 == 0.0 {
            return match (angle / 90.0).rem_euclid(4.0) {
                1.0 => [1.0, 0.0],
                2.0 => [0.0, -1.0],
                3.0 => [-1.0, 0.0],
                _ => [0.0, 1.0],
            };
        }
        // Not std's, which differ from platform to platform.
        let (sine, cosine) = libm::sincos(self.radians(angle));
        [sine, cosine]
    }
}

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
        _ => attributes
            .vector(reader, name)
            .map(|angles: Vector| Some(euler(angles.map(|a| unit.sine_cosine(a)), settings))),
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
    let y = [y1, y2, y3];
    let y = unit(difference(y, scaled(x, dot(x, y))))?;
    let z = cross(x, y).map(|entry| entry + 0.0);
    Some([x, y, z])
}

/// The least rotation that turns z into the given axis.
pub(super) fn z_axis(axis: Vector) -> Option<Rotation> {
    let [x, y, z] = unit(axis)?;
    let sine = length([x, y, 0.0]);
    // For an axis against z, MuJoCo turns about x.
    let about_axis = if sine < 1e-10 {
        IDENTITY[0]
    } else {
        [-y / sine, x / sine, 0.0]
    };
    Some(about(about_axis, [sine, z]))
}

fn euler(angles: [[f64; 2]; 3], settings: &Settings) -> Rotation {
    let turns = settings.euler.iter().zip(angles);
    turns.fold(IDENTITY, |so_far, (letter, angle)| {
        let turn = about(letter.axis, angle);
        match letter.fixed {
            EulerFrame::Turned => then(&so_far, &turn),
            EulerFrame::Outer => then(&turn, &so_far),
        }
    })
}
