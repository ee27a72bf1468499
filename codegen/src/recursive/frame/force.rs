//! Generalized forces of a wrench on a frame: what its motions read off it, without their directions.

use super::reach::{Reach, path};
use crate::{
    expr::{Expr, ExprGraph, Purpose, Vector, transpose},
    given::FrameWrench,
    id::BodyId,
    recursive::{
        forces::inverse_dynamics::Acting,
        links::{
            link,
            passage::{Drive, Passenger},
            rotation::Turn,
            wrench::{self, Wrench},
        },
        plan::Plan,
    },
    tree::{Motion, NamedFrame, Tree},
};

/// `J^T` of a wrench at the frame's origin, inertial components: it passes outward, as gravity does, and the lever inward.
pub fn generalized_force(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    frame: NamedFrame,
    wrench: FrameWrench,
) -> Vec<Expr> {
    let links = link::massless(graph, tree, plan);
    graph.begin(Purpose::FrameForce);
    let path = path(tree, frame);
    let mut coming = Coming {
        wrench: Wrench::from(wrench),
        at_motions: Vec::new(),
    };
    for &body in path.iter().rev() {
        graph.enter(body);
        links[body].passage.outward(graph, &mut coming);
        graph.name_vector(coming.wrench.force, "f");
        graph.name_vector(coming.wrench.moment, "n");
    }
    let mut tau = vec![graph.zero(); tree.n_speeds];
    let mut lever = Lever {
        position: Reach::of(graph, tree, &links, frame).position,
        wrenches: coming.at_motions,
        tau: &mut tau,
    };
    for body in path {
        graph.enter(body);
        links[body].passage.inward(graph, &mut lever);
        graph.name_vector(lever.position, "lever");
    }
    tau
}

/// `J^T` of a wrench at the frame's origin, components along its own axes: it passes inward.
pub fn local_generalized_force(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    frame: NamedFrame,
    wrench: FrameWrench,
) -> Vec<Expr> {
    let links = link::massless(graph, tree, plan);
    graph.begin(Purpose::FrameForce);
    let Reach { axes, position } = Reach::of(graph, tree, &links, frame);
    let back = transpose(&axes);
    let wrench = Wrench::from(wrench).map(|v| graph.mul_vector(&back, v));
    let mut tau = vec![graph.zero(); tree.n_speeds];
    let mut acting = Acting {
        wrench: wrench.moved(graph, position),
        tau: &mut tau,
    };
    for body in path(tree, frame) {
        graph.enter(body);
        graph.name_vector(acting.wrench.force, "f");
        graph.name_vector(acting.wrench.moment, "n");
        links[body].passage.inward(graph, &mut acting);
    }
    tau
}

impl From<FrameWrench> for Wrench {
    fn from(FrameWrench { force, moment }: FrameWrench) -> Self {
        Self { force, moment }
    }
}

/// A wrench that is given, on its way outward.
struct Coming {
    /// Along the axes that have been reached.
    wrench: Wrench,
    /// The same wherever motions enter, in the order of the way.
    at_motions: Vec<Wrench>,
}

impl Passenger for Coming {
    fn shift(&mut self, _: &mut ExprGraph, _: BodyId, _: Vector) {}

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, _: Drive) {
        self.wrench = self.wrench.map(|v| rotation.forward(graph, v));
        self.at_motions.push(self.wrench);
    }

    fn along(&mut self, _: &mut ExprGraph, _: [Option<Motion>; 3]) {
        self.at_motions.push(self.wrench);
    }
}

/// Where the wrench acts, on the way inward: motions read off what it is about and along them.
struct Lever<'a> {
    position: Vector,
    /// The wrenches wherever motions of the rest of the way enter.
    wrenches: Vec<Wrench>,
    tau: &'a mut [Expr],
}

impl Lever<'_> {
    fn next(&mut self) -> Wrench {
        let next = self.wrenches.pop();
        next.expect("frames: the way inward is the way outward")
    }
}

impl Passenger for Lever<'_> {
    fn shift(&mut self, graph: &mut ExprGraph, _: BodyId, offset: Vector) {
        self.position = graph.add_vectors(self.position, offset);
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive) {
        let wrench = self.next().moved(graph, self.position);
        wrench::read_off(graph, self.tau, drive.motions(), wrench.moment);
        self.position = rotation.backward(graph, self.position);
    }

    fn along(&mut self, graph: &mut ExprGraph, motions: [Option<Motion>; 3]) {
        let wrench = self.next();
        wrench::read_off(graph, self.tau, motions, wrench.force);
    }
}
