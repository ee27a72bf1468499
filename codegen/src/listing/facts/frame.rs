//! Frames of the model that have names and are no bodies.

use crate::{
    geometry::Rotation,
    id::BodyId,
    tree::{self, Pose, Tree, Value},
};

/// A frame of the model that is part of a body, or marks a place there.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// Its name, as the user wrote it.
    pub name: String,
    /// What stands for it in names.
    pub identifier: String,
    /// The body, by its place; `None` is the inertial frame.
    pub body: Option<usize>,
    /// From the body's axes to the frame's; at the nominal values.
    pub rotation: Rotation,
    /// From the body's origin to the frame's, the body's axes, m; at the nominal values.
    pub position: [f64; 3],
    /// What moves it at run time.
    pub moved: Vec<Moved>,
    /// What turns it at run time.
    pub turned: Option<Turned>,
}

/// A value set at run time that moves a point.
#[derive(Clone, Debug, PartialEq)]
pub struct Moved {
    /// The parameter's name.
    pub parameter: String,
    /// How far a unit of it moves the point.
    pub along: [f64; 3],
}

/// A rotation that is set at run time.
#[derive(Clone, Debug, PartialEq)]
pub struct Turned {
    /// The names of the parameters that hold its matrix, by rows.
    pub parameters: [[String; 3]; 3],
    /// From the body's axes to those from which it turns.
    pub after: Rotation,
}

impl Frame {
    pub(super) fn of(tree: &Tree, frame: &tree::Frame) -> Self {
        let base = tree.user_pose(frame.body);
        Self {
            name: frame.name.clone(),
            identifier: frame.identifier.clone(),
            body: frame.body.map(BodyId::index),
            rotation: frame.rotation,
            position: frame.position,
            moved: moved(tree, &frame.pose, &base),
            turned: frame.turn.map(|rows| Turned {
                parameters: rows.map(|row| row.map(|value| name(tree, value))),
                after: frame.pose.rotation_from(&base, tree.snap),
            }),
        }
    }
}

/// What moves the origin of `pose` as it is seen from `base`.
pub(super) fn moved(tree: &Tree, pose: &Pose, base: &Pose) -> Vec<Moved> {
    let moved = pose.moved_by(base, tree.snap).into_iter();
    let moved = moved.map(|(parameter, along)| Moved {
        parameter: tree.parameters[parameter.index()].name.clone(),
        along,
    });
    moved.collect()
}

/// The name of a parameter; of a number, which no entry of a rotation that is set at run time is, its digits.
fn name(tree: &Tree, value: Value) -> String {
    match value {
        Value::Runtime(parameter) => tree.parameters[parameter.index()].name.clone(),
        Value::Baked(number) => format!("{number:?}"),
    }
}
