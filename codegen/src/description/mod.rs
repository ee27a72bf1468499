//! What the user wrote, as plain data.
//!
//! In: a file in one of the formats. Out: a [`Description`], every value with its place in the file.
//! Afterwards: values have the right types and lengths; a value that has not, or is missing where it must
//! not be, is `None` and stands in [`Description::faults`]. Does not: check what the values mean; that is
//! [`tree::build`](crate::tree::build), which reports its own findings together with these.
//!
//! Reading never fails: a file that is no description at all is an empty description with faults.

pub(crate) mod read;
pub mod toml;

use crate::diagnostic::{Diagnostic, Source, Span, Spanned};
use crate::tree::Order;

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

/// A body and the joint to its lower body, as the user wrote them.
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
    /// Inertia about the mass centre: xx, yy, zz, xy, xz, yz of the tensor, body components, kg m².
    pub inertia: [Given<Scalar>; 6],
    /// From the lower body's origin to where the joint sits, lower-body components, m.
    pub attachment: [Given<Scalar>; 3],
    /// The free coordinates of the joint.
    pub joint: Given<Vec<Spanned<Axis>>>,
    /// The constant values of coordinates that are not free; those not listed are zero.
    pub locked: Vec<(Spanned<Axis>, Given<f64>)>,
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
    /// Translation along the lower body's x.
    S1,
    /// Translation along the lower body's y.
    S2,
    /// Translation along the lower body's z.
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
