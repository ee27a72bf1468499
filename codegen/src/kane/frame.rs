//! Frames that have names: where they are and how they move, from Eqs. (3), (11), (22) and (25).

use super::{
    orientation, position,
    velocity::{self, Rotational},
};
use crate::{
    expr::{ExprGraph, Matrix, Vector, transpose},
    given,
    tree::{NamedFrame, Tree},
};

/// Where a frame is.
#[derive(Clone, Copy, Debug)]
pub struct Pose {
    /// Inertial components to components along the frame's axes.
    pub rotation: Matrix,
    /// From the inertial origin to the frame's, inertial components.
    pub position: Vector,
}

/// How a frame moves in the inertial one.
#[derive(Clone, Copy, Debug)]
pub struct Twist {
    /// Velocity of its origin.
    pub linear: Vector,
    /// Angular velocity.
    pub angular: Vector,
}

/// From the internal axes of the body that holds a frame to the frame's.
pub fn own_rotation(graph: &mut ExprGraph, tree: &Tree, frame: NamedFrame) -> Matrix {
    graph.enter(tree.frame_body(frame));
    let constant = given::constant(graph, &tree.frame_pose(frame).rotation);
    let Some(turn) = tree.frame_turn(frame) else {
        return constant;
    };
    let turn = turn.map(|row| given::vector(graph, row));
    graph.mul_matrices(&turn, &constant)
}

/// From the internal origin of the body that holds a frame to the frame's, internal axes.
pub fn own_origin(graph: &mut ExprGraph, tree: &Tree, frame: NamedFrame) -> Vector {
    graph.enter(tree.frame_body(frame));
    given::fixed(graph, &tree.frame_pose(frame).origin)
}

/// `R_F = A_F R_K`, and `R_K^T (p_O_K + o_F)`.
pub fn pose(graph: &mut ExprGraph, tree: &Tree, frame: NamedFrame) -> Pose {
    let own = own_rotation(graph, tree, frame);
    let origin = own_origin(graph, tree, frame);
    let Some(body) = tree.frame_body(frame) else {
        return Pose {
            rotation: own,
            position: origin,
        };
    };
    let relative = orientation::relative(graph, tree);
    let absolute = orientation::absolute(graph, tree, &relative);
    let origins = position::origin(graph, tree, &relative);
    graph.enter(body);
    let position = graph.add_vectors(origins[body], origin);
    Pose {
        rotation: graph.mul_matrices(&own, &absolute[body]),
        position: graph.mul_vector(&transpose(&absolute[body]), position),
    }
}

/// `R_K^T` times the velocities along the internal axes: inertial components.
pub fn velocity(graph: &mut ExprGraph, tree: &Tree, frame: NamedFrame) -> Twist {
    let rotational = velocity::rotational(graph, tree);
    let Twist { linear, angular } = in_body(graph, tree, frame, &rotational);
    let Some(body) = tree.frame_body(frame) else {
        return Twist { linear, angular };
    };
    let absolute = orientation::absolute(graph, tree, &rotational.relative);
    graph.enter(body);
    let back = transpose(&absolute[body]);
    Twist {
        linear: graph.mul_vector(&back, linear),
        angular: graph.mul_vector(&back, angular),
    }
}

/// The same, components along the frame's own axes.
pub fn local_velocity(graph: &mut ExprGraph, tree: &Tree, frame: NamedFrame) -> Twist {
    let rotational = velocity::rotational(graph, tree);
    let Twist { linear, angular } = in_body(graph, tree, frame, &rotational);
    let own = own_rotation(graph, tree, frame);
    Twist {
        linear: graph.mul_vector(&own, linear),
        angular: graph.mul_vector(&own, angular),
    }
}

/// `JR_K v_O_K + tilde(w_K) o_F` and `w_K`: components along the internal axes of the body that holds the frame.
fn in_body(
    graph: &mut ExprGraph,
    tree: &Tree,
    frame: NamedFrame,
    rotational: &Rotational,
) -> Twist {
    let Some(body) = tree.frame_body(frame) else {
        let zero = graph.zero_vector();
        return Twist {
            linear: zero,
            angular: zero,
        };
    };
    let origins = velocity::origin(graph, tree, rotational);
    let origin = own_origin(graph, tree, frame);
    let carried = graph.mul_vector(&rotational.relative[body], origins[body]);
    let turned = graph.cross(rotational.w[body], origin);
    Twist {
        linear: graph.add_vectors(carried, turned),
        angular: rotational.w[body],
    }
}
