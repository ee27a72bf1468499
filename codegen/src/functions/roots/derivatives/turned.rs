//! Columns of derivatives that need no solution: those by the turns of a root that floats.

use crate::{
    expr::{Expr, ExprGraph},
    functions::roots::dynamics,
    given::{self, Accelerations, mechanics, orientation},
    id::{BodyId, SpeedId},
    solve,
    tree::{Mechanics, Tree},
};

/// A root, and the speeds of its turns.
pub(super) type TurningRoot = (BodyId, [SpeedId; 3]);

/// How accelerations change as a root that floats is turned, speed by speed: with it turns all that it carries, but neither
/// gravity nor the forces that act along its translations. None is where bodies are lifted, whose forces do not turn with it.
///
/// For a turn about `e` it is what the forces `F × e` there make, and `e × (s_ddot - g)` of the translations themselves. `by_forces` is
/// `M^-1`, and may have rows of what else is found.
pub(super) fn turned_roots(
    graph: &mut ExprGraph,
    tree: &Tree,
    roots: &[TurningRoot],
    u_dot: &[Expr],
    by_forces: &[Vec<Expr>],
) -> Vec<(SpeedId, Vec<Expr>)> {
    let zero = Accelerations::Zero;
    let mut taken = vec![graph.zero(); tree.n_speeds];
    mechanics::add_forces(graph, tree, zero, &mut taken);
    let mut net = dynamics::applied(graph, tree);
    solve::subtract(graph, tree, &mut net, &taken);
    let gravity = given::acting_gravity(graph, tree);
    let mut turned = Vec::new();
    for &(body, speeds) in roots {
        graph.enter(body);
        let joint = &tree.body(body).joint;
        let along = joint
            .shifts()
            .map(|motion| motion.map_or(0, |motion| motion.speed.index()));
        let force = along.map(|place| net[place]);
        let to_joint = given::constant(graph, &joint.rotation);
        let gravity = graph.mul_vector(&to_joint, gravity);
        let falling = [0, 1, 2].map(|axis| graph.sub(u_dot[along[axis]], gravity[axis]));
        let axes = orientation::of_joint(graph, tree, joint);
        for (speed, e) in speeds.into_iter().zip(axes) {
            let moved = graph.cross(force, e);
            let mut column = Vec::with_capacity(by_forces.len());
            for row in by_forces {
                let terms = [0, 1, 2].map(|axis| graph.mul(row[along[axis]], moved[axis]));
                let sum = graph.add(terms[0], terms[1]);
                column.push(graph.add(sum, terms[2]));
            }
            let carried = graph.cross(e, falling);
            for (place, own) in along.into_iter().zip(carried) {
                column[place] = graph.add(column[place], own);
            }
            turned.push((speed, column));
        }
    }
    turned
}

/// The roots that move freely against the inertial frame, without rotors and alone, with the speeds of their turns.
pub(super) fn turning_roots(tree: &Tree) -> Vec<TurningRoot> {
    let turning = |body: BodyId| {
        let joint = &tree.body(body).joint;
        let speeds = joint.angular_velocity()?;
        let is_free = joint.translations.iter().all(|own| own.is_free());
        let has_rotors = joint.mechanics.iter().any(Mechanics::has_rotor);
        (tree.lower(body).is_none() && is_free && !has_rotors).then_some((body, speeds))
    };
    if tree.lifts_some() || tree.has_followers() {
        return Vec::new();
    }
    tree.body_ids().filter_map(turning).collect()
}
