//! Where a frame is and how it moves, joint by joint along its path alone.
//!
//! In: a tree, a plan, a frame that has a name. Out: expressions equal to those of [`kane::frame`](crate::kane::frame). What is
//! along inertial axes passes inward: it arrives in inertial components, and no rotation of a body is needed for it. What is
//! along the frame's own axes passes outward.

use super::{
    link::{self, Link},
    passage::{Drive, Passenger},
    plan::Plan,
    rotation::Turn,
};
use crate::{
    expr::{ExprGraph, Matrix, Vector},
    given::{self, FramePose, FrameVelocity, frame_origin, frame_rotation},
    id::{BodyId, BodyMap},
    tree::{Motion, NamedFrame, Tree},
};

/// The frame in the inertial one.
pub fn pose(graph: &mut ExprGraph, tree: &Tree, plan: &Plan, frame: NamedFrame) -> FramePose {
    let links = link::links(graph, tree, plan);
    let mut reach = Reach::of(graph, tree, &links, frame);
    for body in path(tree, frame) {
        graph.enter(body);
        if tree.lower(body).is_none() {
            // A root's link may stand elsewhere on its axis: from here on the body's own origin is meant.
            let zero = graph.zero_vector();
            let origin = links[body].point_of_body(graph, zero);
            reach.position = graph.sub_vectors(reach.position, origin);
        }
        links[body].passage.inward(graph, &mut reach);
        if tree.lower(body).is_none() {
            let offset = given::offset(graph, tree.body(body));
            reach.position = graph.add_vectors(reach.position, offset);
        }
        graph.name_vector(reach.position, "reach");
    }
    FramePose {
        rotation: reach.axes,
        position: reach.position,
    }
}

/// Its velocity in the inertial frame, inertial components.
pub fn velocity(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    frame: NamedFrame,
) -> FrameVelocity {
    let links = link::links(graph, tree, plan);
    let Reach { position, .. } = Reach::of(graph, tree, &links, frame);
    let mut seen = Seen {
        linear: graph.zero_vector(),
        angular: graph.zero_vector(),
        position,
    };
    for body in path(tree, frame) {
        graph.enter(body);
        links[body].passage.inward(graph, &mut seen);
        graph.name_vector(seen.linear, "seen_v");
        graph.name_vector(seen.angular, "seen_w");
    }
    FrameVelocity {
        linear: seen.linear,
        angular: seen.angular,
    }
}

/// The same, components along the frame's own axes.
pub fn local_velocity(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    frame: NamedFrame,
) -> FrameVelocity {
    let links = link::links(graph, tree, plan);
    let mut carried = Carried {
        linear: graph.zero_vector(),
        angular: graph.zero_vector(),
    };
    for body in path(tree, frame).into_iter().rev() {
        graph.enter(body);
        links[body].passage.outward(graph, &mut carried);
        graph.name_vector(carried.linear, "v_o");
        graph.name_vector(carried.angular, "w");
    }
    let Carried { linear, angular } = carried;
    let Reach { axes, position } = Reach::of(graph, tree, &links, frame);
    let swept = graph.cross(angular, position);
    let linear = graph.add_vectors(linear, swept);
    FrameVelocity {
        linear: graph.mul_vector(&axes, linear),
        angular: graph.mul_vector(&axes, angular),
    }
}

/// The bodies on the path of a frame, from the one that holds it inward.
fn path(tree: &Tree, frame: NamedFrame) -> Vec<BodyId> {
    let body = tree.frame_body(frame);
    body.into_iter().flat_map(|body| tree.path(body)).collect()
}

/// A frame as it stands in the axes, and from the origin, that have been reached inward.
struct Reach {
    /// To the frame's axes, by rows.
    axes: Matrix,
    position: Vector,
}

impl Reach {
    /// In the link that holds the frame.
    fn of(graph: &mut ExprGraph, tree: &Tree, links: &BodyMap<Link>, frame: NamedFrame) -> Self {
        let axes = frame_rotation(graph, tree, frame);
        let position = frame_origin(graph, tree, frame);
        match tree.frame_body(frame) {
            None => Self { axes, position },
            Some(body) => Self {
                axes: axes.map(|row| links[body].of_body(graph, row)),
                position: links[body].point_of_body(graph, position),
            },
        }
    }
}

impl Passenger for Reach {
    fn shift(&mut self, graph: &mut ExprGraph, _: BodyId, offset: Vector) {
        self.position = graph.add_vectors(self.position, offset);
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, _: Drive) {
        self.axes = self.axes.map(|row| rotation.backward(graph, row));
        self.position = rotation.backward(graph, self.position);
    }

    fn along(&mut self, _: &mut ExprGraph, _: [Option<Motion>; 3]) {}
}

/// The velocity of a frame as it is seen from the link that has been reached inward.
struct Seen {
    linear: Vector,
    angular: Vector,
    /// Of the frame's origin, from the link's.
    position: Vector,
}

impl Passenger for Seen {
    fn shift(&mut self, graph: &mut ExprGraph, _: BodyId, offset: Vector) {
        self.position = graph.add_vectors(self.position, offset);
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive) {
        let rates = rates(graph, drive.motions());
        let swept = graph.cross(rates, self.position);
        self.linear = graph.add_vectors(self.linear, swept);
        self.angular = graph.add_vectors(self.angular, rates);
        for vector in [&mut self.linear, &mut self.angular, &mut self.position] {
            *vector = rotation.backward(graph, *vector);
        }
    }

    fn along(&mut self, graph: &mut ExprGraph, motions: [Option<Motion>; 3]) {
        let rates = rates(graph, motions);
        self.linear = graph.add_vectors(self.linear, rates);
    }
}

/// The velocity of the link that has been reached outward, in its own axes.
struct Carried {
    /// Of its origin.
    linear: Vector,
    angular: Vector,
}

impl Passenger for Carried {
    fn shift(&mut self, graph: &mut ExprGraph, _: BodyId, offset: Vector) {
        let swept = graph.cross(self.angular, offset);
        self.linear = graph.add_vectors(self.linear, swept);
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive) {
        self.linear = rotation.forward(graph, self.linear);
        self.angular = rotation.forward(graph, self.angular);
        let rates = rates(graph, drive.motions());
        self.angular = graph.add_vectors(self.angular, rates);
    }

    fn along(&mut self, graph: &mut ExprGraph, motions: [Option<Motion>; 3]) {
        let rates = rates(graph, motions);
        self.linear = graph.add_vectors(self.linear, rates);
    }
}

fn rates(graph: &mut ExprGraph, motions: [Option<Motion>; 3]) -> Vector {
    motions.map(|motion| given::speed(graph, motion))
}
