//! Right-hand sides in two passes: motion outward, forces inward (Luh, Walker and Paul 1980).

use super::loaded::{self, load};
use crate::{
    expr::{Expr, ExprGraph, Purpose, Vector},
    given::{Accelerations, Loads},
    id::{BodyId, BodyMap},
    recursive::{
        links::{
            linkage::Linkage,
            passage::{Drive, Passenger},
            rotation::Turn,
            totalled::Addend,
            wrench::{self, Wrench},
        },
        plan::Plan,
    },
    tree::{Motion, Tree},
};

/// `A y_dot - f` without loads: `tau` for given accelerations, the bias for none.
pub fn inverse_dynamics(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    accelerations: Accelerations<'_>,
) -> Vec<Expr> {
    let linkage = Linkage::of_speeds(graph, tree, plan);
    forces(graph, &linkage, accelerations, Loads::Absent)
}

/// The same with the loads.
pub fn loaded_inverse_dynamics(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    accelerations: Accelerations<'_>,
) -> Vec<Expr> {
    let linkage = Linkage::of_speeds(graph, tree, plan);
    forces(graph, &linkage, accelerations, Loads::Given)
}

/// The same on links that are there.
pub(in crate::recursive) fn forces(
    graph: &mut ExprGraph,
    linkage: &Linkage<'_>,
    accelerations: Accelerations<'_>,
    loads: Loads,
) -> Vec<Expr> {
    let wrenches = loaded::needed(graph, linkage, accelerations, loads);
    project(graph, linkage, wrenches)
}

/// `f`, Eq. (43): the loads less the bias.
pub fn forcing(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Vec<Expr> {
    let linkage = Linkage::of_speeds(graph, tree, plan);
    let inertial = loaded::needed(graph, &linkage, Accelerations::Zero, Loads::Absent);
    let net = BodyMap::outward(tree.bodies.len(), |body, _| {
        let load = load(graph, tree, &linkage.links[body], body);
        load.minus(graph, &inertial[body])
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

/// The generalized force of every motion, from the wrench on every link: from the leaves inward.
pub(in crate::recursive) fn project(
    graph: &mut ExprGraph,
    linkage: &Linkage<'_>,
    mut wrenches: BodyMap<Wrench>,
) -> Vec<Expr> {
    let Linkage { tree, passages, .. } = linkage;
    graph.begin(Purpose::Forces);
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
            graph.hint(|graph| {
                graph.name_vector(wrench.force, "f_on_lower");
                graph.name_vector(wrench.moment, "n_on_lower");
            });
            graph.enter(lower);
            wrenches[lower] = wrenches[lower].plus(graph, &wrench);
        }
    }
    tau
}

/// A wrench on its way inward through a joint, whose motions read off it what acts along them.
pub(in crate::recursive) struct Acting<'a> {
    pub(in crate::recursive) wrench: Wrench,
    pub(in crate::recursive) tau: &'a mut [Expr],
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
