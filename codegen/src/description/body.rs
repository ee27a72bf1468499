//! A body, as the user wrote it.

use crate::description::joint::{JointKind, WrittenJoint};
use crate::description::value::{Given, Optional, Scalar};
use crate::diagnostic::{Span, Spanned};
use crate::geometry::Rotation;

/// A body, as the user wrote it.
#[derive(Clone, Debug)]
pub struct WrittenBody {
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
    /// The share of the weight that a force at the mass centre lifts; absent: zero.
    pub gravity_compensation: Optional<Scalar>,
    /// The joint with its lower body.
    pub joint: WrittenJoint,
}

impl WrittenBody {
    /// What its joint is called elsewhere: by its own name, or by the body's, which means no joint where the body is fixed.
    pub fn joint_name(&self) -> Option<&Spanned<String>> {
        let is_fixed = |kind: &Spanned<JointKind>| kind.value.is_fixed();
        let of_body = self.name.as_ref();
        let of_body = of_body.filter(|_| !self.joint.kind.as_ref().is_some_and(is_fixed));
        self.joint.name.as_ref().or(of_body)
    }
}

/// Names of the components of [`WrittenBody::inertia`], in its order.
pub const INERTIA_COMPONENTS: [&str; 6] = ["xx", "yy", "zz", "xy", "xz", "yz"];
