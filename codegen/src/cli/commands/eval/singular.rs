//! States at which a function divides by nothing, or nearly so: its numbers are infinite, or mean nothing.

use kane_codegen::{
    compile::{self, Plans},
    diagnostic::Escaped,
    expr::{Binding, Input, Node},
    functions::{CATALOGUE, Derived, Request},
    options::Formulation,
    tree::{Coordinate, Joint, Orientation, Tree},
};

use super::state::State;
use crate::cli::Voice;

/// How near to zero a cosine costs twelve of the sixteen digits of accelerations: these have its square below them.
const TOLERANCE: f64 = 1e-6;

/// Says why numbers are not finite, or mean nothing.
pub(super) fn check(
    plans: &Plans<'_>,
    tree: &Tree,
    derived: &Derived,
    inputs: &State,
    numbers: &[f64],
    voice: Voice,
) {
    let divisors = divisors(derived, inputs);
    if divisors.is_empty() || are_told(tree, &divisors, inputs, voice) {
        return;
    }
    if numbers.iter().any(|number| !number.is_finite()) {
        pivot(plans, tree, inputs, voice);
    }
}

/// What the function divides by that depends on the state.
fn divisors(derived: &Derived, inputs: &State) -> Vec<f64> {
    let graph = &derived.graph;
    let needed = graph.reachable(&derived.roots);
    let of = |id| match graph.node(id) {
        Node::Div(_, by) if graph.binding(by) == Binding::State => Some(graph.as_written(by)),
        _ => None,
    };
    let ids = graph.ids().filter(|id| needed[id.index()]);
    let divisors: Vec<_> = ids.filter_map(of).collect();
    graph.evaluate(&divisors, |input| number(inputs, input))
}

fn number(inputs: &State, input: Input) -> f64 {
    inputs.get(&input).copied().unwrap_or(f64::NAN)
}

/// Tells of angles that are singular; true where some are.
fn are_told(tree: &Tree, divisors: &[f64], inputs: &State, voice: Voice) -> bool {
    let divides = divisors.iter().any(|by| by.abs() < TOLERANCE);
    let joints = tree.bodies.iter().map(|body| &body.joint);
    let singular = joints.filter_map(|joint| {
        // Where speeds are an angular velocity, the rates of the angles alone are singular.
        let is_heeded = divides || matches!(joint.orientation, Orientation::Rates(_));
        let distance = distance(joint, inputs).filter(|distance| *distance < TOLERANCE)?;
        is_heeded.then_some((joint, distance))
    });
    let mut are_told = false;
    for (joint, distance) in singular {
        let name = joint.name.escaped();
        voice.say(format_args!(
            "warning: the angles of `{name}` are singular, |cos(theta2)| is {distance:.1e}: what is divided by it means nothing"
        ));
        are_told = true;
    }
    are_told
}

/// `|cos(theta2)|` where the angles of a joint have a singularity.
fn distance(joint: &Joint, inputs: &State) -> Option<f64> {
    let [_, theta2, _] = joint.angles().filter(|_| joint.has_singular_chart())?;
    let angle = match theta2 {
        Coordinate::Free { coordinate, .. } => number(inputs, Input::Q(coordinate)),
        Coordinate::Mimic {
            coordinate,
            multiplier,
            offset,
            ..
        } => multiplier * number(inputs, Input::Q(coordinate)) + offset,
        Coordinate::Locked(angle) => angle,
    };
    Some(libm::cos(angle).abs())
}

/// Tells of the first pivot of the mass matrix that is not positive.
fn pivot(plans: &Plans<'_>, tree: &Tree, inputs: &State, voice: Voice) {
    let mut catalogue = CATALOGUE.iter();
    let Some(pivots) = catalogue.find(|one| one.name == "forward_dynamics_pivots") else {
        unreachable!("eval: pivots are in the catalogue")
    };
    let derived = compile::choose(plans, &Request::from(pivots), Formulation::Recursive).derived;
    let pivots = derived
        .graph
        .evaluate(&derived.roots, |input| number(inputs, input));
    // Others are NaN because of it.
    let mut of_speeds = tree.speed_names().into_iter().zip(pivots);
    if let Some((speed, pivot)) = of_speeds.find(|(_, pivot)| *pivot <= 0.0) {
        let speed = speed.escaped();
        voice.say(format_args!(
            "warning: the mass matrix is not positive definite: its pivot at `{speed}` is {pivot:?}"
        ));
    }
}
