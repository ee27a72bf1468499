//! Where coordinates and speeds of joints stand, and frames that are fixed in bodies.

use crate::{
    id::BodyId,
    tree::{self, CoordinateKind, Orientation},
};

/// A body's joint.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Joint {
    /// Its name, as the user wrote it.
    pub name: String,
    /// How its orientation is told.
    pub chart: JointChart,
    /// The places in `q` of theta1, theta2, theta3 or e0, e1, e2, e3, then s1, s2, s3; none for what is locked.
    pub q: [Option<usize>; 7],
    /// The places in `u` of the speeds of the three rotations and the three translations.
    pub u: [Option<usize>; 6],
}

/// How an orientation is told.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum JointChart {
    /// Angles, with their rates for speeds.
    AngleRates,
    /// Angles, with components of the angular velocity for speeds.
    Angles,
    /// A unit quaternion, with components of the angular velocity for speeds.
    EulerParameters,
}

/// A frame of the model that is part of a body.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// Its name, as the user wrote it.
    pub name: String,
    /// The body, by its place; `None` is the inertial frame.
    pub body: Option<usize>,
    /// From the body's axes to the frame's.
    pub rotation: [[f64; 3]; 3],
    /// From the body's origin to the frame's, the body's axes, m.
    pub position: [f64; 3],
}

impl JointChart {
    /// What stands at a place of [`Joint::q`]; of angles there is none at the fourth.
    pub(crate) fn coordinate(self, place: usize) -> Option<CoordinateKind> {
        match (place, self) {
            (4.., _) => Some(CoordinateKind::Translation(place - 4)),
            (_, Self::EulerParameters) => Some(CoordinateKind::EulerParameter(place)),
            (3, Self::AngleRates | Self::Angles) => None,
            (_, Self::AngleRates | Self::Angles) => Some(CoordinateKind::Angle(place)),
        }
    }

    /// The chart of this name, which is that of the variant.
    pub(crate) fn named(name: &str) -> Option<Self> {
        let mut all = [Self::AngleRates, Self::Angles, Self::EulerParameters].into_iter();
        all.find(|chart| chart.name() == name)
    }

    /// Its name.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::AngleRates => "AngleRates",
            Self::Angles => "Angles",
            Self::EulerParameters => "EulerParameters",
        }
    }
}

impl Joint {
    pub(super) fn of(joint: &tree::Joint) -> Self {
        let chart = match joint.orientation {
            Orientation::Rates(_) => JointChart::AngleRates,
            Orientation::AngularVelocity {
                chart: tree::ChartCoordinates::Angles(_),
                ..
            } => JointChart::Angles,
            Orientation::AngularVelocity {
                chart: tree::ChartCoordinates::EulerParameters(_),
                ..
            } => JointChart::EulerParameters,
        };
        let mut q = [None; 7];
        for (kind, coordinate) in joint.coordinates() {
            let place = match kind {
                CoordinateKind::Angle(i) | CoordinateKind::EulerParameter(i) => i,
                CoordinateKind::Translation(i) => 4 + i,
            };
            q[place] = Some(coordinate.index());
        }
        let mut u = [None; 6];
        for (motion, speed) in joint.speeds() {
            u[motion] = Some(speed.index());
        }
        Self {
            name: joint.name.clone(),
            chart,
            q,
            u,
        }
    }
}

impl Frame {
    pub(super) fn of(frame: &tree::Frame) -> Self {
        Self {
            name: frame.name.clone(),
            body: frame.body.map(BodyId::index),
            rotation: frame.rotation,
            position: frame.position,
        }
    }
}
