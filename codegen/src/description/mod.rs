//! What the user wrote, as plain data.
//!
//! In: a file in one of the formats. Out: a [`Description`], every value with its place in the file.
//! Afterwards: values have the right types and lengths; a value that has not, or is missing where it must
//! not be, is `None` and stands in [`Description::faults`]. Does not: check what the values mean; that is
//! [`tree::build`](crate::tree::build), which reports its own findings together with these.
//!
//! Reading never fails: a file that is no description at all is an empty description with faults.

pub(crate) mod cycles;
pub mod mjcf;
pub mod toml;
pub(crate) mod toml_reader;
pub mod urdf;
pub(crate) mod xml;

use std::io;

pub use crate::geometry::Rotation;

use crate::diagnostic::{Diagnostic, Source, Span, Spanned};
use crate::limits::{BODIES, INPUT_BYTES};
use crate::tree::Order;

/// What a URDF or MJCF leaves to the user.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Reading {
    /// How the root link of a URDF hangs from the inertial frame; absent: fixed.
    pub base: Option<Base>,
    /// How the orientations of free and ball joints are described; absent: by Euler parameters.
    pub chart: Option<Chart>,
}

/// How the root link of a URDF hangs from the inertial frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Base {
    /// It is part of the inertial frame.
    Fixed,
    /// By a free joint.
    Free,
}

/// Reads a file that a model includes, given its path as the model writes it.
pub type Include<'a> = &'a dyn Fn(&str) -> io::Result<String>;

/// Reads no file: for a model that stands alone.
///
/// # Errors
/// Always.
pub fn no_includes(_path: &str) -> io::Result<String> {
    Err(io::ErrorKind::Unsupported.into())
}

/// Reads a model: URDF where its name ends in `.urdf`, MJCF or URDF, by its root element, where it ends in `.xml` or
/// `.mjcf`, our own format otherwise.
pub fn read(source: &Source, reading: &Reading, include: Include<'_>) -> Description {
    if let Some(fault) = too_large(source) {
        let empty = Source::new(source.name(), "");
        return Description::none(&empty, vec![fault]);
    }
    let extension = source.name().rsplit_once('.').map_or("", |(_, end)| end);
    let (mut description, base, chart) = match extension.to_ascii_lowercase().as_str() {
        "urdf" => (urdf::parse(source, reading), None, None),
        "xml" | "mjcf" if urdf::is_urdf(source) => (urdf::parse(source, reading), None, None),
        "xml" | "mjcf" => {
            let base = "an MJCF says itself which of its bodies are free";
            (mjcf::parse(source, reading, include), Some(base), None)
        }
        _ => {
            let base =
                "this model says itself by which joints its bodies hang from the inertial frame";
            let chart = "each joint of this model says it itself, with the key `chart`";
            (toml::parse(source), Some(base), Some(chart))
        }
    };
    // What the model says itself is not asked for a second time.
    let base = base
        .filter(|_| reading.base.is_some())
        .map(|why| ("base", "a URDF", why));
    let chart = chart
        .filter(|_| reading.chart.is_some())
        .map(|why| ("chart", "a URDF or MJCF", why));
    for (option, of, why) in base.into_iter().chain(chart) {
        let fault = format!("the {option} can be chosen for {of} alone: {why}");
        description.faults.push(Diagnostic::error(fault));
    }
    description
}

/// What is wrong where a file, with those that it includes, is larger than may be.
pub(crate) fn too_large(source: &Source) -> Option<Diagnostic> {
    let n_bytes: usize = source.files().map(|file| file.text().len()).sum();
    let message = format!("the model has {n_bytes} bytes; expected at most {INPUT_BYTES}");
    (n_bytes > INPUT_BYTES).then(|| Diagnostic::error(message))
}

/// What is wrong where there are more bodies, or entries of a list, than may be.
pub(crate) fn too_many(what: &str, count: usize) -> Option<Diagnostic> {
    let message = format!("{what} {count}; expected at most {BODIES}");
    (count > BODIES).then(|| Diagnostic::error(message))
}

/// A value with its place; `None` where the file holds none that can be used, which is then among the faults.
pub type Given<T> = Option<Spanned<T>>;

/// A multibody system as the user wrote it.
#[derive(Clone, Debug)]
pub struct Description {
    /// The file.
    pub source: Source,
    /// The system's name.
    pub name: Given<String>,
    /// Gravity, inertial components, m/s²; zero where the file says nothing.
    pub gravity: [Given<Scalar>; 3],
    /// The body-connection array: for each body the number of its lower body (parent) from 1, or 0 for the inertial frame.
    pub lower_bodies: Given<Vec<Given<i64>>>,
    /// The order of coordinates and speeds; body after body where the file says nothing.
    pub order: Given<Order>,
    /// The bodies, in the numbering of the body-connection array.
    pub bodies: Vec<Body>,
    /// What was wrong already while reading.
    pub faults: Vec<Diagnostic>,
}

impl Description {
    /// A file of which nothing could be read.
    fn none(source: &Source, faults: Vec<Diagnostic>) -> Self {
        let start = Span { start: 0, end: 0 };
        Self {
            source: source.clone(),
            name: None,
            gravity: [None; 3],
            lower_bodies: None,
            order: Some(Spanned::new(Order::Body, start)),
            bodies: Vec::new(),
            faults,
        }
    }
}

/// A value that may be absent: `None` where it is, or where what is written cannot be used, which is then a fault.
pub type Optional<T> = Option<Spanned<T>>;

/// A body, as the user wrote it.
#[derive(Clone, Debug)]
pub struct Body {
    /// Where the body begins in the file.
    pub span: Span,
    /// The name.
    pub name: Given<String>,
    /// Mass, kg.
    pub mass: Given<Scalar>,
    /// From the body's origin to its mass centre, body components, m.
    pub mass_center: [Given<Scalar>; 3],
    /// Inertia about the mass centre: xx, yy, zz, xy, xz, yz of the tensor, kg m².
    pub inertia: [Given<Scalar>; 6],
    /// From the body's axes to those in which the inertia is given; absent: the same.
    pub inertia_rotation: Optional<Rotation>,
    /// The joint with its lower body.
    pub joint: Joint,
}

/// A joint between two constant frames: one in the lower body, one in the body.
///
/// Where the coordinates are zero, the frames coincide. The coordinates are those of the notes: angles about the
/// axes of the joint, and translations along its axes in the lower body.
#[derive(Clone, Debug)]
pub struct Joint {
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
    pub locked: Vec<(Spanned<Axis>, Given<f64>)>,
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
    List(Vec<Spanned<Axis>>),
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

/// A quantity of a joint's free coordinates.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum PerCoordinate<T> {
    /// None is given.
    #[default]
    Absent,
    /// One for every free coordinate.
    Same(Spanned<T>),
    /// One for each of these coordinates.
    Each(Vec<(Spanned<Axis>, Spanned<T>)>),
}

/// Limits of a coordinate; what is absent is unlimited.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Limits {
    /// The least value, rad, m.
    pub lower: Optional<f64>,
    /// The greatest value, rad, m.
    pub upper: Optional<f64>,
    /// The greatest speed, rad/s, m/s.
    pub velocity: Optional<f64>,
    /// The greatest force, N m, N.
    pub effort: Optional<f64>,
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

/// A number in one of its binding times.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Scalar {
    /// Baked into the generated code.
    Baked(f64),
    /// Set by the user at run time; this is its nominal value.
    Runtime(f64),
}

/// Names of the components of [`Body::inertia`], in its order.
pub const INERTIA_COMPONENTS: [&str; 6] = ["xx", "yy", "zz", "xy", "xz", "yz"];

/// One of the six relative coordinates of a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Axis {
    /// The first of the 1-2-3 body-fixed angles, about x.
    Theta1,
    /// The second angle, about y.
    Theta2,
    /// The third angle, about z.
    Theta3,
    /// Translation along the x of the joint's axes in the lower body.
    S1,
    /// Translation along the y of the joint's axes in the lower body.
    S2,
    /// Translation along the z of the joint's axes in the lower body.
    S3,
}

impl Scalar {
    /// The number itself, or its nominal value.
    pub fn nominal(self) -> f64 {
        match self {
            Self::Baked(number) | Self::Runtime(number) => number,
        }
    }
}

impl Base {
    /// Both, with their names.
    pub const NAMED: [(&str, Self); 2] = [("fixed", Self::Fixed), ("free", Self::Free)];
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
        matches!(
            self,
            Self::Revolute | Self::Continuous | Self::Prismatic | Self::Cylindrical | Self::Planar
        )
    }
}

impl Joint {
    /// A joint of which nothing is known yet.
    pub fn unknown() -> Self {
        Self {
            kind: None,
            name: None,
            axis: None,
            attachment: [None; 3],
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

impl Axis {
    /// All six, angles first.
    pub const ALL: [Self; 6] = [
        Self::Theta1,
        Self::Theta2,
        Self::Theta3,
        Self::S1,
        Self::S2,
        Self::S3,
    ];
    /// Their names, in the same order.
    pub const NAMES: [&str; 6] = ["theta1", "theta2", "theta3", "s1", "s2", "s3"];

    /// The place in [`Axis::ALL`].
    pub fn index(self) -> usize {
        self as usize
    }

    /// The name in a description.
    pub fn name(self) -> &'static str {
        Self::NAMES[self.index()]
    }

    /// The axis with this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|axis| axis.name() == name)
    }

    /// True for an angle.
    pub fn is_angle(self) -> bool {
        self.index() < 3
    }
}
