//! The checked, numbered tree of a multibody system, and what follows from its structure alone.

use std::borrow::Cow;
use std::collections::BTreeSet;

use crate::description::Order;
use crate::id::{BodyId, CoordinateId, SpeedId};
use crate::tree::base_parameter::BaseParameters;
use crate::tree::body::{Body, RigidPart};
use crate::tree::frames::Frame;
use crate::tree::joint::{Coordinate, Joint};
use crate::tree::value::{Parameter, Value};

/// A tree of rigid bodies that obeys every rule a description can break.
#[derive(Clone, Debug)]
pub struct Tree {
    /// The system's name, as the user wrote it.
    pub name: String,
    /// Gravity, inertial components, m/s².
    pub gravity: [Value; 3],
    /// The share that is lifted of every weight, where it is the same for all; else zero.
    pub lifted: f64,
    /// The order of coordinates and speeds.
    pub order: Order,
    /// The bodies; `bodies[k]` is `BodyId::new(k)`.
    pub bodies: Vec<Body>,
    /// The bodies that are part of others, in the order of the description.
    pub frames: Vec<Frame>,
    /// Frames without mass, in the order of the description: functions may be of them, and nothing else depends on them.
    pub markers: Vec<Frame>,
    /// How near to 0, 1 or -1 entries of constant rotations are made exact.
    pub snap: f64,
    /// The values that the user sets at run time: gravity's, then body by body.
    pub parameters: Vec<Parameter>,
    /// The speeds whose accelerations are given, where forces of the others are: `hybrid_dynamics` alone depends on them.
    pub prescribed: BTreeSet<SpeedId>,
    /// The number of generalized coordinates, the length of `q`.
    pub n_coordinates: usize,
    /// The number of generalized speeds, the length of `u`.
    pub n_speeds: usize,
    /// The combinations of inertial parameters on which forces depend; `base_parameters` finds them.
    pub base_parameters: BaseParameters,
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

    /// What stands for a body in names, or for what belongs to no body.
    pub(crate) fn identifier(&self, scope: Option<BodyId>) -> &str {
        scope.map_or("system", |body| self.body(body).identifier.as_str())
    }

    /// The lower body (parent), one step toward the inertial frame, which is `None`.
    pub fn lower(&self, body: BodyId) -> Option<BodyId> {
        self.body(body).lower
    }

    /// The bodies whose lower body this one is, in their order.
    pub fn uppers(&self, body: BodyId) -> &[BodyId] {
        &self.body(body).uppers
    }

    /// The body on the inertial frame, where it is the only one.
    pub fn only_root(&self) -> Option<BodyId> {
        let mut roots = self.body_ids().filter(|body| self.lower(*body).is_none());
        roots.next().filter(|_| roots.next().is_none())
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
                names[coordinate.index()] = body.joint.name_of(kind.name(), is_only);
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
                names[speed.index()] = joint.name_of(kinds[motion], is_only) + suffix;
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

    /// The pairs of speeds whose motions depend on which comes first, `[row, column]` with
    /// `column < row`: turns about axes of one body.
    pub fn order_dependent_turns(&self) -> BTreeSet<[usize; 2]> {
        let mut pairs = BTreeSet::new();
        for body in &self.bodies {
            if let Some(speeds) = body.joint.angular_velocity() {
                let [a, b, c] = speeds.map(SpeedId::index);
                pairs.extend([[a, b], [a, c], [b, c]].map(|[i, j]| [i.max(j), i.min(j)]));
            }
        }
        pairs
    }

    /// How many bodies it has with all that is fixed to them.
    pub fn n_parts(&self) -> usize {
        self.bodies.iter().map(|body| body.parts.len()).sum()
    }

    /// True where the weights of some bodies are lifted, and not those of all alike.
    pub fn lifts_some(&self) -> bool {
        let mut parts = self.bodies.iter().flat_map(|body| &body.parts);
        parts.any(RigidPart::is_lifted)
    }

    /// The same with nothing lifted of all bodies alike.
    pub(crate) fn with_whole_weights(&self) -> Cow<'_, Self> {
        if self.lifted == 0.0 {
            return Cow::Borrowed(self);
        }
        Cow::Owned(Self {
            lifted: 0.0,
            ..self.clone()
        })
    }

    /// True where a coordinate follows another: one speed then moves several joints.
    pub fn has_followers(&self) -> bool {
        let follows = |joint: &Joint, motion| {
            matches!(joint.coordinate_of(motion), Some(Coordinate::Mimic { .. }))
        };
        let mut joints = self.bodies.iter().map(|body| &body.joint);
        joints.any(|joint| (0..6).any(|motion| follows(joint, motion)))
    }

    /// The bodies whose orientation is described by a quaternion, each with its four coordinates.
    pub fn quaternions(&self) -> impl Iterator<Item = (&Body, [CoordinateId; 4])> {
        let bodies = self.bodies.iter();
        bodies.filter_map(|body| Some((body, body.joint.euler_parameters()?)))
    }

    /// Coordinates that are all zero, but for quaternions, which are no rotation.
    pub fn neutral(&self) -> Vec<f64> {
        let mut q = vec![0.0; self.n_coordinates];
        for (_, [scalar, ..]) in self.quaternions() {
            q[scalar.index()] = 1.0;
        }
        q
    }

    /// True where some orientation is described by a quaternion.
    pub fn has_quaternions(&self) -> bool {
        self.quaternions().next().is_some()
    }

    /// The nominal value of a number of the description.
    pub fn nominal(&self, value: Value) -> f64 {
        value.nominal(&self.parameters)
    }
}
