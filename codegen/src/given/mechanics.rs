//! What acts in the joints themselves: rotors, dampers, springs. Part of the mass matrix, the bias and the energies,
//! whatever way the sums over bodies are associated.

use super::{
    joint::{self, Accelerations},
    numbers::value,
};
use crate::{
    expr::{Expr, ExprGraph, Input, Purpose},
    id::BodyId,
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
    graph.begin(Purpose::Mechanics);
    for body in tree.body_ids() {
        each_of(graph, tree, body, &mut f);
    }
}

/// Calls `f` for every motion of one joint, in the scope of its body.
fn each_of(
    graph: &mut ExprGraph,
    tree: &Tree,
    body: BodyId,
    mut f: impl FnMut(&mut ExprGraph, &Joint, Acting<'_>),
) {
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

/// Adds the rotors to a mass matrix.
pub fn add_rotors(graph: &mut ExprGraph, tree: &Tree, a: &mut SpeedMatrix) {
    each(graph, tree, |graph, _, acting| {
        let rotor = reflected(graph, &acting);
        let entry = &mut a[acting.motion.speed.index()][acting.motion.speed.index()];
        *entry = graph.add(*entry, rotor);
    });
}

/// Adds what rotors need for the accelerations.
pub fn add_rotor_forces(graph: &mut ExprGraph, tree: &Tree, tau: &mut [Expr]) {
    each(graph, tree, |graph, _, acting| {
        let speed = acting.motion.speed;
        let rotor = reflected(graph, &acting);
        let acceleration = graph.input(Input::UDot(speed));
        let needed = graph.mul(rotor, acceleration);
        tau[speed.index()] = graph.add(tau[speed.index()], needed);
    });
}

/// Adds to a bias or to inverse dynamics what rotors, dampers and springs need.
pub fn add_forces(
    graph: &mut ExprGraph,
    tree: &Tree,
    accelerations: Accelerations<'_>,
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

/// What dampers, Coulomb friction and rotors need along each speed for a unit of theirs, as the speed feels them: the speed, its
/// sign and its rate.
///
/// The sign is a quotient: one to all digits from about `1e-14` on, a half at `LEAST_SPEED`, zero at zero.
pub fn unit_forces(graph: &mut ExprGraph, tree: &Tree) -> Vec<[Expr; 3]> {
    let mut units = vec![[graph.zero(); 3]; tree.n_speeds];
    for body in tree.body_ids() {
        graph.enter(body);
        for (_, speed) in tree.body(body).joint.speeds() {
            let own = Some(Motion { speed, factor: 1.0 });
            let rate = joint::speed(graph, own);
            let second = joint::acceleration(graph, own, Accelerations::Given);
            let (size, least) = (graph.abs(rate), graph.number(LEAST_SPEED));
            let size = graph.add(size, least);
            let sign = graph.div(rate, size);
            units[speed.index()] = [rate, sign, second];
        }
    }
    units
}

/// What a speed's magnitude is more than, rad/s or m/s: far below what is measured, and a number of 32 bits.
const LEAST_SPEED: f64 = 1e-30;

/// Half of the rotors' inertias times their speeds squared, J.
pub fn kinetic(graph: &mut ExprGraph, tree: &Tree) -> Expr {
    let mut twice = graph.zero();
    each(graph, tree, |graph, _, acting| {
        let own = twice_kinetic(graph, &acting);
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
        let own = twice_potential(graph, joint, &acting);
        twice = graph.add(twice, own);
    });
    graph.enter(None);
    let half = graph.number(0.5);
    graph.mul(half, twice)
}

/// Twice the kinetic energy of the rotors of one joint, J.
pub fn twice_kinetic_of(graph: &mut ExprGraph, tree: &Tree, body: BodyId) -> Expr {
    let mut twice = graph.zero();
    each_of(graph, tree, body, |graph, _, acting| {
        let own = twice_kinetic(graph, &acting);
        twice = graph.add(twice, own);
    });
    twice
}

/// Twice the potential energy of the springs of one joint, J.
pub fn twice_potential_of(graph: &mut ExprGraph, tree: &Tree, body: BodyId) -> Expr {
    let mut twice = graph.zero();
    each_of(graph, tree, body, |graph, joint, acting| {
        let own = twice_potential(graph, joint, &acting);
        twice = graph.add(twice, own);
    });
    twice
}

/// The rotor's inertia times its speed squared.
fn twice_kinetic(graph: &mut ExprGraph, acting: &Acting<'_>) -> Expr {
    let armature = value(graph, acting.mechanics.armature);
    let rate = joint::speed(graph, Some(acting.motion));
    let square = graph.mul(rate, rate);
    graph.mul(armature, square)
}

/// The stiffness times the stretch squared; zero without a spring.
fn twice_potential(graph: &mut ExprGraph, joint: &Joint, acting: &Acting<'_>) -> Expr {
    let Some(stretch) = stretch(graph, joint, acting) else {
        return graph.zero();
    };
    let stiffness = value(graph, acting.mechanics.stiffness);
    let square = graph.mul(stretch, stretch);
    graph.mul(stiffness, square)
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
