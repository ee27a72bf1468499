//! What C gets of the runtime crate beside a module's functions: sums and differences of coordinates, and steps.

use super::{
    declared::{self, after, written},
    steps,
};
use crate::{
    functions::{Argument, Declared, Element, Length, N_SPEEDS, Signature, Unit},
    listing::Module,
    steps::Step,
    words::{Q_MINUS, Q_PLUS, SCALE_QUATERNIONS},
};

/// What may be written where it is read.
const Q_IN_PLACE: &str = "`q_after` may lead to the same array as `q`.";

/// A function of the runtime crate.
pub(crate) struct RuntimeFunction {
    /// How C calls it.
    pub(crate) signature: Signature,
    /// Which one it is.
    pub(crate) kind: RuntimeKind,
}

/// Which function of the runtime crate it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum RuntimeKind {
    /// `kane::manifold::q_plus`.
    QPlus,
    /// `kane::manifold::q_minus`.
    QMinus,
    /// `kane::manifold::scale_quaternions`.
    ScaleQuaternions,
    /// A function of `kane::discrete`.
    Step(Step),
}

/// Those that can be called with the functions of a module.
pub(crate) fn of(module: &Module) -> Vec<RuntimeFunction> {
    let mut all = vec![q_plus(), q_minus()];
    if module.facts.has_quaternions() {
        all.push(scale_quaternions());
    }
    all.extend(steps::of(module).into_iter().map(|(step, signature)| {
        let kind = RuntimeKind::Step(step);
        RuntimeFunction { signature, kind }
    }));
    all
}

fn q_plus() -> RuntimeFunction {
    let doc = [
        "Coordinates after unit time at the constant speeds `direction`, beginning at `q`. Quaternions keep their length. Angles with angular velocities as",
        "speeds are singular at `cos(theta_2) = 0`, and none of them changes by more than half a revolution.",
        Q_IN_PLACE,
    ];
    let direction = Declared::read("direction", Element::Scalar, "speeds times a time");
    let q = Argument::Q.declared();
    let after = after(&q);
    let arguments = [q, of_directions(direction), after];
    function(Q_PLUS, &doc, arguments, RuntimeKind::QPlus)
}

fn q_minus() -> RuntimeFunction {
    let doc = "The direction by which `q_plus` leads from `q_from` to `q_to`. Orientations turn by half a revolution at most, whatever the lengths and signs of quaternions.";
    let q = |name: &str| Declared {
        name: name.to_owned(),
        ..Argument::Q.declared()
    };
    let direction = written("direction", "what `q_plus` is given");
    let of = [q("q_from"), q("q_to"), of_directions(direction)];
    function(Q_MINUS, &[doc], of, RuntimeKind::QMinus)
}

fn scale_quaternions() -> RuntimeFunction {
    let doc = "The same coordinates with quaternions of length one, whatever length above 1e-28 they have; one of four zeros stays. For a `q` from elsewhere.";
    let q = Argument::Q.declared();
    let after = after(&q);
    let kind = RuntimeKind::ScaleQuaternions;
    function(SCALE_QUATERNIONS, &[doc, Q_IN_PLACE], [q, after], kind)
}

/// As an array of directions: one entry per speed.
fn of_directions(declared: Declared) -> Declared {
    Declared {
        lengths: vec![Length::Constant(N_SPEEDS.to_owned())],
        unit: Unit::DIRECTIONS,
        ..declared
    }
}

fn function(
    name: &str,
    doc: &[&str],
    own: impl IntoIterator<Item = Declared>,
    kind: RuntimeKind,
) -> RuntimeFunction {
    let signature = declared::signature(name, doc, own);
    RuntimeFunction { signature, kind }
}
