//! What a state says that no system has: nothing makes rotations or masses of its numbers, here as in generated code.

use kane_codegen::{
    diagnostic::Escaped,
    expr::Input,
    functions::Request,
    tree::{Tree, Value},
};

use super::state::State;
use crate::cli::Voice;

/// How far the length of a quaternion or of an axis may be from one, and a right angle's cosine from zero: seven digits of their numbers.
const TOLERANCE: f64 = 1e-6;

/// Warns of quaternions and of frames' rotations that are none, and of masses below zero.
pub(super) fn check(tree: &Tree, function: &Request, inputs: &State, voice: Voice) {
    if function
        .only_part()
        .is_none_or(|part| !part.function.normalizes())
    {
        quaternions(tree, inputs, voice);
    }
    rotations(tree, function, inputs, voice);
    masses(tree, inputs, voice);
}

fn masses(tree: &Tree, inputs: &State, voice: Voice) {
    let parts = tree.bodies.iter().flat_map(|body| &body.parts);
    for part in parts {
        let Value::Runtime(id) = part.mass else {
            continue;
        };
        let mass = inputs.get(&Input::Parameter(id));
        if let Some(mass) = mass.filter(|mass| **mass < 0.0) {
            let name = tree.parameters[id.index()].name.escaped();
            voice.say(format_args!(
                "warning: `{name}` is {mass:?} kg; expected zero or more"
            ));
        }
    }
}

fn quaternions(tree: &Tree, inputs: &State, voice: Voice) {
    for (body, parameters) in tree.quaternions() {
        let squares =
            parameters.map(|place| inputs.get(&Input::Q(place)).map(|number| number * number));
        let Some(length) = squares.into_iter().sum::<Option<f64>>().map(libm::sqrt) else {
            continue;
        };
        if (length - 1.0).abs() > TOLERANCE {
            let name = body.name.escaped();
            voice.say(format_args!(
                "warning: the quaternion of `{name}` has length {length}; expected 1, for a rotation"
            ));
        }
    }
}

/// Those of the frames that the function is of.
fn rotations(tree: &Tree, function: &Request, inputs: &State, voice: Voice) {
    let subjects = function
        .parts()
        .iter()
        .filter_map(|part| part.subject.as_ref());
    let mut told = Vec::new();
    for frame in subjects.flat_map(|subject| &subject.frames) {
        let Some(turn) = tree.frame_turn(frame.frame) else {
            continue;
        };
        let number = |value: &Value| match value {
            Value::Baked(number) => Some(*number),
            Value::Runtime(id) => inputs.get(&Input::Parameter(*id)).copied(),
        };
        let rows = turn.each_ref().map(|row| row.each_ref().map(number));
        if rows.as_flattened().contains(&None) || told.contains(&&frame.name) {
            continue;
        }
        if !is_rotation(&rows.map(|row| row.map(Option::unwrap_or_default))) {
            told.push(&frame.name);
            let name = frame.name.escaped();
            voice.say(format_args!(
                "warning: the rotation of frame `{name}` is none; expected rows of length 1 at right angles, right-handed"
            ));
        }
    }
}

fn is_rotation(rows: &[[f64; 3]; 3]) -> bool {
    let dot = |a: &[f64; 3], b: &[f64; 3]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let [x, y, z] = rows;
    let cross = [
        x[1] * y[2] - x[2] * y[1],
        x[2] * y[0] - x[0] * y[2],
        x[0] * y[1] - x[1] * y[0],
    ];
    let errors = [
        dot(x, x) - 1.0,
        dot(y, y) - 1.0,
        dot(z, z) - 1.0,
        dot(x, y),
        dot(&cross, z) - 1.0,
    ];
    errors.iter().all(|error| error.abs() <= TOLERANCE)
}
