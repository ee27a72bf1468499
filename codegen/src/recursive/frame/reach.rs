//! A frame in the link that holds it.

use crate::{
    expr::{ExprGraph, Matrix, Vector, transpose},
    given::{FrameMotion, frame_origin, frame_rotation},
    id::{BodyId, BodyMap},
    recursive::links::link::Link,
    tree::{Motion, NamedFrame, Tree},
};

/// Where a frame stands in its link; of the inertial frame, there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Reach {
    /// To the frame's axes, by rows.
    pub(super) axes: Matrix,
    /// Of its origin, from the link's.
    pub(super) position: Vector,
}

impl Reach {
    pub(super) fn of(
        graph: &mut ExprGraph,
        tree: &Tree,
        links: &BodyMap<Link>,
        frame: NamedFrame,
    ) -> Self {
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

    /// The position of a point that the frame is given, or of its origin.
    pub(super) fn of_point(&self, graph: &mut ExprGraph, point: Option<Vector>) -> Vector {
        let Some(point) = point else {
            return self.position;
        };
        let step = graph.mul_vector(&transpose(&self.axes), point);
        graph.add_vectors(self.position, step)
    }
}

/// What a unit of each motion's speed contributes to a frame's motion.
pub(super) type Contributions = Vec<(Motion, FrameMotion)>;

/// The bodies on the path of a frame, from the one that holds it inward.
pub(super) fn path(tree: &Tree, frame: NamedFrame) -> Vec<BodyId> {
    let body = tree.frame_body(frame);
    body.into_iter().flat_map(|body| tree.path(body)).collect()
}
