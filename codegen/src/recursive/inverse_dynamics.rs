//! Right-hand sides in two passes: motion outward, forces inward (Luh, Walker and Paul 1980).

use super::{
    link::{Link, Turning},
    linkage::Linkage,
    motion::{self, Wrench},
    plan::Plan,
    rotation::Turn,
};
use crate::{
    expr::{Expr, ExprGraph},
    id::{BodyId, BodyMap},
    kane::{Accelerations, given},
    tree::Tree,
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
    let wrenches = motion::wrenches(graph, linkage, accelerations);
    project(graph, linkage, wrenches)
}

/// `f`, Eq. (43): the loads less the bias.
pub fn forcing(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Vec<Expr> {
    let linkage = Linkage::of_speeds(graph, tree, plan);
    let inertial = motion::wrenches(graph, &linkage, Accelerations::Zero);
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
    let Linkage {
        tree, links, axes, ..
    } = linkage;
    let mut tau = vec![graph.zero(); tree.n_speeds];
    for body in tree.body_ids().rev() {
        graph.enter(body);
        let link = &links[body];
        let Wrench {
            mut force,
            mut moment,
        } = wrenches[body];
        graph.name_vector(force, "f");
        graph.name_vector(moment, "n");
        let joint = &tree.body(body).joint;
        let along_link = axes[body].along_link(joint);
        for (motions, along) in along_link.into_iter().zip([moment, force]) {
            for (motion, along) in motions.into_iter().flatten().zip(along) {
                motion::add(graph, &mut tau, Some(motion), along);
            }
        }
        let [turns, shifts] = along_link.map(|motions| motions.is_none());
        match &link.turning {
            Turning::Angles(rotations) => {
                for rotation in rotations.iter().rev() {
                    let motion = rotation.motion.filter(|_| turns);
                    motion::add(graph, &mut tau, motion, moment[rotation.axis.index()]);
                    force = rotation.backward(graph, force);
                    moment = rotation.backward(graph, moment);
                }
            }
            Turning::Matrix(matrix) => {
                [force, moment] = [force, moment].map(|v| matrix.backward(graph, v));
            }
        }
        for (axis, shift) in joint.shifts().into_iter().enumerate() {
            motion::add(graph, &mut tau, shift.filter(|_| shifts), force[axis]);
        }
        [force, moment] = [force, moment].map(|v| link.constant.backward(graph, v));
        if let Some(lower) = tree.lower(body) {
            let lever = graph.cross(link.offset, force);
            let moment = graph.add_vectors(moment, lever);
            graph.enter(lower);
            wrenches[lower] = wrenches[lower].plus(graph, &Wrench { force, moment });
        }
    }
    tau
}
