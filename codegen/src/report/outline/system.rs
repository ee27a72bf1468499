//! Systems as a comparison sees them.

use std::collections::BTreeMap;

use crate::geometry::Vector;

/// The key of a body's lower body.
pub(in crate::report) const LOWER: &str = "lower_body";
/// The key of a joint's axis.
pub(in crate::report) const AXIS: &str = "axis";
/// The lower body of a root.
pub(super) const INERTIAL: &str = "the inertial frame";

/// What is said of a system or body: `mass` and `12.0`.
pub type Values = BTreeMap<String, String>;

/// A system as a comparison sees it.
#[derive(Clone, Debug, PartialEq)]
pub struct Outline {
    /// The model's hash, where it is known.
    pub fingerprint: Option<u64>,
    /// What is said of the system as a whole.
    pub values: Values,
    /// The bodies, in the order of the model; those that are part of others too.
    pub bodies: Vec<Body>,
    /// Arrays that callers index, with what stands at each place.
    pub layouts: Vec<(Layout, Vec<String>)>,
}

/// A body as a comparison sees it.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// Its name.
    pub name: String,
    /// What is said of it and of its joint.
    pub values: Values,
    /// Its joint's own motions; `None` for modules, which hold no axes, and for a body without such motions.
    pub motions: Option<Motions>,
}

/// The motions of a body over the one below it.
#[derive(Clone, Debug, PartialEq)]
pub struct Motions {
    /// The body below, with all that is fixed to it.
    pub base: String,
    /// About the joint's axes, in their order.
    pub turns: Vec<Motion>,
    /// Along the joint's axes, in their order.
    pub slides: Vec<Motion>,
}

/// A motion of a joint, where the joint's other coordinates are zero.
#[derive(Clone, Debug, PartialEq)]
pub struct Motion {
    /// The name of its coordinate, or of a component of the angular velocity.
    pub name: String,
    /// Its axis among the joint's three.
    pub place: usize,
    /// About or along what the body moves, in the axes of the base that its user gives, and in those of the base's joint.
    pub axis: [Vector; 2],
}

/// Which arrays are laid out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Layout {
    /// Those over bodies.
    Bodies,
    /// `q`.
    Coordinates,
    /// `u`, `u_dot`, `tau`.
    Speeds,
    /// The fields of `Parameters`, which C may fill in order.
    Parameters,
}

impl Layout {
    /// What a caller indexes.
    pub fn name(self) -> &'static str {
        match self {
            Self::Bodies => "arrays over bodies",
            Self::Coordinates => "q",
            Self::Speeds => "u",
            Self::Parameters => "Parameters",
        }
    }
}
