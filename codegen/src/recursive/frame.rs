//! Where a frame is and how it moves, joint by joint along its path alone.
//!
//! In: a tree, a frame that has a name. Out: expressions equal to those of [`kane::frame`](crate::kane::frame). What is along
//! inertial axes passes inward: from the frame to the joint that holds it, through that to the lower body, and so on, so
//! that it arrives in inertial components and no rotation of a body is needed for it. What is along the frame's own axes
//! passes outward.

use crate::{
    expr::{ExprGraph, Matrix, Vector, transpose},
    given,
    id::BodyId,
    kane::{
        angular,
        frame::{Pose, Twist, own_origin, own_rotation},
    },
    tree::{Body, NamedFrame, Tree},
};

/// The rotations of a joint: the turn about its axes, and the constant one before it.
struct Passage {
    turned: Matrix,
    constant: Matrix,
}

impl Passage {
    fn of(graph: &mut ExprGraph, tree: &Tree, body: &Body) -> Self {
        Self {
            turned: given::orientation::of_joint(graph, tree, &body.joint),
            constant: given::constant(graph, &body.joint.rotation),
        }
    }

    /// Components along the joint's axes, before the turn, to components in the body.
    fn turn(&self, graph: &mut ExprGraph, v: Vector) -> Vector {
        graph.mul_vector(&self.turned, v)
    }

    /// Body components to components along the joint's axes in the lower body.
    fn back(&self, graph: &mut ExprGraph, v: Vector) -> Vector {
        graph.mul_vector(&transpose(&self.turned), v)
    }

    /// Components along the joint's axes in the lower body to the lower body's.
    fn lower(&self, graph: &mut ExprGraph, v: Vector) -> Vector {
        graph.mul_vector(&transpose(&self.constant), v)
    }
}

/// The bodies on the path of a frame, from the one that holds it inward.
fn path(tree: &Tree, frame: NamedFrame) -> Vec<BodyId> {
    let body = tree.frame_body(frame);
    body.into_iter().flat_map(|body| tree.path(body)).collect()
}

/// `R <- R JR_K` and `r <- JR_K^T r + q_K + s_K`.
pub fn pose(graph: &mut ExprGraph, tree: &Tree, frame: NamedFrame) -> Pose {
    let mut rotation = own_rotation(graph, tree, frame);
    let mut position = own_origin(graph, tree, frame);
    for id in path(tree, frame) {
        graph.enter(id);
        let body = tree.body(id);
        let passage = Passage::of(graph, tree, body);
        rotation = graph.mul_matrices(&rotation, &passage.turned);
        rotation = graph.mul_matrices(&rotation, &passage.constant);
        position = lowered(graph, body, &passage, position);
    }
    Pose { rotation, position }
}

/// The position of the frame from the lower body's origin, of that from the body's.
fn lowered(graph: &mut ExprGraph, body: &Body, passage: &Passage, position: Vector) -> Vector {
    let turned = passage.back(graph, position);
    let shifts = body.joint.translations;
    let shifts = shifts.map(|shift| given::coordinate(graph, shift));
    let along = graph.add_vectors(turned, shifts);
    let along = passage.lower(graph, along);
    let attachment = given::attachment(graph, &body.joint);
    let position = graph.add_vectors(along, attachment);
    graph.name_vector(position, "reach");
    position
}

/// The velocity of the frame as seen from each body on its path, inward: `w <- JR_K^T (w + w_rel_K)` and
/// `v <- JR_K^T (v + tilde(w_rel_K) r) + s_dot_K`.
pub fn velocity(graph: &mut ExprGraph, tree: &Tree, frame: NamedFrame) -> Twist {
    let mut position = own_origin(graph, tree, frame);
    let (mut linear, mut angular) = (graph.zero_vector(), graph.zero_vector());
    for id in path(tree, frame) {
        graph.enter(id);
        let body = tree.body(id);
        let passage = Passage::of(graph, tree, body);
        let w_rel = angular::relative_velocity_of(graph, tree, id);
        let swept = graph.cross(w_rel, position);
        linear = graph.add_vectors(linear, swept);
        linear = passage.back(graph, linear);
        let shifts = given::shift_speeds(graph, &body.joint);
        linear = graph.add_vectors(linear, shifts);
        linear = passage.lower(graph, linear);
        graph.name_vector(linear, "seen_v");
        angular = graph.add_vectors(angular, w_rel);
        angular = passage.back(graph, angular);
        angular = passage.lower(graph, angular);
        graph.name_vector(angular, "seen_w");
        position = lowered(graph, body, &passage, position);
    }
    Twist { linear, angular }
}

/// The velocity along the frame's own axes, outward: Eqs. (11) and (25) through each joint's rotations one by one.
pub fn local_velocity(graph: &mut ExprGraph, tree: &Tree, frame: NamedFrame) -> Twist {
    let (mut linear, mut angular) = (graph.zero_vector(), graph.zero_vector());
    for id in path(tree, frame).into_iter().rev() {
        graph.enter(id);
        let body = tree.body(id);
        let passage = Passage::of(graph, tree, body);
        let offset = given::offset(graph, body);
        let swept = graph.cross(angular, offset);
        linear = graph.add_vectors(linear, swept);
        linear = graph.mul_vector(&passage.constant, linear);
        let shifts = given::shift_speeds(graph, &body.joint);
        linear = graph.add_vectors(linear, shifts);
        linear = passage.turn(graph, linear);
        graph.name_vector(linear, "v_o");
        angular = graph.mul_vector(&passage.constant, angular);
        angular = passage.turn(graph, angular);
        let w_rel = angular::relative_velocity_of(graph, tree, id);
        angular = graph.add_vectors(angular, w_rel);
        graph.name_vector(angular, "w");
    }
    let own = own_rotation(graph, tree, frame);
    let origin = own_origin(graph, tree, frame);
    let swept = graph.cross(angular, origin);
    linear = graph.add_vectors(linear, swept);
    Twist {
        linear: graph.mul_vector(&own, linear),
        angular: graph.mul_vector(&own, angular),
    }
}
