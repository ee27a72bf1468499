//! Poses as the user of a body sees them: along the user's axes, from the user's origin.

use std::collections::BTreeMap;

use crate::geometry::{self, Rotation, Vector};
use crate::id::{BodyId, ParameterId};
use crate::tree::body::Pose;
use crate::tree::offset::Offset;
use crate::tree::rotations::snapped;
use crate::tree::system::Tree;
use crate::tree::value::{Parameter, Value};

impl Tree {
    /// The user's axes and origin of a body, or of the inertial frame.
    pub(crate) fn user_pose(&self, body: Option<BodyId>) -> Pose {
        body.map_or_else(Pose::internal, |body| self.body(body).pose.clone())
    }
}

impl Pose {
    /// From the axes of `base`, in the same body, to these.
    pub(crate) fn rotation_from(&self, base: &Self, snap: f64) -> Rotation {
        from_axes(base, &self.rotation, snap)
    }

    /// From the origin of `base` to this one, along the axes of `base`, m; at the nominal values.
    pub(crate) fn position_from(&self, base: &Self, parameters: &[Parameter]) -> Vector {
        geometry::apply(&base.rotation, self.offset_from(base).nominal(parameters))
    }

    /// The values set at run time on which that position depends, and how far a unit of each moves it: it is linear in them.
    pub(crate) fn moved_by(&self, base: &Self, snap: f64) -> Vec<(ParameterId, Vector)> {
        let mut moved: BTreeMap<ParameterId, Vector> = BTreeMap::new();
        for step in self.offset_from(base).steps() {
            let axes = from_axes(base, &step.rotation, snap);
            let sign = if step.negative { -1.0 } else { 1.0 };
            for (value, axis) in step.vector.into_iter().zip(axes) {
                if let Value::Runtime(parameter) = value {
                    let sum = moved.entry(parameter).or_default();
                    *sum = geometry::sum(*sum, geometry::scaled(axis, sign));
                }
            }
        }
        // What leads to the user's origin and back moves nothing.
        moved.retain(|_, sum| *sum != [0.0; 3]);
        moved.into_iter().collect()
    }

    /// From the origin of `base` to this one, internal axes.
    fn offset_from(&self, base: &Self) -> Offset {
        self.origin.clone().join(&base.origin, true)
    }
}

/// From the axes of `base` to those to which `rotation` leads from the internal ones.
fn from_axes(base: &Pose, rotation: &Rotation, snap: f64) -> Rotation {
    let back = geometry::transposed(&base.rotation);
    snapped(&geometry::then(&back, rotation), snap).0
}
