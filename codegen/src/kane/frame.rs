//! Frames that have names: where they are and how they move, from Eqs. (3), (11), (22) and (25).

use super::{
    orientation, position,
    velocity::{self, Rotational},
};
use crate::{
    expr::{ExprGraph, transpose},
    given::{FramePose, FrameVelocity, frame_origin, frame_rotation},
    tree::{NamedFrame, Tree},
};

/// `R_F = A_F R_K`, and `R_K^T (p_O_K + o_F)`.
pub fn pose(graph: &mut ExprGraph, tree: &Tree, frame: NamedFrame) -> FramePose {
    let own = frame_rotation(graph, tree, frame);
    let origin = frame_origin(graph, tree, frame);
    let Some(body) = tree.frame_body(frame) else {
        return FramePose {
            rotation: own,
            position: origin,
        };
    };
    let relative = orientation::relative(graph, tree);
    let absolute = orientation::absolute(graph, tree, &relative);
    let origins = position::origin(graph, tree, &relative);
    graph.enter(body);
    let position = graph.add_vectors(origins[body], origin);
    FramePose {
        rotation: graph.mul_matrices(&own, &absolute[body]),
        position: graph.mul_vector(&transpose(&absolute[body]), position),
    }
}

/// `R_K^T` times the velocities along the internal axes: inertial components.
pub fn velocity(graph: &mut ExprGraph, tree: &Tree, frame: NamedFrame) -> FrameVelocity {
    let rotational = velocity::rotational(graph, tree);
    let FrameVelocity { linear, angular } = in_body(graph, tree, frame, &rotational);
    let Some(body) = tree.frame_body(frame) else {
        return FrameVelocity { linear, angular };
    };
    let absolute = orientation::absolute(graph, tree, &rotational.relative);
    graph.enter(body);
    let back = transpose(&absolute[body]);
    FrameVelocity {
        linear: graph.mul_vector(&back, linear),
        angular: graph.mul_vector(&back, angular),
    }
}

/// The same, components along the frame's own axes.
pub fn local_velocity(graph: &mut ExprGraph, tree: &Tree, frame: NamedFrame) -> FrameVelocity {
    let rotational = velocity::rotational(graph, tree);
    let FrameVelocity { linear, angular } = in_body(graph, tree, frame, &rotational);
    let own = frame_rotation(graph, tree, frame);
    FrameVelocity {
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
) -> FrameVelocity {
    let Some(body) = tree.frame_body(frame) else {
        let zero = graph.zero_vector();
        return FrameVelocity {
            linear: zero,
            angular: zero,
        };
    };
    let origins = velocity::origin(graph, tree, rotational);
    let origin = frame_origin(graph, tree, frame);
    let carried = graph.mul_vector(&rotational.relative[body], origins[body]);
    let turned = graph.cross(rotational.w[body], origin);
    FrameVelocity {
        linear: graph.add_vectors(carried, turned),
        angular: rotational.w[body],
    }
}
