//! The checked, numbered tree of bodies.
//!
//! In: a [`Description`](crate::description::Description), as the user wrote it. Out: a [`Tree`].
//! Afterwards: every lower body (parent) has a smaller id than its bodies, every name is unique and
//! maps to a unique Rust identifier, every number is finite, masses and inertias are those of real
//! bodies, and every free coordinate moves mass; later stages do not fail on a user's mistake.
//! Does not: derive anything.

mod build;
mod canonical;
mod inertia;
mod joints;
mod mobility;
mod names;
mod numbering;
mod rows;
mod sweep;

pub use build::{Checked, build, build_with};
pub use canonical::canonical;

use crate::id::{BodyId, CoordinateId, ParameterId, SpeedId};

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
    /// The values that the user sets at run time: gravity's, then body by body.
    pub parameters: Vec<Parameter>,
    /// The number of generalized coordinates, the length of `q`.
    pub n_coordinates: usize,
    /// The number of generalized speeds, the length of `u`.
    pub n_speeds: usize,
}

/// One rigid body and the joint to its lower body.
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
    /// Mass, kg.
    pub mass: Value,
    /// r'_K: from the body's origin `O_K` to its mass centre, body components, m.
    pub mass_center: [Value; 3],
    /// Inertia about the mass centre, body components.
    pub inertia: Inertia,
    /// q'_K: from the lower body's origin (for a root, the inertial origin), lower-body components, m.
    pub attachment: [Value; 3],
    /// Which of the six relative coordinates are free.
    pub joint: Joint,
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

/// The joint of a body with its lower body: three 1-2-3 body-fixed angles and three translations.
#[derive(Clone, Copy, Debug)]
pub struct Joint {
    /// `theta_1`, `theta_2`, `theta_3`, rad: the rotations about x, y, z that lead from the lower body's axes to the body's.
    pub angles: [Coordinate; 3],
    /// `s_1`, `s_2`, `s_3`, m: translation of the body's origin, lower-body components.
    pub translations: [Coordinate; 3],
}

/// One of the six relative coordinates of a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Coordinate {
    /// Free to move, with its places in `q` and `u`.
    Free {
        /// The place in `q`.
        coordinate: CoordinateId,
        /// The place in `u`: the speed is the coordinate's rate, Eq. (44).
        speed: SpeedId,
    },
    /// Held at a constant value, rad or m.
    Locked(f64),
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
    /// The body that it belongs to; `None` for gravity.
    pub body: Option<BodyId>,
    /// The value in the description.
    pub nominal: f64,
    /// The unit, for doc comments: "kg", "m", "kg m^2", "m/s^2".
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

    /// The body, its lower body, and so on down to its root.
    pub fn path(&self, body: BodyId) -> impl Iterator<Item = BodyId> + '_ {
        std::iter::successors(Some(body), |&body| self.lower(body))
    }

    /// The nominal value of a number of the description.
    pub fn nominal(&self, value: Value) -> f64 {
        match value {
            Value::Baked(number) => number,
            Value::Runtime(parameter) => self.parameters[parameter.index()].nominal,
        }
    }
}

impl Joint {
    /// The six coordinates: the angles, then the translations.
    pub fn coordinates(&self) -> [Coordinate; 6] {
        let [t1, t2, t3] = self.angles;
        let [s1, s2, s3] = self.translations;
        [t1, t2, t3, s1, s2, s3]
    }

    /// True where `theta_1` and `theta_3` are both free: the angles are then singular at `cos(theta_2) = 0`.
    pub fn has_singular_chart(&self) -> bool {
        self.angles[0].is_free() && self.angles[2].is_free()
    }
}

impl Coordinate {
    /// True for a free coordinate.
    pub fn is_free(self) -> bool {
        matches!(self, Self::Free { .. })
    }

    /// The speed of a free coordinate.
    pub fn speed(self) -> Option<SpeedId> {
        match self {
            Self::Free { speed, .. } => Some(speed),
            Self::Locked(_) => None,
        }
    }
}
