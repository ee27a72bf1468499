//! Along which axes a joint's accelerations are solved for.
//!
//! Three angles turn a link about three axes of which only the last is its own; their accelerations are, but for the rates'
//! products, `P^-1` times an angular acceleration along its own axes, Eq. (9). Solving for the latter costs less: it enters
//! where it is, and what is known of the link alone stays constant. The same holds of three translations.

use super::{
    linkage::Linkage,
    plan::{Plan, Technique},
    rotation::Turn,
};
use crate::{
    expr::{Expr, ExprGraph, Vector},
    id::{BodyId, BodyMap, SpeedId},
    kane::{given, orientation},
    tree::{Coordinate, Joint, Mechanics, Motion, Orientation, Tree, Value},
};

/// Which of a joint's motions are taken along the axes of its link.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Axes {
    /// The three rotations: what stands in their places are components of the relative angular velocity.
    pub turns: bool,
    /// The three translations.
    pub shifts: bool,
}

/// The motions as the speeds are: about the angles' axes, along the joint's.
pub fn of_speeds(tree: &Tree) -> BodyMap<Axes> {
    BodyMap::outward(tree.bodies.len(), |body, _| Axes {
        turns: matches!(
            tree.body(body).joint.orientation,
            Orientation::AngularVelocity { .. }
        ),
        shifts: false,
    })
}

/// The motions as they are solved for.
pub fn of_solution(tree: &Tree, plan: &Plan) -> BodyMap<Axes> {
    let mut axes = of_speeds(tree);
    if !plan.uses(Technique::LinkAxes) || has_followers(tree) {
        return axes;
    }
    for body in tree.body_ids() {
        let joint = &tree.body(body).joint;
        let own = &mut axes[body];
        own.turns |= match joint.orientation {
            Orientation::Rates(angles) => are_free(angles) && !has_rotors(&joint.mechanics[..3]),
            Orientation::AngularVelocity { .. } => true,
        };
        own.shifts =
            own.turns && are_free(joint.translations) && !has_rotors(&joint.mechanics[3..]);
    }
    axes
}

/// The bodies that nothing holds on the inertial frame.
pub fn falling(tree: &Tree, plan: &Plan) -> BodyMap<bool> {
    BodyMap::outward(tree.bodies.len(), |body, _| {
        let joint = &tree.body(body).joint;
        let is_loose = tree.lower(body).is_none() && are_free(joint.translations);
        // A rotor does not fall.
        let has_rotors = has_rotors(&joint.mechanics[3..]);
        plan.uses(Technique::Fall) && is_loose && !has_rotors && !has_followers(tree)
    })
}

/// True where a coordinate follows another: one speed then moves several joints.
pub fn has_followers(tree: &Tree) -> bool {
    let follows = |coordinate: &Coordinate| matches!(coordinate, Coordinate::Mimic { .. });
    tree.bodies.iter().any(|body| {
        let turns = match body.joint.orientation {
            Orientation::Rates(angles) => angles.iter().any(follows),
            Orientation::AngularVelocity { .. } => false,
        };
        turns || body.joint.translations.iter().any(follows)
    })
}

fn are_free(coordinates: [Coordinate; 3]) -> bool {
    coordinates.iter().all(|coordinate| coordinate.is_free())
}

/// A rotor acts on the rate of its own coordinate.
fn has_rotors(mechanics: &[Mechanics]) -> bool {
    mechanics
        .iter()
        .any(|own| own.armature != Value::Baked(0.0))
}

impl Axes {
    /// The motions of a joint along its link's axes: about them, then along them, where they are taken so.
    pub fn along_link(self, joint: &Joint) -> [Option<[Motion; 3]>; 2] {
        let all = |motions: [Option<Motion>; 3]| {
            let [a, b, c] = motions;
            Some([a?, b?, c?])
        };
        [
            all(joint.turns()).filter(|_| self.turns),
            all(joint.shifts()).filter(|_| self.shifts),
        ]
    }
}

/// Generalized forces of the speeds, as those of the motions that are solved for.
pub(super) fn forces(graph: &mut ExprGraph, linkage: &Linkage<'_>, tau: &mut [Expr]) {
    let Linkage {
        tree, links, axes, ..
    } = linkage;
    for body in tree.body_ids() {
        graph.enter(body);
        let [turns, shifts] = axes[body].along_link(&tree.body(body).joint);
        if let Some(motions) = turns.filter(|_| has_rates(tree, body)) {
            exchange(tau, motions, |forces| {
                of_angular_velocity(graph, tree, body, forces)
            });
        }
        if let Some(motions) = shifts {
            exchange(tau, motions, |forces| links[body].forward(graph, forces));
        }
    }
}

/// Accelerations of the motions that were solved for, as those of the speeds.
pub(super) fn accelerations(graph: &mut ExprGraph, linkage: &Linkage<'_>, solution: &mut [Expr]) {
    let Linkage {
        tree, links, axes, ..
    } = linkage;
    let gravity = given::gravity(graph, tree);
    for body in tree.body_ids() {
        graph.enter(body);
        let joint = &tree.body(body).joint;
        let [turns, shifts] = axes[body].along_link(joint);
        if let (Some(motions), Orientation::Rates(angles)) = (turns, joint.orientation) {
            exchange(solution, motions, |w_dot| {
                crate::kane::angular::rates(graph, tree, angles, w_dot)
            });
        }
        if let Some(motions) = shifts {
            exchange(solution, motions, |a| links[body].backward(graph, a));
        }
        if linkage.falls[body] {
            let gravity = links[body].constant.forward(graph, gravity);
            for (motion, g) in joint.shifts().into_iter().flatten().zip(gravity) {
                let entry = &mut solution[motion.speed.index()];
                *entry = graph.add(*entry, g);
            }
        }
    }
}

fn has_rates(tree: &Tree, body: BodyId) -> bool {
    matches!(tree.body(body).joint.orientation, Orientation::Rates(_))
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
    let angles = angles.expect("axes: rates are those of angles");
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
