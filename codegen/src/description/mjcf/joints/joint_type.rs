//! The types of joints, and what their coordinates are measured in.

use crate::description::mjcf::model::angles::AngleUnit;
use crate::description::mjcf::model::settings::Settings;

/// What a joint leaves free.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::description::mjcf) enum JointType {
    Hinge,
    Slide,
    Ball,
    Free,
}

/// Their names.
pub(in crate::description::mjcf) const TYPES: [(&str, JointType); 4] = [
    ("hinge", JointType::Hinge),
    ("slide", JointType::Slide),
    ("ball", JointType::Ball),
    ("free", JointType::Free),
];

/// Slides have lengths where hinges have angles.
pub(in crate::description::mjcf) fn angle_unit(kind: JointType, settings: &Settings) -> AngleUnit {
    if kind == JointType::Slide {
        AngleUnit::Radian
    } else {
        settings.angle
    }
}
