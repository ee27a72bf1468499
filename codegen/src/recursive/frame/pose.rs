//! Where a frame is.

use super::{
    reach::{Reach, path},
    seen,
};
use crate::{
    expr::{ExprGraph, Matrix, Purpose, Vector},
    given::FramePose,
    id::{BodyId, BodyMap},
    recursive::{
        links::{
            link::{self, Link},
            passage::{Drive, Passenger},
            root,
            rotation::Turn,
        },
        plan::{Plan, Technique},
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
    if from.is_some() || !plan.uses(Technique::Inward) {
        return seen::pose(graph, tree, plan, frame, from);
    }
    let links = link::massless(graph, tree, plan);
    graph.begin(Purpose::Frame);
    let mut carried = Carried::of(graph, tree, &links, frame);
    for (place, body) in path(tree, frame).into_iter().enumerate() {
        graph.enter(body);
        let link = &links[body];
        let phased = link.phased(graph, &carried.axes).filter(|_| place == 0);
        let passage = match phased {
            None => link.passage.clone(),
            Some(phased) => {
                carried.axes = phased.axes;
                carried.position = phased.turn.forward(graph, carried.position);
                phased.passage
            }
        };
        passage.inward(graph, &mut carried);
        if tree.lower(body).is_none() {
            let origin = root::origin(graph, tree, link, body);
            carried.position = graph.add_vectors(carried.position, origin);
        }
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

impl Carried {
    fn of(graph: &mut ExprGraph, tree: &Tree, links: &BodyMap<Link>, frame: NamedFrame) -> Self {
        let Reach { axes, position } = Reach::of(graph, tree, links, frame);
        Self {
            axes,
            n_last: 0,
            position,
        }
    }
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
