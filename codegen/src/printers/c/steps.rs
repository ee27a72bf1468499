//! How the steps that C gets of the runtime crate are declared.

use super::declared::{after, signature, written};
use crate::{
    functions::{
        Access, Argument, Declared, Element, Length, N_PARAMETERS, N_SPEEDS, Signature, TRAITS,
        Unit,
    },
    listing::Module,
    steps::{Condition, Scheme, Step, Way},
};

/// What may be written where it is read.
const STATE_IN_PLACE: &str =
    "`q_after` may lead to the same array as `q`, and `u_after` to the same as `u`.";
const GRADIENT_IN_PLACE: &str = "`q_gradient` may lead to the same array as `q_multiplier`, and `u_gradient` to the same as `u_multiplier`.";

const CHANGE_IN_PLACE: &str =
    "So may `q_direction_after` lead to `q_direction`, and `u_direction_after` to `u_direction`.";

/// What the prescribed speeds of a driven system make of its arguments.
const IDLE: &str = "Entries of `tau` of prescribed speeds have no effect, nor have those of `u_dot` of the others; all must hold numbers.";

/// What a change of coordinates is.
const PER_SPEED: &str = "A change of `q` has one entry per speed, along the axes of `u`.";

/// Those that can be called with the functions of a module.
pub(super) fn of(module: &Module) -> Vec<(Step, Signature)> {
    let can_be_called = |step: &Step| step.needs().iter().all(|request| has(module, request));
    let steps = Step::all().filter(can_be_called);
    steps.map(|step| (step, signature_of(step))).collect()
}

/// True where the module's functions include one for this request, and its trait.
fn has(module: &Module, request: &str) -> bool {
    let functions = module.functions.iter();
    let mut traits = TRAITS.into_iter();
    if let Some((_, name)) = traits.find(|(text, _)| *text == request) {
        let mut own = functions.filter_map(|function| function.derivative_trait.as_ref());
        return own.any(|own| own.name == name);
    }
    functions
        .filter_map(|function| function.catalogue_part.as_ref())
        .any(|own| own.function.name == request)
}

/// What stays as it is during a step.
fn stays(condition: Condition) -> &'static str {
    match condition {
        Condition::Free => "`tau` stays constant",
        Condition::Loaded => "`tau` and `loads` stay constant",
        Condition::Driven => "`tau` and the accelerations of the prescribed speeds stay constant",
    }
}

/// What scheme it is, in words.
fn what(scheme: Scheme) -> &'static str {
    match scheme {
        Scheme::Euler => "a semi-implicit Euler step",
        Scheme::Rk4 => "a Runge-Kutta step of fourth order",
    }
}

fn signature_of(step: Step) -> Signature {
    let doc = doc(step);
    let doc: Vec<&str> = doc.iter().map(String::as_str).collect();
    let arguments = given(step.condition).into_iter().chain(others(step.way));
    signature(&step.name(), &doc, arguments)
}

fn doc(step: Step) -> Vec<String> {
    let Step {
        condition,
        way,
        scheme,
    } = step;
    let step = format!(
        "{} of the time `dt`, in which {}: {} of the runtime.",
        what(scheme),
        stays(condition),
        step.of_runtime(),
    );
    let state = format!(
        "The state after {step} Quaternions whose length is nearly one have length one afterwards."
    );
    let lines = match way {
        Way::Step => vec![state, STATE_IN_PLACE.to_owned()],
        Way::Linearized => vec![
            state,
            "Also its derivatives: a change of the state, of `q` before that of `u`, is after the step `a` times that before it and `b` times that of `tau`.".to_owned(),
            PER_SPEED.to_owned(),
            STATE_IN_PLACE.to_owned(),
            format!("Beside the dynamics it takes some {} matrices of `NU` by `NU` on the stack.", n_matrices(condition, scheme)),
        ],
        Way::Forward | Way::ForwardWithParameters => vec![
            state,
            format!("Also how it changes, to first order, with `q`, `u`{}. {PER_SPEED}", and_tau(way)),
            format!("{STATE_IN_PLACE} {CHANGE_IN_PLACE}"),
        ],
        Way::Adjoint | Way::AdjointWithParameters => vec![
            format!("The gradient of a cost by `q`, `u`{}, from its gradient by the state after the step: `q_multiplier` and `u_multiplier`. {PER_SPEED}", and_tau(way)),
            format!("The step is {step}"),
            GRADIENT_IN_PLACE.to_owned(),
        ],
        Way::ByParameters => vec![
            format!("The derivatives by all values set at run time, in the order of `PARAMETER_NAMES`, of the state after {step}"),
            PER_SPEED.to_owned(),
        ],
    };
    let idle = (condition == Condition::Driven).then(|| IDLE.to_owned());
    lines.into_iter().chain(idle).collect()
}

/// How many matrices a linearized step has on the stack, measured, about.
fn n_matrices(condition: Condition, scheme: Scheme) -> u32 {
    let own = match scheme {
        Scheme::Euler => 20,
        Scheme::Rk4 => 30,
    };
    match condition {
        Condition::Free | Condition::Loaded => own,
        Condition::Driven => own + 3,
    }
}

/// What a product is by, behind the state.
fn and_tau(way: Way) -> &'static str {
    match way {
        Way::ForwardWithParameters | Way::AdjointWithParameters => {
            ", `tau` and all values set at run time, in the order of `PARAMETER_NAMES`"
        }
        _ => " and `tau`",
    }
}

/// What every step is given.
fn given(condition: Condition) -> Vec<Declared> {
    let [q, u, tau] = [Argument::Q, Argument::U, Argument::Tau].map(Argument::declared);
    let dt = Declared {
        unit: Unit::Of(&["s"]),
        ..Declared::read("dt", Element::Scalar, "the time of the step")
    };
    match condition {
        Condition::Free => vec![q, u, tau, dt],
        Condition::Loaded => vec![q, u, tau, Argument::Loads.declared(), dt],
        Condition::Driven => vec![q, u, Argument::UDot.declared(), tau, dt],
    }
}

/// What a step is given besides, and what it writes.
fn others(way: Way) -> Vec<Declared> {
    let state = [Argument::Q, Argument::U].map(|own| after(&own.declared()));
    match way {
        Way::Step => state.to_vec(),
        Way::Linearized => state.into_iter().chain(matrices()).collect(),
        Way::Forward => changes(state, &[]),
        Way::ForwardWithParameters => changes(state, &[Argument::ParametersDirection]),
        Way::Adjoint => gradients(&[]),
        Way::AdjointWithParameters => gradients(&[(
            "parameters",
            "all values set at run time, in the order of `PARAMETER_NAMES`",
            Argument::ParametersDirection,
        )]),
        Way::ByParameters => by_parameters().to_vec(),
    }
}

/// What changes, and the state and its change afterwards.
fn changes(state: [Declared; 2], others: &[Argument]) -> Vec<Declared> {
    let own = [Argument::QDirection, Argument::UDirection].map(Argument::declared);
    let others = [Argument::TauDirection].iter().chain(others);
    let written = [
        (&own[0], "the change of `q` after the step"),
        (&own[1], "that of `u`"),
    ];
    let written = written.map(|(own, meaning)| Declared {
        meaning: meaning.into(),
        ..after(own)
    });
    own.into_iter()
        .chain(others.map(|own| own.declared()))
        .chain(state)
        .chain(written)
        .collect()
}

/// The multiplier of the state afterwards, and gradients by what the step begins with: by what they are called, by what they are, and
/// what a direction of it is like.
fn gradients(others: &[(&str, &str, Argument)]) -> Vec<Declared> {
    let state = [
        ("q", "`q`", Argument::QDirection),
        ("u", "`u`", Argument::UDirection),
    ];
    let tau = [("tau", "`tau`", Argument::TauDirection)];
    let like = |name: String, meaning: String, like: Argument| Declared {
        name,
        meaning: meaning.into(),
        unit: Unit::UNKNOWN,
        ..like.declared()
    };
    let multipliers = state.iter().map(|(name, by, argument)| {
        let meaning = format!("the gradient of a cost by {by} after the step");
        like(format!("{name}_multiplier"), meaning, *argument)
    });
    let all = state.iter().chain(&tau).chain(others);
    let gradients = all.map(|(name, by, argument)| Declared {
        access: Access::Written,
        ..like(
            format!("{name}_gradient"),
            format!("the gradient of the cost by {by}"),
            *argument,
        )
    });
    multipliers.chain(gradients).collect()
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

/// Those by values set at run time, `NU` by `PARAMETERS_LEN` each.
fn by_parameters() -> [Declared; 2] {
    [
        written(
            "q_by_parameters",
            "how values set at run time change `q` after the step",
        ),
        written(
            "u_by_parameters",
            "how values set at run time change `u` after the step",
        ),
    ]
    .map(|own| Declared {
        lengths: [N_SPEEDS, N_PARAMETERS]
            .map(|length| Length::Constant(length.to_owned()))
            .to_vec(),
        ..own
    })
}
