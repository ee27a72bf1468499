//! The checked, numbered tree of bodies.
//!
//! In: a [`Description`](crate::description::Description), as the user wrote it. Out: a [`Tree`].
//! Afterwards: every lower body (parent) has a smaller id than its bodies, every name is unique and
//! maps to a unique Rust identifier, every number is finite, masses and inertias are those of real
//! bodies, and every free coordinate moves mass; later stages do not fail on a user's mistake.
//! Does not: derive anything.

mod assemble;
mod build;
mod canonical;
mod coupled;
mod inertia;
mod joint;
mod joint_check;
mod mechanics;
mod mimic;
mod mobility;
mod named;
mod names;
mod numbering;
mod offset;
mod places;
mod resolve;
mod rotation;
mod rows;
mod snapping;
mod sweep;
mod values;

pub use build::{Checked, build, build_with};
pub use canonical::canonical;
pub(crate) use inertia::principal;
pub use joint::{Chart, Coordinate, Joint, Mechanics, Motion, Orientation, is_translation};
pub use named::NamedFrame;
pub(crate) use names::is_keyword;
pub use offset::{Offset, Step};
pub use rotation::snapped_sin_cos;
pub(crate) use sweep::Units;

use std::collections::BTreeSet;

use crate::{
    geometry::Rotation,
    id::{BodyId, ParameterId},
};

/// What is changed of a description on its way to a tree.
#[derive(Clone, Debug, PartialEq)]
pub struct Changes {
    /// Entries of constant rotations that are as near as this to 0, 1 or -1 become that; 0 changes none.
    pub snap: f64,
    /// Coordinates to hold at a value, rad or m, by their names or those of their joints.
    pub lock: Vec<(String, f64)>,
    /// Joints to fix where their coordinates are zero, by their names or those of their bodies.
    pub remove: Vec<String>,
}

impl Default for Changes {
    /// Snapping at 1e-9, which covers right angles written with ten digits; nothing locked, nothing removed.
    fn default() -> Self {
        Self {
            snap: 1e-9,
            lock: Vec::new(),
            remove: Vec::new(),
        }
    }
}

/// A tree of rigid bodies that obeys every rule a description can break.
#[derive(Clone, Debug)]
pub struct Tree {
    /// The system's name, as the user wrote it.
    pub name: String,
    /// Gravity, inertial components, m/s².
    pub gravity: [Value; 3],
    /// The order of coordinates and speeds.
    pub order: Order,
    /// The bodies; `bodies[k]` is `BodyId::new(k)`.
    pub bodies: Vec<Body>,
    /// The bodies that are part of others, in the order of the description.
    pub frames: Vec<Frame>,
    /// How near to 0, 1 or -1 entries of constant rotations are made exact.
    pub snap: f64,
    /// The values that the user sets at run time: gravity's, then body by body.
    pub parameters: Vec<Parameter>,
    /// The number of generalized coordinates, the length of `q`.
    pub n_coordinates: usize,
    /// The number of generalized speeds, the length of `u`.
    pub n_speeds: usize,
}

/// One rigid body, with all that is fixed to it, and the joint to its lower body.
///
/// Its equations are written in axes of our own choice, the body's internal ones: those of the joint, moved with the
/// body, with their origin where the joint sits. [`Pose`] leads from there to the user's.
#[derive(Clone, Debug)]
pub struct Body {
    /// The name, as the user wrote it.
    pub name: String,
    /// The Rust identifier that stands for the name in generated code: lower snake case, unique.
    pub identifier: String,
    /// The body's number in the user's own body-connection array, from 1.
    pub user_number: usize,
    /// The lower body (parent); `None` is the inertial frame. Smaller than the body's own id.
    pub lower: Option<BodyId>,
    /// The bodies whose lower body it is, in their order.
    pub uppers: Vec<BodyId>,
    /// What the body is made of: itself, and what is fixed to it.
    pub parts: Vec<Part>,
    /// The joint with the lower body, whose internal axes are meant where it speaks of the lower body's.
    pub joint: Joint,
    /// The user's axes and origin.
    pub pose: Pose,
}

/// A rigid part of a body.
#[derive(Clone, Debug)]
pub struct Part {
    /// Mass, kg.
    pub mass: Value,
    /// r'_K: from the body's internal origin to the part's mass centre, internal axes, m.
    pub mass_center: Offset,
    /// Inertia about the part's mass centre, along axes of its own.
    pub inertia: Inertia,
    /// From the body's internal axes to those of the inertia.
    pub axes: Rotation,
}

/// A frame fixed in a body, or in the inertial frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Pose {
    /// From the internal axes to the frame's.
    pub rotation: Rotation,
    /// From the internal origin to the frame's, internal axes, m.
    pub origin: Offset,
}

/// A frame that the user gave a name: a body that is fixed to another, and is part of that.
#[derive(Clone, Debug)]
pub struct Frame {
    /// The name, as the user wrote it.
    pub name: String,
    /// The Rust identifier that stands for the name in generated code: unique among bodies and frames.
    pub identifier: String,
    /// The body of which it is part; `None` is the inertial frame.
    pub body: Option<BodyId>,
    /// From the user's axes of that body to the frame's.
    pub rotation: Rotation,
    /// From the user's origin of that body to the frame's, that body's axes, m; at the nominal values.
    pub position: [f64; 3],
    /// Where it is in that body's internal frame.
    pub pose: Pose,
}

/// Components of an inertia tensor, kg m²; `xy` is the tensor's component: minus the product of inertia integral.
#[derive(Clone, Copy, Debug)]
#[expect(
    missing_docs,
    reason = "each field is the component that its name says"
)]
pub struct Inertia {
    pub xx: Value,
    pub yy: Value,
    pub zz: Value,
    pub xy: Value,
    pub xz: Value,
    pub yz: Value,
}

/// A number of the description, in one of its binding times.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// Baked into the generated code.
    Baked(f64),
    /// A field of `Parameters`, with a nominal value.
    Runtime(ParameterId),
}

/// A value that the user sets at run time.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// The field's name in `Parameters`: body identifier and quantity, such as `hub_mass` or `hub_inertia_xy`; `gravity_z`.
    pub name: String,
    /// The body that it belongs to; `None` for gravity, and for what is fixed to the inertial frame.
    pub body: Option<BodyId>,
    /// The value in the description.
    pub nominal: f64,
    /// The unit, for doc comments: "kg", "m", "kg m^2", "m/s^2", "N m s/rad".
    pub unit: &'static str,
}

/// The order of coordinates and speeds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// Body after body; in a body its free angles, then its free translations.
    Body,
    /// All free angles, body after body, then all free translations: Eq. (1).
    Notes,
}

impl Tree {
    /// The ids of all bodies, from the inertial frame outward.
    pub fn body_ids(&self) -> impl DoubleEndedIterator<Item = BodyId> + ExactSizeIterator + use<> {
        (0..self.bodies.len()).map(BodyId::new)
    }

    /// The body with this id.
    pub fn body(&self, body: BodyId) -> &Body {
        &self.bodies[body.index()]
    }

    /// The lower body (parent), one step toward the inertial frame, which is `None`.
    pub fn lower(&self, body: BodyId) -> Option<BodyId> {
        self.body(body).lower
    }

    /// The bodies whose lower body this one is, in their order.
    pub fn uppers(&self, body: BodyId) -> &[BodyId] {
        &self.body(body).uppers
    }

    /// The body, its lower body, and so on down to its root.
    pub fn path(&self, body: BodyId) -> impl Iterator<Item = BodyId> + '_ {
        std::iter::successors(Some(body), |&body| self.lower(body))
    }

    /// The name of every coordinate, in the order of `q`: `hub_theta1`; that of its joint where that has one name and one
    /// coordinate.
    pub fn coordinate_names(&self) -> Vec<String> {
        let mut names = vec![String::new(); self.n_coordinates];
        for body in &self.bodies {
            let coordinates = body.joint.coordinates();
            let is_only = coordinates.len() == 1;
            for (kind, coordinate) in coordinates {
                names[coordinate.index()] = names::of_coordinate(&body.joint, kind, is_only);
            }
        }
        names
    }

    /// The name of every speed, in the order of `u`: that of its coordinate with `_dot`, or `hub_w1` for a component of
    /// an angular velocity.
    pub fn speed_names(&self) -> Vec<String> {
        self.along_speeds("_dot", "")
    }

    /// For every speed the name of its coordinate with `of_rate`, or of its component of an angular velocity with
    /// `of_component`.
    pub fn along_speeds(&self, of_rate: &str, of_component: &str) -> Vec<String> {
        let mut names = vec![String::new(); self.n_speeds];
        for body in &self.bodies {
            let joint = &body.joint;
            let speeds = joint.speeds();
            let is_only = speeds.len() == 1;
            let kinds = joint.motion_names();
            for (motion, speed) in speeds {
                let suffix = if joint.coordinate_of(motion).is_some() {
                    of_rate
                } else {
                    of_component
                };
                names[speed.index()] = names::of_coordinate(joint, kinds[motion], is_only) + suffix;
            }
        }
        names
    }

    /// The body whose joint a speed belongs to, for every speed.
    pub fn speed_bodies(&self) -> Vec<BodyId> {
        let mut bodies = vec![BodyId::new(0); self.n_speeds];
        for body in self.body_ids() {
            for (_, speed) in self.body(body).joint.speeds() {
                bodies[speed.index()] = body;
            }
        }
        bodies
    }

    /// The pairs of speeds that move one body or more, `[row, column]` with `column <= row`, row after row: the entries on
    /// and below the diagonal of a mass matrix that the tree does not make zero.
    pub fn coupled_speeds(&self) -> BTreeSet<[usize; 2]> {
        let mut pairs = BTreeSet::new();
        let mut moving: Vec<BTreeSet<usize>> = Vec::with_capacity(self.bodies.len());
        for body in &self.bodies {
            let mut speeds = body
                .lower
                .map_or_else(BTreeSet::new, |lower| moving[lower.index()].clone());
            let own = body.joint.motions().into_iter().flatten();
            for speed in own.map(|motion| motion.speed.index()) {
                speeds.insert(speed);
                pairs.extend(
                    speeds
                        .iter()
                        .map(|&other| [speed.max(other), speed.min(other)]),
                );
            }
            moving.push(speeds);
        }
        pairs
    }

    /// How many bodies it has with all that is fixed to them.
    pub fn n_parts(&self) -> usize {
        self.bodies.iter().map(|body| body.parts.len()).sum()
    }

    /// True where some orientation is described by a quaternion.
    pub fn has_quaternions(&self) -> bool {
        let is_quaternion = |body: &Body| {
            matches!(
                body.joint.orientation,
                Orientation::AngularVelocity {
                    chart: Chart::EulerParameters(_),
                    ..
                }
            )
        };
        self.bodies.iter().any(is_quaternion)
    }

    /// The nominal value of a number of the description.
    pub fn nominal(&self, value: Value) -> f64 {
        match value {
            Value::Baked(number) => number,
            Value::Runtime(parameter) => self.parameters[parameter.index()].nominal,
        }
    }
}
