//! Frames that have names: where they are in the bodies that hold them, and what can be said of them elsewhere.

use super::numbers::{constant, fixed, vector};
use crate::{
    expr::{ExprGraph, Input, Matrix, Vector},
    tree::{NamedFrame, Tree},
};

/// Where a frame is.
#[derive(Clone, Copy, Debug)]
pub struct FramePose {
    /// Inertial components to components along the frame's axes.
    pub rotation: Matrix,
    /// From the inertial origin to the frame's, inertial components.
    pub position: Vector,
}

/// How a frame moves: its velocity or acceleration, or what a unit speed contributes to it.
#[derive(Clone, Copy, Debug)]
pub struct FrameMotion {
    /// Of its origin.
    pub linear: Vector,
    /// Angular.
    pub angular: Vector,
}

/// What acts on a frame.
#[derive(Clone, Copy, Debug)]
pub struct FrameWrench {
    /// At its origin.
    pub force: Vector,
    /// About it.
    pub moment: Vector,
}

/// From the internal axes of the body that holds a frame to the frame's.
pub fn frame_rotation(graph: &mut ExprGraph, tree: &Tree, frame: NamedFrame) -> Matrix {
    graph.enter(tree.frame_body(frame));
    let baked = constant(graph, &tree.frame_pose(frame).rotation);
    let Some(turn) = tree.frame_turn(frame) else {
        return baked;
    };
    let turn = turn.map(|row| vector(graph, row));
    graph.mul_matrices(&turn, &baked)
}

/// The force and the moment that a frame is given.
pub fn frame_wrench(graph: &mut ExprGraph) -> FrameWrench {
    let moment = [0, 1, 2].map(|axis| graph.input(Input::FrameMoment(axis)));
    FrameWrench {
        moment,
        ..frame_force(graph)
    }
}

/// The force that a frame is given, without a moment.
pub fn frame_force(graph: &mut ExprGraph) -> FrameWrench {
    FrameWrench {
        force: [0, 1, 2].map(|axis| graph.input(Input::FrameForce(axis))),
        moment: graph.zero_vector(),
    }
}

/// The position of a point that a frame is given, from its origin, along its axes.
pub fn frame_point(graph: &mut ExprGraph) -> Vector {
    [0, 1, 2].map(|axis| graph.input(Input::Point(axis)))
}

/// From the internal origin of the body that holds a frame to the frame's, internal axes.
pub fn frame_origin(graph: &mut ExprGraph, tree: &Tree, frame: NamedFrame) -> Vector {
    graph.enter(tree.frame_body(frame));
    fixed(graph, &tree.frame_pose(frame).origin)
}
