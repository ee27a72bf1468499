//! Joints: what they leave free and about which axes, and where their coordinates and speeds stand.

use super::frame::{Moved, moved};
use crate::{
    geometry::{Rotation, transposed},
    id::{BodyId, CoordinateId},
    tree::{self, Coordinate, CoordinateKind, Orientation, Pose, Tree},
};

/// A body's joint.
#[derive(Clone, Debug, PartialEq)]
pub struct Joint {
    /// Its name, as the user wrote it.
    pub name: String,
    /// The name of its kind, where it has one.
    pub kind: Option<&'static str>,
    /// How its orientation is told.
    pub chart: JointChart,
    /// The places in `q` of theta1, theta2, theta3 or e0, e1, e2, e3, then s1, s2, s3; none for what is locked.
    pub q: [Option<usize>; 7],
    /// The places in `u` of the speeds of the three rotations and the three translations.
    pub u: [Option<usize>; 6],
    /// From the lower body's axes to the joint's, which the coordinates are about and along: these are its rows.
    pub axes: Rotation,
    /// From the body's axes to the same, as the joint moves them.
    pub body_axes: Rotation,
    /// From the lower body's origin to where the joint sits, the lower body's axes, m; at the nominal values.
    pub position: [f64; 3],
    /// From the body's origin to the joint, as it moves with the body, the body's axes, m; at the nominal values.
    pub body_position: [f64; 3],
    /// What moves `position` at run time.
    pub moved: Vec<Moved>,
    /// What follows another joint.
    pub mimic: Option<Mimic>,
    /// The coordinates that are held, but not at zero: what they are, and the value, rad or m.
    pub locked: Vec<(&'static str, f64)>,
}

/// A coordinate that follows another: a joint that has one has no other.
#[derive(Clone, Debug, PartialEq)]
pub struct Mimic {
    /// What it is within its joint.
    pub coordinate: &'static str,
    /// The name of the joint that it follows: the last one, where that follows another itself.
    pub joint: String,
    /// The place of that joint's coordinate in `q`.
    pub leader: usize,
    /// Times that one.
    pub multiplier: f64,
    /// Plus, rad or m.
    pub offset: f64,
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
    pub(super) fn of(tree: &Tree, body: BodyId) -> Self {
        let tree::Body { joint, pose, .. } = tree.body(body);
        let lower = tree.user_pose(tree.lower(body));
        let seat = Pose {
            rotation: joint.rotation,
            origin: joint.attachment.clone(),
        };
        let (chart, q, u) = places(joint);
        Self {
            name: joint.name.clone(),
            kind: joint.kind(),
            chart,
            q,
            u,
            axes: seat.rotation_from(&lower, tree.snap),
            body_axes: transposed(&pose.rotation),
            position: seat.position_from(&lower, &tree.parameters),
            body_position: Pose::internal().position_from(pose, &tree.parameters),
            moved: moved(tree, &seat, &lower),
            mimic: Mimic::of(tree, joint),
            locked: locked(joint),
        }
    }
}

impl Joint {
    /// The axis, with the lower body's components, about or along which the coordinate at a place of [`Self::q`] is; `None` of a quaternion, and where other
    /// angles turn it.
    pub(crate) fn axis(&self, place: usize) -> Option<[f64; 3]> {
        if place >= 4 {
            return Some(self.axes[place - 4]);
        }
        let is_angle = |(name, _): &&(&str, f64)| name.starts_with("theta");
        let held = self.locked.iter().filter(is_angle).count();
        let angles = self.q[..3].iter().flatten().count() + held;
        let is_only = self.chart == JointChart::AngleRates && angles == 1;
        self.axes.get(place).copied().filter(|_| is_only)
    }
}

impl Mimic {
    fn of(tree: &Tree, joint: &tree::Joint) -> Option<Self> {
        let mut coordinates = coordinates(joint);
        coordinates.find_map(|(name, coordinate)| match coordinate {
            Coordinate::Mimic {
                coordinate,
                multiplier,
                offset,
                ..
            } => Some(Self {
                coordinate: name,
                joint: owner(tree, coordinate)?.name.clone(),
                leader: coordinate.index(),
                multiplier,
                offset,
            }),
            Coordinate::Free { .. } | Coordinate::Locked(_) => None,
        })
    }
}

/// The joint whose coordinate this is.
fn owner(tree: &Tree, coordinate: CoordinateId) -> Option<&tree::Joint> {
    let mut joints = tree.bodies.iter().map(|body| &body.joint);
    joints.find(|joint| {
        let own = joint.coordinates();
        own.iter().any(|(_, place)| *place == coordinate)
    })
}

/// The coordinates whose rates are motions, with what they are.
fn coordinates(joint: &tree::Joint) -> impl Iterator<Item = (&'static str, Coordinate)> + '_ {
    let names = joint.motion_names().into_iter().enumerate();
    names.filter_map(|(motion, name)| Some((name, joint.coordinate_of(motion)?)))
}

fn locked(joint: &tree::Joint) -> Vec<(&'static str, f64)> {
    let held = coordinates(joint).filter_map(|(name, coordinate)| match coordinate {
        Coordinate::Locked(value) if value != 0.0 => Some((name, value)),
        _ => None,
    });
    held.collect()
}

/// How the orientation is told, and the places of [`Joint::q`] and [`Joint::u`].
fn places(joint: &tree::Joint) -> (JointChart, [Option<usize>; 7], [Option<usize>; 6]) {
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
    (chart, q, u)
}
