//! What acts in the joints themselves: rotors, dampers, springs. Part of the mass matrix, the bias and the energies,
//! whatever way the sums over bodies are associated.

use super::{
    joint::{self, Accelerations},
    numbers::value,
};
use crate::{
    expr::{Expr, ExprGraph},
    solve::SpeedMatrix,
    tree::{Joint, Mechanics, Motion, Tree, Value},
};

/// A motion of a joint with what acts along it, and the place of the motion among its joint's six.
struct Acting<'a> {
    motion: Motion,
    place: usize,
    mechanics: &'a Mechanics,
}

/// Calls `f` for every motion, in the scope of its body.
fn each(graph: &mut ExprGraph, tree: &Tree, mut f: impl FnMut(&mut ExprGraph, &Joint, Acting<'_>)) {
    for body in tree.body_ids() {
        graph.enter(body);
        let joint = &tree.body(body).joint;
        for (place, motion) in joint.motions().into_iter().enumerate() {
            let Some(motion) = motion else { continue };
            let mechanics = &joint.mechanics[place];
            f(
                graph,
                joint,
                Acting {
                    motion,
                    place,
                    mechanics,
                },
            );
        }
    }
}

/// Adds the rotors to a mass matrix.
pub fn add_rotors(graph: &mut ExprGraph, tree: &Tree, a: &mut SpeedMatrix) {
    each(graph, tree, |graph, _, acting| {
        let rotor = reflected(graph, &acting);
        let entry = &mut a[acting.motion.speed.index()][acting.motion.speed.index()];
        *entry = graph.add(*entry, rotor);
    });
}

/// Adds to a bias or to inverse dynamics what rotors, dampers and springs need.
pub fn add_forces(
    graph: &mut ExprGraph,
    tree: &Tree,
    accelerations: Accelerations,
    tau: &mut [Expr],
) {
    each(graph, tree, |graph, joint, acting| {
        let Motion { speed, factor } = acting.motion;
        let rotor = reflected(graph, &acting);
        let own = Some(Motion { speed, factor: 1.0 });
        let second = joint::acceleration(graph, own, accelerations);
        let inertial = graph.mul(rotor, second);
        let damping = value(graph, acting.mechanics.damping);
        let rate = joint::speed(graph, Some(acting.motion));
        let damped = graph.mul(damping, rate);
        let mut along = damped;
        if let Some(stretch) = stretch(graph, joint, &acting) {
            let stiffness = value(graph, acting.mechanics.stiffness);
            let pulled = graph.mul(stiffness, stretch);
            along = graph.add(along, pulled);
        }
        let factor = graph.number(factor);
        let along = graph.mul(factor, along);
        let sum = graph.add(inertial, along);
        tau[speed.index()] = graph.add(tau[speed.index()], sum);
    });
}

/// Half of the rotors' inertias times their speeds squared, J.
pub fn kinetic(graph: &mut ExprGraph, tree: &Tree) -> Expr {
    let mut twice = graph.zero();
    each(graph, tree, |graph, _, acting| {
        let armature = value(graph, acting.mechanics.armature);
        let rate = joint::speed(graph, Some(acting.motion));
        let square = graph.mul(rate, rate);
        let own = graph.mul(armature, square);
        twice = graph.add(twice, own);
    });
    graph.enter(None);
    let half = graph.number(0.5);
    graph.mul(half, twice)
}

/// Half of the stiffnesses times their stretches squared, J.
pub fn potential(graph: &mut ExprGraph, tree: &Tree) -> Expr {
    let mut twice = graph.zero();
    each(graph, tree, |graph, joint, acting| {
        let Some(stretch) = stretch(graph, joint, &acting) else {
            return;
        };
        let stiffness = value(graph, acting.mechanics.stiffness);
        let square = graph.mul(stretch, stretch);
        let own = graph.mul(stiffness, square);
        twice = graph.add(twice, own);
    });
    graph.enter(None);
    let half = graph.number(0.5);
    graph.mul(half, twice)
}

/// The rotor's inertia as its speed feels it.
fn reflected(graph: &mut ExprGraph, acting: &Acting<'_>) -> Expr {
    let armature = value(graph, acting.mechanics.armature);
    let factor = graph.number(acting.motion.factor * acting.motion.factor);
    graph.mul(factor, armature)
}

/// How far a spring is from rest; `None` without one.
fn stretch(graph: &mut ExprGraph, joint: &Joint, acting: &Acting<'_>) -> Option<Expr> {
    if acting.mechanics.stiffness == Value::Baked(0.0) {
        return None;
    }
    let coordinate = joint::coordinate(graph, joint.coordinate_of(acting.place)?);
    let rest = value(graph, acting.mechanics.rest);
    Some(graph.sub(coordinate, rest))
}
