//! Orientations, in the five ways that MJCF has to write them.

use crate::description::Rotation;
use crate::description::mjcf::attributes::{Attributes, ORIENTATION};
use crate::description::mjcf::placement::{
    Placement, SAME_AXES, Vector, about, cross, difference, dot, length, product, scaled, unit,
};
use crate::description::mjcf::settings::Settings;
use crate::description::xml::Reader;
use crate::diagnostic::Diagnostic;

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
            'x' => SAME_AXES[0],
            'y' => SAME_AXES[1],
            'z' => SAME_AXES[2],
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
        return SAME_AXES;
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
        return SAME_AXES;
    }
    let unit = settings.angle;
    let rotation = match name {
        "quat" => attributes.vector(reader, name).map(quaternion),
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
    rotation.flatten().unwrap_or(SAME_AXES)
}

/// From a quaternion of any length, scalar first. The division comes last: quaternions of right angles give whole numbers.
fn quaternion([w, x, y, z]: [f64; 4]) -> Option<Rotation> {
    let square = w * w + x * x + y * y + z * z;
    let rows = [
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
    ];
    (square > 1e-28 && square.is_finite())
        .then(|| rows.map(|row| row.map(|entry| entry / square + 0.0)))
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
        SAME_AXES[0]
    } else {
        [-y / sine, x / sine, 0.0]
    };
    Some(about(about_axis, [sine, z]))
}

fn euler(angles: [[f64; 2]; 3], settings: &Settings) -> Rotation {
    let turns = settings.euler.iter().zip(angles);
    turns.fold(SAME_AXES, |so_far, (letter, angle)| {
        let turn = about(letter.axis, angle);
        match letter.fixed {
            EulerFrame::Turned => product(&turn, &so_far),
            EulerFrame::Outer => product(&so_far, &turn),
        }
    })
}
