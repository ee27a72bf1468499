//! Angles in the units of a file, and sequences of rotations by them.

use crate::description::Rotation;
use crate::description::mjcf::placement::about;
use crate::geometry::{IDENTITY, Vector, then};

/// In which unit angles are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::description::mjcf) enum AngleUnit {
    Degree,
    Radian,
}

impl AngleUnit {
    /// An angle in radians.
    pub(in crate::description::mjcf) fn radians(self, angle: f64) -> f64 {
        match self {
            Self::Degree => angle.to_radians(),
            Self::Radian => angle,
        }
    }

    /// Sine and cosine; exact for whole right angles in degrees, so that their zeros are zeros.
    pub(in crate::description::mjcf) fn sine_cosine(self, angle: f64) -> [f64; 2] {
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

/// An axis of a sequence of rotations.
#[derive(Clone, Copy, Debug)]
pub(in crate::description::mjcf) struct EulerAxis {
    axis: Vector,
    /// In which axes it is given.
    frame: EulerFrame,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum EulerFrame {
    /// Those turned so far.
    Turned,
    /// Those of the outer frame.
    Outer,
}

/// One after the other about the body's x, y and z: MJCF's default.
pub(in crate::description::mjcf) const XYZ: [EulerAxis; 3] = [
    EulerAxis::turned([1.0, 0.0, 0.0]),
    EulerAxis::turned([0.0, 1.0, 0.0]),
    EulerAxis::turned([0.0, 0.0, 1.0]),
];

impl EulerAxis {
    const fn turned(axis: Vector) -> Self {
        Self {
            axis,
            frame: EulerFrame::Turned,
        }
    }

    /// The axis of one letter of `eulerseq`.
    pub(in crate::description::mjcf) fn letter(letter: char) -> Option<Self> {
        let axis = match letter.to_ascii_lowercase() {
            'x' => IDENTITY[0],
            'y' => IDENTITY[1],
            'z' => IDENTITY[2],
            _ => return None,
        };
        let frame = if letter.is_ascii_uppercase() {
            EulerFrame::Outer
        } else {
            EulerFrame::Turned
        };
        Some(Self { axis, frame })
    }
}

/// The rotations about these axes one after the other, by angles with these sines and cosines.
pub(in crate::description::mjcf) fn euler(
    axes: &[EulerAxis; 3],
    angles: [[f64; 2]; 3],
) -> Rotation {
    let turns = axes.iter().zip(angles);
    turns.fold(IDENTITY, |so_far, (letter, angle)| {
        let turn = about(letter.axis, angle);
        match letter.frame {
            EulerFrame::Turned => then(&so_far, &turn),
            EulerFrame::Outer => then(&turn, &so_far),
        }
    })
}
