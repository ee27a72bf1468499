//! A joint, as the user wrote it: its motions, its frames, and what acts along its coordinates.

use crate::description::coordinate_name::CoordinateName;
use crate::description::value::{Given, Limits, Optional, PerCoordinate, Scalar};
use crate::diagnostic::{Diagnostic, Span, Spanned};
use crate::geometry::Rotation;

/// A joint between two constant frames: one in the lower body, one in the body.
///
/// Where the coordinates are zero, the frames coincide. The coordinates are those of the notes: angles about the
/// axes of the joint, and translations along its axes in the lower body.
#[derive(Clone, Debug)]
pub struct WrittenJoint {
    /// Which motion the joint leaves free.
    pub kind: Given<JointKind>,
    /// The joint's own name; absent: the body's name serves.
    pub name: Optional<String>,
    /// For a joint about or along one axis: the axis, in the joint's axes; of any length but zero.
    pub axis: Optional<[f64; 3]>,
    /// From the lower body's origin to where the joint sits, lower-body components, m.
    pub attachment: [Given<Scalar>; 3],
    /// From the lower body's axes to the joint's; absent: the same.
    pub attachment_rotation: Optional<Rotation>,
    /// From the body's origin to where the joint sits in the body, body components, m; absent: the origin.
    pub body_attachment: Option<[Given<Scalar>; 3]>,
    /// From the joint's axes, moved, to the body's; absent: the same.
    pub body_rotation: Optional<Rotation>,
    /// The constant values of coordinates that are not free; those not listed are zero.
    pub locked: Vec<(Spanned<CoordinateName>, Given<f64>)>,
    /// How the orientation is described, where all three angles are free; absent: by the angles.
    pub chart: Optional<Chart>,
    /// What the speeds of rotation are; absent: the angles' rates, or with a quaternion the angular velocity.
    pub speeds: Optional<Speeds>,
    /// Stiffness of a spring, N m/rad, N/m.
    pub stiffness: PerCoordinate<Scalar>,
    /// The coordinate at which the spring is at rest, rad, m; absent: zero.
    pub rest: PerCoordinate<Scalar>,
    /// Viscous damping, N m s/rad, N s/m.
    pub damping: PerCoordinate<Scalar>,
    /// Inertia of a rotor as the joint feels it, kg m², kg.
    pub armature: PerCoordinate<Scalar>,
    /// Coulomb friction, N m, N: data only.
    pub friction: PerCoordinate<f64>,
    /// Limits: data only.
    pub limits: PerCoordinate<Limits>,
    /// The joint whose coordinate this one's follows.
    pub mimic: Optional<Mimic>,
}

/// Which motion a joint leaves free.
#[derive(Clone, Debug, PartialEq)]
pub enum JointKind {
    /// None: the body is part of its lower body.
    Fixed,
    /// Rotation about an axis.
    Revolute,
    /// Rotation about an axis, without limits.
    Continuous,
    /// Translation along an axis.
    Prismatic,
    /// Rotation about and translation along an axis.
    Cylindrical,
    /// Translation along the two axes normal to the given one, and rotation about it.
    Planar,
    /// The first two angles.
    Universal,
    /// The three angles.
    Spherical,
    /// All six coordinates.
    Free,
    /// These coordinates.
    List(Vec<Spanned<CoordinateName>>),
}

impl JointKind {
    /// The joints that have a name of their own.
    pub const NAMED: [(&str, Self); 9] = [
        ("fixed", Self::Fixed),
        ("revolute", Self::Revolute),
        ("continuous", Self::Continuous),
        ("prismatic", Self::Prismatic),
        ("cylindrical", Self::Cylindrical),
        ("planar", Self::Planar),
        ("universal", Self::Universal),
        ("spherical", Self::Spherical),
        ("free", Self::Free),
    ];

    /// True for a joint about or along an axis that has to be given.
    pub fn has_axis(&self) -> bool {
        match self {
            Self::Revolute
            | Self::Continuous
            | Self::Prismatic
            | Self::Cylindrical
            | Self::Planar => true,
            Self::Fixed | Self::Universal | Self::Spherical | Self::Free | Self::List(_) => false,
        }
    }

    /// True for a joint that leaves nothing free.
    pub fn is_fixed(&self) -> bool {
        match self {
            Self::Fixed => true,
            Self::List(coordinates) => coordinates.is_empty(),
            Self::Revolute
            | Self::Continuous
            | Self::Prismatic
            | Self::Cylindrical
            | Self::Planar
            | Self::Universal
            | Self::Spherical
            | Self::Free => false,
        }
    }

    /// True where all that the joint leaves free are angles.
    pub fn is_angular(&self) -> bool {
        match self {
            Self::Revolute | Self::Continuous | Self::Universal | Self::Spherical => true,
            Self::List(coordinates) => {
                !self.is_fixed() && coordinates.iter().all(|own| own.value.is_angle())
            }
            Self::Fixed | Self::Prismatic | Self::Cylindrical | Self::Planar | Self::Free => false,
        }
    }
}

/// The fault of what acts about all axes where the speeds are rates of angles.
pub(crate) fn on_angular_velocity(what: &str, span: Span) -> Diagnostic {
    let message =
        format!("{what} acts on the angular velocity, but the speeds are rates of angles");
    Diagnostic::error(message).at(span, "expected 0").help(
        "with `chart = \"quaternion\"`, the default, the speeds are components of the angular velocity",
    )
}

/// How an orientation is described.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Chart {
    /// By 1-2-3 body-fixed angles, Eq. (4).
    Angles,
    /// By Euler parameters: a unit quaternion, scalar first.
    Quaternion,
}

/// What the speeds of a rotation are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Speeds {
    /// The angles' rates, Eq. (44).
    Rates,
    /// Components of the relative angular velocity along the joint's moved axes, Eqs. (8), (9).
    AngularVelocity,
}

impl Chart {
    /// Both, with their names.
    pub const NAMED: [(&str, Self); 2] =
        [("angles", Self::Angles), ("quaternion", Self::Quaternion)];
}

impl Speeds {
    /// Both, with their names.
    pub const NAMED: [(&str, Self); 2] = [
        ("rates", Self::Rates),
        ("angular_velocity", Self::AngularVelocity),
    ];
}

/// A coordinate that is `multiplier` times another plus `offset`.
#[derive(Clone, Debug, PartialEq)]
pub struct Mimic {
    /// The joint that it follows, by its name; that of its body where it has none.
    pub joint: Spanned<String>,
    /// Times the other coordinate.
    pub multiplier: f64,
    /// Plus, rad, m.
    pub offset: f64,
}

impl WrittenJoint {
    /// A joint of this kind and in this place, with nothing beside.
    pub fn new(kind: Given<JointKind>, attachment: [Given<Scalar>; 3]) -> Self {
        Self {
            kind,
            name: None,
            axis: None,
            attachment,
            attachment_rotation: None,
            body_attachment: None,
            body_rotation: None,
            locked: Vec::new(),
            chart: None,
            speeds: None,
            stiffness: PerCoordinate::Absent,
            rest: PerCoordinate::Absent,
            damping: PerCoordinate::Absent,
            armature: PerCoordinate::Absent,
            friction: PerCoordinate::Absent,
            limits: PerCoordinate::Absent,
            mimic: None,
        }
    }
}
