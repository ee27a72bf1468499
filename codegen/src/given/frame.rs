//! Frames that have names: where they are in the bodies that hold them, and what can be said of them elsewhere.

use super::numbers::{constant, fixed, vector};
use crate::{
    expr::{ExprGraph, Matrix, Vector},
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

/// How a frame moves in the inertial one.
#[derive(Clone, Copy, Debug)]
pub struct FrameVelocity {
    /// Velocity of its origin.
    pub linear: Vector,
    /// Angular velocity.
    pub angular: Vector,
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

/// From the internal origin of the body that holds a frame to the frame's, internal axes.
pub fn frame_origin(graph: &mut ExprGraph, tree: &Tree, frame: NamedFrame) -> Vector {
    graph.enter(tree.frame_body(frame));
    fixed(graph, &tree.frame_pose(frame).origin)
}
