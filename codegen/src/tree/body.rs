//! The bodies of a tree, and what each is made of.

use crate::geometry::{IDENTITY, Rotation};
use crate::id::BodyId;
use crate::tree::joint::Joint;
use crate::tree::offset::Offset;
use crate::tree::value::Value;

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
    pub parts: Vec<RigidPart>,
    /// The joint with the lower body, whose internal axes are meant where it speaks of the lower body's.
    pub joint: Joint,
    /// The user's axes and origin.
    pub pose: Pose,
}

/// A rigid part of a body.
#[derive(Clone, Debug)]
pub struct RigidPart {
    /// Mass, kg.
    pub mass: Value,
    /// r'_K: from the body's internal origin to the part's mass centre, internal axes, m.
    pub mass_center: Offset,
    /// Inertia about the part's mass centre, along axes of its own.
    pub inertia: Inertia,
    /// From the body's internal axes to those of the inertia.
    pub axes: Rotation,
    /// The share of its weight that a force at its mass centre lifts, beyond what is lifted of all bodies alike.
    pub lifted: Value,
}

/// Where a frame stands that is fixed in a body, or in the inertial frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Pose {
    /// From the internal axes to the frame's.
    pub rotation: Rotation,
    /// From the internal origin to the frame's, internal axes, m.
    pub origin: Offset,
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

impl RigidPart {
    /// True where something lifts it, or may at run time.
    pub fn is_lifted(&self) -> bool {
        self.lifted != Value::Baked(0.0)
    }
}

impl Pose {
    /// The internal axes and origin themselves.
    pub(crate) fn internal() -> Self {
        Self {
            rotation: IDENTITY,
            origin: Offset::default(),
        }
    }
}
