//! Right-hand sides in two passes: motion outward, forces inward (Luh, Walker and Paul 1980).

use super::{
    link::Link,
    link_motion,
    linkage::Linkage,
    passage::{Drive, Passenger},
    plan::Plan,
    rotation::Turn,
    wrench::{self, Wrench},
};
use crate::{
    expr::{Expr, ExprGraph, Vector},
    given::{self, Accelerations},
    id::{BodyId, BodyMap},
    tree::{Motion, Tree},
};

/// `A y_dot - f` without loads: `tau` for given accelerations, the bias for none.
pub fn inverse_dynamics(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    accelerations: Accelerations,
) -> Vec<Expr> {
    let linkage = Linkage::of_speeds(graph, tree, plan);
    inertial_forces(graph, &linkage, accelerations)
}

/// The same on links that are there.
pub(super) fn inertial_forces(
    graph: &mut ExprGraph,
    linkage: &Linkage<'_>,
    accelerations: Accelerations,
) -> Vec<Expr> {
    let wrenches = link_motion::inertial_wrenches(graph, linkage, accelerations);
    project(graph, linkage, wrenches)
}

/// `f`, Eq. (43): the loads less the bias.
pub fn forcing(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Vec<Expr> {
    let linkage = Linkage::of_speeds(graph, tree, plan);
    let inertial = link_motion::inertial_wrenches(graph, &linkage, Accelerations::Zero);
    let net = BodyMap::outward(tree.bodies.len(), |body, _| {
        let load = load(graph, tree, &linkage.links[body], body);
        Wrench {
            force: graph.sub_vectors(load.force, inertial[body].force),
            moment: graph.sub_vectors(load.moment, inertial[body].moment),
        }
    });
    project(graph, &linkage, net)
}

/// `F_y`, Eq. (36), of the loads.
pub fn generalized_forces(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Vec<Expr> {
    let linkage = Linkage::of_speeds(graph, tree, plan);
    let loads = BodyMap::outward(tree.bodies.len(), |body, _| {
        load(graph, tree, &linkage.links[body], body)
    });
    project(graph, &linkage, loads)
}

/// The load of a body about its link's origin.
fn load(graph: &mut ExprGraph, tree: &Tree, link: &Link, body: BodyId) -> Wrench {
    graph.enter(body);
    let center = given::mass_center(graph, tree.body(body));
    let center = link.point_of_body(graph, center);
    let (force, moment) = (
        given::force(graph, tree, body),
        given::moment(graph, tree, body),
    );
    let [force, moment] = [force, moment].map(|v| link.of_body(graph, v));
    let lever = graph.cross(center, force);
    Wrench {
        force,
        moment: graph.add_vectors(moment, lever),
    }
}

/// The generalized force of every motion, from the wrench on every link: from the leaves inward.
fn project(
    graph: &mut ExprGraph,
    linkage: &Linkage<'_>,
    mut wrenches: BodyMap<Wrench>,
) -> Vec<Expr> {
    let Linkage { tree, passages, .. } = linkage;
    let mut tau = vec![graph.zero(); tree.n_speeds];
    for body in tree.body_ids().rev() {
        graph.enter(body);
        let wrench = wrenches[body];
        graph.name_vector(wrench.force, "f");
        graph.name_vector(wrench.moment, "n");
        let tau = &mut tau;
        let mut acting = Acting { wrench, tau };
        passages[body].inward(graph, &mut acting);
        let wrench = acting.wrench;
        if let Some(lower) = tree.lower(body) {
            graph.enter(lower);
            wrenches[lower] = wrenches[lower].plus(graph, &wrench);
        }
    }
    tau
}

/// A wrench on its way inward through a joint, whose motions read off it what acts along them.
struct Acting<'a> {
    wrench: Wrench,
    tau: &'a mut [Expr],
}

impl Passenger for Acting<'_> {
    fn shift(&mut self, graph: &mut ExprGraph, _: BodyId, offset: Vector) {
        self.wrench = self.wrench.moved(graph, offset);
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive) {
        wrench::read_off(graph, self.tau, drive.motions(), self.wrench.moment);
        self.wrench = self.wrench.map(|v| rotation.backward(graph, v));
    }

    fn along(&mut self, graph: &mut ExprGraph, motions: [Option<Motion>; 3]) {
        wrench::read_off(graph, self.tau, motions, self.wrench.force);
    }
}
