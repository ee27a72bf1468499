//! Generalized forces and accelerations of the speeds, exchanged for those of the motions that are solved for.

use crate::{
    expr::{Expr, ExprGraph, Purpose, Vector},
    given::{self, orientation},
    id::{BodyId, SpeedId},
    recursive::links::{linkage::Linkage, rotation::Turn},
    solve::{self, SpeedMatrix},
    tree::{Motion, Tree},
};

/// Generalized forces of the speeds, as those of the motions that are solved for.
pub(in crate::recursive) fn forces(graph: &mut ExprGraph, linkage: &Linkage<'_>, tau: &mut [Expr]) {
    let Linkage {
        tree, links, axes, ..
    } = linkage;
    graph.begin(Purpose::Loads);
    for body in tree.body_ids() {
        graph.enter(body);
        let [turns, shifts] = axes[body].motions(&tree.body(body).joint);
        if let Some(motions) = turns.filter(|_| has_rates(tree, body)) {
            exchange(tau, motions, |forces| {
                of_angular_velocity(graph, tree, body, forces)
            });
        }
        if let Some(motions) = shifts {
            exchange(tau, motions, |forces| {
                links[body].passage.forward_from_joint(graph, forces)
            });
        }
    }
}

/// Accelerations of the motions that were solved for, as those of the speeds.
pub(in crate::recursive) fn accelerations(
    graph: &mut ExprGraph,
    linkage: &Linkage<'_>,
    solution: &mut [Expr],
) {
    let Linkage {
        tree, links, axes, ..
    } = linkage;
    let gravity = given::acting_gravity(graph, tree);
    graph.begin(Purpose::Accelerations);
    for body in tree.body_ids() {
        graph.enter(body);
        let joint = &tree.body(body).joint;
        let passage = &links[body].passage;
        let [turns, shifts] = axes[body].motions(joint);
        if let (Some(motions), Some(angles)) = (turns, joint.angles_with_rates()) {
            exchange(solution, motions, |w_dot| {
                orientation::rates(graph, tree, angles, w_dot)
            });
        }
        if let Some(motions) = shifts {
            exchange(solution, motions, |a| passage.backward_to_joint(graph, a));
        }
        if linkage.falls[body] {
            let gravity = passage.constant.forward(graph, gravity);
            for (motion, g) in joint.shifts().into_iter().flatten().zip(gravity) {
                let entry = &mut solution[motion.speed.index()];
                *entry = graph.add(*entry, g);
            }
        }
    }
}

/// A symmetric matrix that makes accelerations of forces, of the motions that were solved for, as that of the speeds; without
/// weight.
pub(in crate::recursive) fn compliance(
    graph: &mut ExprGraph,
    linkage: &Linkage<'_>,
    h: &mut SpeedMatrix,
) {
    for _ in 0..2 {
        // All columns, then all rows, which are the columns of the mirrored matrix.
        let n = h.len();
        for column in 0..n {
            let mut own: Vec<Expr> = h.iter().map(|row| row[column]).collect();
            accelerations(graph, linkage, &mut own);
            for (row, entry) in h.iter_mut().zip(own) {
                row[column] = entry;
            }
        }
        *h = solve::transposed(h);
    }
    // Rounded in another order, the mirrored entries would differ.
    for place in 0..h.len() {
        let (above, own) = h.split_at_mut(place);
        for (row, entry) in above.iter_mut().zip(&own[0]) {
            row[place] = *entry;
        }
    }
}

fn has_rates(tree: &Tree, body: BodyId) -> bool {
    tree.body(body).joint.angles_with_rates().is_some()
}

fn exchange(entries: &mut [Expr], motions: [Motion; 3], new: impl FnOnce(Vector) -> Vector) {
    let place = |motion: Motion| SpeedId::index(motion.speed);
    let old = motions.map(|motion| entries[place(motion)]);
    for (motion, new) in motions.into_iter().zip(new(old)) {
        entries[place(motion)] = new;
    }
}

/// `P^-T tau`, the transposed of Eq. (9): the moment along the link's axes that does the work of generalized forces of its
/// three angles.
fn of_angular_velocity(
    graph: &mut ExprGraph,
    tree: &Tree,
    body: BodyId,
    [first, second, third]: Vector,
) -> Vector {
    let angles = tree.body(body).joint.angles();
    let angles = angles.expect("exchange: rates are those of angles");
    let t = orientation::trigonometry(graph, tree, angles);
    let (s3, c3) = (t.sines[2], t.cosines[2]);
    let shared = graph.mul(t.sines[1], third);
    let rest = graph.sub(first, shared);
    let along_lower_axis = graph.div(rest, t.cosines[1]);
    let mut turned = |a: Expr, b: Expr| {
        let (a, b) = (graph.mul(c3, a), graph.mul(s3, b));
        graph.add(a, b)
    };
    let about_x = turned(along_lower_axis, second);
    let about_y = turned(second, -along_lower_axis);
    [about_x, about_y, third]
}
