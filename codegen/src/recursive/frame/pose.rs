//! Where a frame is.

use super::{between::Between, levers, steps};
use crate::{
    expr::{ExprGraph, Matrix, Purpose, Vector},
    given::FramePose,
    id::{BodyId, BodyMap},
    recursive::{
        links::{
            link::{self, Link},
            passage::{Drive, Passenger},
            rotation::Turn,
        },
        plan::Plan,
        technique::Technique,
    },
    tree::{Motion, NamedFrame, Tree},
};

/// The operations of a cross product.
const CROSS: usize = 9;

/// The frame as it is seen from another, or from the inertial one.
pub fn pose(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    frame: NamedFrame,
    from: Option<NamedFrame>,
) -> FramePose {
    let links = link::massless(graph, tree, plan);
    graph.begin(Purpose::Frame);
    match from {
        None if plan.uses(Technique::Inward) => inward(graph, tree, &links, frame),
        _ if plan.uses(Technique::Levers) => levers::pose(graph, tree, &links, frame, from),
        _ => steps::pose(graph, tree, &links, frame, from),
    }
}

/// As it is seen from the inertial frame, all of it carried inward.
fn inward(
    graph: &mut ExprGraph,
    tree: &Tree,
    links: &BodyMap<Link>,
    frame: NamedFrame,
) -> FramePose {
    let (way, reach) = Between::aligned(graph, tree, links, frame, None);
    let mut carried = Carried {
        axes: reach.axes,
        n_last: 0,
        position: reach.position,
    };
    for &body in &way.ahead {
        way.inward(graph, body, &mut carried);
        graph.name_vector(carried.position, "reach");
    }
    let [x, y, mut z] = carried.axes;
    // Of rows that are orthonormal, whatever is set at run time.
    if tree.frame_turn(frame).is_none() && carried.n_last > CROSS {
        z = graph.cross(x, y);
    }
    FramePose {
        rotation: [x, y, z],
        position: carried.position,
    }
}

/// A frame as it stands in the axes, and from the origin, that have been reached inward.
struct Carried {
    /// To the frame's axes, by rows.
    axes: Matrix,
    /// How many operations the last row alone has needed.
    n_last: usize,
    position: Vector,
}

impl Passenger for Carried {
    fn shift(&mut self, graph: &mut ExprGraph, _: BodyId, offset: Vector) {
        self.position = graph.add_vectors(self.position, offset);
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, _: Drive) {
        let [x, y, z] = self.axes;
        let [x, y] = [x, y].map(|row| rotation.backward(graph, row));
        let before = graph.len();
        let z = rotation.backward(graph, z);
        self.n_last += graph.len() - before;
        self.axes = [x, y, z];
        self.position = rotation.backward(graph, self.position);
    }

    fn along(&mut self, _: &mut ExprGraph, _: [Option<Motion>; 3]) {}
}
