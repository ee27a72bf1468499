//! States at which a function divides by what vanishes, or nearly so: by the cosine of a joint's second angle, or by a pivot of the mass
//! matrix.

use kane_codegen::{
    compile::{self, Plans},
    diagnostic::Escaped,
    expr::{Binding, Expr, Input, Node},
    functions::{Derived, Function, Request},
    options::Formulation,
    tree::{Coordinate, Joint, Tree},
};

use super::state::State;
use crate::cli::Voice;

/// Accelerations have the square of the cosine below them: at this one, twelve of sixteen digits are lost.
const TOLERANCE: f64 = 1e-6;

/// A divisor that grows so much when the angle moves by [`AWAY`] vanishes with the cosine.
const GROWS: f64 = 1e5;

/// How far the angle is moved, rad.
const AWAY: f64 = 0.5;

/// A pivot of the mass matrix that is so small a part of its entry on the diagonal has lost twelve of sixteen digits. Pivots of different
/// speeds have different units, so each is compared with its own entry.
const CANCELLED: f64 = 1e-12;

/// The most speeds with which pivots are looked at where all numbers are finite: more would take longer than the function itself.
const MOST_SPEEDS: usize = 50;

/// Says why numbers are not finite, or inaccurate.
pub(super) fn check(
    plans: &Plans<'_>,
    function: &Request,
    derived: &Derived,
    inputs: &State,
    numbers: &[f64],
    voice: Voice,
) {
    let tree = plans.tree;
    if voice.is_quiet() || joints(tree, derived, inputs, voice) {
        return;
    }
    let divides = function.solves() || function.factorises();
    // Prescribed speeds are not solved for.
    let are_all_solved = !function.prescribes() || tree.prescribed.is_empty();
    let may_be_inaccurate = are_all_solved && tree.n_speeds <= MOST_SPEEDS;
    if divides && (may_be_inaccurate || numbers.iter().any(|number| !number.is_finite())) {
        pivot(plans, tree, inputs, voice);
    }
}

/// Tells of joints at their singularities; true where there is one.
fn joints(tree: &Tree, derived: &Derived, inputs: &State, voice: Voice) -> bool {
    let divisors = divisors(derived);
    if divisors.is_empty() {
        return false;
    }
    let values = |inputs: &State| {
        let graph = &derived.graph;
        graph.evaluate(&divisors, |input| number(inputs, input))
    };
    let here = values(inputs);
    let mut is_told = false;
    for joint in tree.bodies.iter().map(|body| &body.joint) {
        let Some((theta2, distance)) = singularity(joint, inputs) else {
            continue;
        };
        let away = values(&moved(tree, theta2, inputs));
        let grows = |(here, away): (&f64, &f64)| here.abs() * GROWS < away.abs();
        if here.iter().zip(&away).any(grows) {
            let name = joint.name.escaped();
            voice.say(format_args!(
                "warning: `{name}` is at its singularity, |cos(theta2)| is {distance:.1e}: results that divide by it are inaccurate"
            ));
            is_told = true;
        }
    }
    is_told
}

/// What the function divides by that depends on the state.
fn divisors(derived: &Derived) -> Vec<Expr> {
    let graph = &derived.graph;
    let needed = graph.reachable(&derived.roots);
    let of = |id| match graph.node(id) {
        Node::Div(_, by) if graph.binding(by) == Binding::State => Some(graph.as_written(by)),
        _ => None,
    };
    let ids = graph.ids().filter(|id| needed[id.index()]);
    ids.filter_map(of).collect()
}

fn number(inputs: &State, input: Input) -> f64 {
    inputs.get(&input).copied().unwrap_or(f64::NAN)
}

/// The second angle of a joint at its singularity, and how near it is: `|cos(theta2)|`.
fn singularity(joint: &Joint, inputs: &State) -> Option<(Coordinate, f64)> {
    let [_, theta2, _] = joint.angles().filter(|_| joint.has_singular_chart())?;
    let distance = libm::cos(angle(theta2, inputs)).abs();
    (distance < TOLERANCE).then_some((theta2, distance))
}

fn angle(coordinate: Coordinate, inputs: &State) -> f64 {
    match coordinate {
        Coordinate::Free { coordinate, .. } => number(inputs, Input::Q(coordinate)),
        Coordinate::Mimic {
            coordinate,
            multiplier,
            offset,
            ..
        } => multiplier * number(inputs, Input::Q(coordinate)) + offset,
        Coordinate::Locked(angle) => angle,
    }
}

/// The same state with this angle elsewhere.
fn moved(tree: &Tree, theta2: Coordinate, inputs: &State) -> State {
    let mut moved = inputs.clone();
    let (Coordinate::Free { coordinate, .. } | Coordinate::Mimic { coordinate, .. }) = theta2
    else {
        return moved;
    };
    let angle = number(inputs, Input::Q(coordinate)) + AWAY;
    let mut replace = |input, value| {
        moved.entry(input).and_modify(|own| *own = value);
    };
    replace(Input::Q(coordinate), angle);
    let mut angles = tree.angles().into_iter();
    if let Some(place) = angles.position(|own| own.coordinate == coordinate) {
        replace(Input::Sine(place), libm::sin(angle));
        replace(Input::Cosine(place), libm::cos(angle));
    }
    moved
}

/// Tells of the first pivot of the mass matrix that is not positive, or nearly vanishes.
fn pivot(plans: &Plans<'_>, tree: &Tree, inputs: &State, voice: Voice) {
    let values = |name: &str| {
        let function = Function::find(name).expect("eval: the mass matrix is in the catalogue");
        let request = Request::from(function);
        let derived = compile::choose(plans, &request, Formulation::Recursive).derived;
        let graph = &derived.graph;
        graph.evaluate(&derived.roots, |input| number(inputs, input))
    };
    let (pivots, matrix) = (values("forward_dynamics_pivots"), values("mass_matrix"));
    let diagonal = matrix.iter().step_by(tree.n_speeds + 1);
    let speeds = tree.speed_names().into_iter();
    let mut of_speeds = speeds.zip(pivots.iter().zip(diagonal));
    // Others are NaN because of it.
    let small =
        of_speeds.find(|(_, (pivot, entry))| entry.is_finite() && **pivot <= CANCELLED * **entry);
    let Some((speed, (pivot, entry))) = small else {
        return;
    };
    let speed = speed.escaped();
    if *pivot <= 0.0 {
        voice.say(format_args!(
            "warning: the mass matrix is not positive definite: its pivot at `{speed}` is {pivot:?}"
        ));
    } else {
        voice.say(format_args!(
            "warning: the mass matrix is nearly singular: its pivot at `{speed}` is {pivot:.1e}, its diagonal entry {entry:.1e}; results are inaccurate"
        ));
    }
}
