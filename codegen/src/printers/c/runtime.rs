//! What C gets of the runtime crate beside a module's functions: sums and differences of coordinates, steps and their derivatives.

use crate::{
    functions::{Access, Argument, Declared, Element, Length, N_SPEEDS, Signature, Unit},
    listing::Module,
    words::{
        EULER_LINEARIZED, EULER_STEP, Q_MINUS, Q_PLUS, RK4_LINEARIZED, RK4_STEP, SCALE_QUATERNIONS,
    },
};

/// The trait of what derivatives of steps need.
const OF_LINEARIZED: &str = "ForwardDynamicsAndDerivatives";

/// What may be written where it is read.
const Q_IN_PLACE: &str = "`q_after` may lead to the same array as `q`.";
const STATE_IN_PLACE: &str =
    "`q_after` may lead to the same array as `q`, and `u_after` to the same as `u`.";

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
    /// `step` of this module of `kane::discrete`.
    Step(&'static str),
    /// `linearized` of this module of `kane::discrete`.
    Linearized(&'static str),
}

/// Those that can be called with the functions of a module.
pub(crate) fn of(module: &Module) -> Vec<RuntimeFunction> {
    let functions = module.functions.iter();
    let mut parts = functions
        .clone()
        .filter_map(|one| one.catalogue_part.as_ref());
    let has_step = parts.any(|part| part.function.name == "forward_dynamics");
    let mut traits = functions.filter_map(|one| one.derivative_trait.as_ref());
    let has_derivatives = traits.any(|own| own.name == OF_LINEARIZED);
    let mut all = vec![q_plus(), q_minus()];
    if module.facts.has_quaternions() {
        all.push(scale_quaternions());
    }
    if has_step {
        all.extend([&EULER, &RK4].map(step));
    }
    if has_derivatives {
        let matrices = matrices();
        all.extend([&EULER, &RK4].map(|kind| linearized(kind, &matrices)));
    }
    all
}

/// A kind of step.
struct Kind {
    /// The module of `kane::discrete`.
    module: &'static str,
    /// What it is, in words.
    what: &'static str,
    /// The names of its functions in C.
    step: &'static str,
    linearized: &'static str,
}

const EULER: Kind = Kind {
    module: "euler",
    what: "a semi-implicit Euler step",
    step: EULER_STEP,
    linearized: EULER_LINEARIZED,
};
const RK4: Kind = Kind {
    module: "rk4",
    what: "a Runge-Kutta step of fourth order",
    step: RK4_STEP,
    linearized: RK4_LINEARIZED,
};

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
    let doc = "The same coordinates with quaternions of length one, whatever length they have; one of four zeros stays. For a `q` from elsewhere.";
    let q = Argument::Q.declared();
    let after = after(&q);
    let kind = RuntimeKind::ScaleQuaternions;
    function(SCALE_QUATERNIONS, &[doc, Q_IN_PLACE], [q, after], kind)
}

fn step(kind: &Kind) -> RuntimeFunction {
    let own = RuntimeKind::Step(kind.module);
    let doc = [&doc_of_step(kind), STATE_IN_PLACE];
    function(kind.step, &doc, states(), own)
}

fn linearized(kind: &Kind, matrices: &[Declared; 2]) -> RuntimeFunction {
    let doc = [
        &doc_of_step(kind),
        "Also its derivatives: a change of the state, of `q` before that of `u`, is after the step `a` times that before it and `b` times that of `tau`.",
        "A change of `q` has one entry per speed, along the axes of `u`.",
        STATE_IN_PLACE,
    ];
    let arguments = states().into_iter().chain(matrices.iter().cloned());
    let own = RuntimeKind::Linearized(kind.module);
    function(kind.linearized, &doc, arguments, own)
}

fn doc_of_step(kind: &Kind) -> String {
    let Kind { module, what, .. } = kind;
    format!(
        "The state after {what} of the time `dt`, in which `tau` stays constant: `kane::discrete::{module}` of the runtime. Quaternions of about length one have it afterwards."
    )
}

/// What a step is given, and what it writes.
fn states() -> [Declared; 6] {
    let [q, u, tau] = [Argument::Q, Argument::U, Argument::Tau].map(Argument::declared);
    let dt = Declared {
        unit: Unit::Of(&["s"]),
        ..Declared::read("dt", Element::Scalar, "the time of the step")
    };
    let [q_after, u_after] = [after(&q), after(&u)];
    [q, u, tau, dt, q_after, u_after]
}

/// The matrices of a linearized step, `2 NU` by `2 NU` and `2 NU` by `NU`.
fn matrices() -> [Declared; 2] {
    let n_speeds = || N_SPEEDS.to_owned();
    let [direction, speed, force] = [Unit::DIRECTIONS, Unit::SPEEDS, Unit::FORCES];
    let changes = [direction, speed];
    let matrix = |declared, columns: Length, by: &[Unit]| {
        let pairs = changes
            .iter()
            .flat_map(|of| by.iter().map(move |by| (of, by)));
        Declared {
            lengths: vec![Length::Twice(n_speeds()), columns],
            unit: Unit::quotients(pairs),
            ..declared
        }
    };
    let a = written("a", "how the state before the step changes that after it");
    let b = written("b", "how `tau` changes the state after the step");
    [
        matrix(a, Length::Twice(n_speeds()), &changes),
        matrix(b, Length::Constant(n_speeds()), &[force]),
    ]
}

/// As an array of directions: one entry per speed.
fn of_directions(declared: Declared) -> Declared {
    Declared {
        lengths: vec![Length::Constant(N_SPEEDS.to_owned())],
        unit: Unit::DIRECTIONS,
        ..declared
    }
}

/// The same afterwards.
fn after(of: &Declared) -> Declared {
    Declared {
        name: format!("{}_after", of.name),
        access: Access::Written,
        meaning: format!("{} afterwards", of.meaning).into(),
        ..of.clone()
    }
}

fn written(name: &str, meaning: &'static str) -> Declared {
    Declared {
        meaning: meaning.into(),
        ..Declared::written(name, Element::Scalar)
    }
}

fn function(
    name: &str,
    doc: &[&str],
    own: impl IntoIterator<Item = Declared>,
    kind: RuntimeKind,
) -> RuntimeFunction {
    let signature = Signature {
        name: name.to_owned(),
        doc: doc.iter().map(|&line| line.to_owned()).collect(),
        arguments: [Declared::prepared()].into_iter().chain(own).collect(),
    };
    RuntimeFunction { signature, kind }
}
