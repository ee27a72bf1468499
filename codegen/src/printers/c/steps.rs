//! Steps that C gets of the runtime crate: under each condition, with each kind of derivatives, by each scheme.

use super::declared::{after, signature, written};
use crate::{
    functions::{
        Access, Argument, Declared, Element, Length, N_PARAMETERS, N_SPEEDS, Signature, Unit,
    },
    listing::Module,
    words::{STEP_CONDITIONS, STEP_SCHEMES, STEP_WAYS},
};

/// What may be written where it is read.
const STATE_IN_PLACE: &str =
    "`q_after` may lead to the same array as `q`, and `u_after` to the same as `u`.";
const GRADIENT_IN_PLACE: &str = "`q_gradient` may lead to the same array as `q_multiplier`, and `u_gradient` to the same as `u_multiplier`.";

/// What a change of coordinates is.
const PER_SPEED: &str = "A change of `q` has one entry per speed, along the axes of `u`.";

/// A step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Step {
    /// Under which condition.
    pub(crate) condition: Condition,
    /// What it computes.
    pub(crate) way: Way,
    /// How it reaches the state after it.
    pub(crate) scheme: Scheme,
}

/// What acts during a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Condition {
    /// `tau` alone.
    Free,
    /// `kane::conditions::Loaded`: loads, too.
    Loaded,
    /// `kane::conditions::Driven`: what drives the prescribed speeds, too.
    Driven,
}

/// What a step computes: the function of a module of `kane::discrete`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Way {
    Step,
    Linearized,
    Forward,
    Adjoint,
    ByParameters,
    ForwardWithParameters,
    AdjointWithParameters,
}

/// A module of `kane::discrete`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Scheme {
    Euler,
    Rk4,
}

/// Those that can be called with the functions of a module.
pub(super) fn of(module: &Module) -> Vec<(Step, Signature)> {
    let mut all = Vec::new();
    for condition in [Condition::Free, Condition::Loaded, Condition::Driven] {
        for way in Way::ALL {
            let schemes = [Scheme::Euler, Scheme::Rk4].into_iter();
            let steps = schemes.map(|scheme| Step {
                condition,
                way,
                scheme,
            });
            all.extend(steps.filter(|step| step.has_what_it_needs(module)));
        }
    }
    let declared = all.into_iter().map(|step: Step| (step, step.signature()));
    declared.collect()
}

impl Way {
    const ALL: [Self; 7] = [
        Self::Step,
        Self::Linearized,
        Self::Forward,
        Self::Adjoint,
        Self::ByParameters,
        Self::ForwardWithParameters,
        Self::AdjointWithParameters,
    ];

    /// The function of `kane::discrete`.
    pub(crate) fn name(self) -> &'static str {
        STEP_WAYS[self as usize]
    }

    /// Behind the name of the dynamics, the trait that it needs besides that of the dynamics.
    fn of_trait(self) -> &'static str {
        match self {
            Self::Step => "",
            Self::Linearized => "AndDerivatives",
            Self::Forward => "Jvp",
            Self::Adjoint => "Vjp",
            Self::ByParameters => "ByParameters",
            Self::ForwardWithParameters => "ParametersJvp",
            Self::AdjointWithParameters => "ParametersVjp",
        }
    }
}

impl Scheme {
    /// The module of `kane::discrete`.
    pub(crate) fn module(self) -> &'static str {
        STEP_SCHEMES[self as usize]
    }

    fn what(self) -> &'static str {
        match self {
            Self::Euler => "a semi-implicit Euler step",
            Self::Rk4 => "a Runge-Kutta step of fourth order",
        }
    }
}

impl Condition {
    /// The dynamics of such a system, and how traits of it begin.
    fn dynamics(self) -> (&'static str, &'static str) {
        match self {
            Self::Free => ("forward_dynamics", "ForwardDynamics"),
            Self::Loaded => ("loaded_forward_dynamics", "LoadedForwardDynamics"),
            Self::Driven => ("hybrid_dynamics", "HybridDynamics"),
        }
    }

    fn stays(self) -> &'static str {
        match self {
            Self::Free => "`tau` stays constant",
            Self::Loaded => "`tau` and `loads` stay constant",
            Self::Driven => "`tau` and the accelerations of the prescribed speeds stay constant",
        }
    }

    /// What is not read.
    fn unread(self) -> Option<&'static str> {
        let driven = "Entries of `tau` of prescribed speeds are not read, nor those of `u_dot` of the others.";
        (self == Self::Driven).then_some(driven)
    }
}

impl Step {
    fn has_what_it_needs(self, module: &Module) -> bool {
        let (dynamics, prefix) = self.condition.dynamics();
        let mut parts = module
            .functions
            .iter()
            .filter_map(|one| one.catalogue_part.as_ref());
        let mut has_dynamics = || parts.any(|part| part.function.name == dynamics);
        let has = |own: Way| {
            let mut traits = module
                .functions
                .iter()
                .filter_map(|one| one.derivative_trait.as_ref());
            traits.any(|known| known.name.strip_prefix(prefix) == Some(own.of_trait()))
        };
        match (self.way, self.scheme) {
            (Way::Step, _) => has_dynamics(),
            (Way::Linearized, _) => has(Way::Linearized),
            (Way::ByParameters, Scheme::Rk4) => has(Way::ByParameters) && has(Way::Linearized),
            (way, _) => has(way) && has_dynamics(),
        }
    }

    fn signature(self) -> Signature {
        let condition = STEP_CONDITIONS[self.condition as usize];
        let (scheme, way) = (self.scheme.module(), self.way.name());
        let doc = self.doc();
        let doc: Vec<&str> = doc.iter().map(String::as_str).collect();
        let arguments = self.given().into_iter().chain(self.others());
        signature(&format!("{condition}{scheme}_{way}"), &doc, arguments)
    }

    fn doc(self) -> Vec<String> {
        let (module, way) = (self.scheme.module(), self.way.name());
        let step = format!(
            "{} of the time `dt`, in which {}: `kane::discrete::{module}::{way}` of the runtime.",
            self.scheme.what(),
            self.condition.stays(),
        );
        let state = format!(
            "The state after {step} Quaternions whose length is nearly one have length one afterwards."
        );
        let lines = match self.way {
            Way::Step => vec![state, STATE_IN_PLACE.to_owned()],
            Way::Linearized => vec![
                state,
                "Also its derivatives: a change of the state, of `q` before that of `u`, is after the step `a` times that before it and `b` times that of `tau`.".to_owned(),
                PER_SPEED.to_owned(),
                STATE_IN_PLACE.to_owned(),
            ],
            Way::Forward | Way::ForwardWithParameters => vec![
                state,
                "Also how it changes, to first order, with what the step is given.".to_owned(),
                PER_SPEED.to_owned(),
                format!("{STATE_IN_PLACE} Changes may be written where they are read, too."),
            ],
            Way::Adjoint | Way::AdjointWithParameters => vec![
                format!("The gradient of a cost by what the step is given, from its gradient by the state after the step. {PER_SPEED}"),
                format!("The step is {step}"),
                GRADIENT_IN_PLACE.to_owned(),
            ],
            Way::ByParameters => vec![
                format!("The derivatives by all values set at run time, in the order of `PARAMETER_NAMES`, of the state after {step}"),
                PER_SPEED.to_owned(),
            ],
        };
        let unread = self.condition.unread().map(str::to_owned);
        lines.into_iter().chain(unread).collect()
    }

    /// What every step is given.
    fn given(self) -> Vec<Declared> {
        let [q, u, tau] = [Argument::Q, Argument::U, Argument::Tau].map(Argument::declared);
        let dt = Declared {
            unit: Unit::Of(&["s"]),
            ..Declared::read("dt", Element::Scalar, "the time of the step")
        };
        match self.condition {
            Condition::Free => vec![q, u, tau, dt],
            Condition::Loaded => vec![q, u, tau, Argument::Loads.declared(), dt],
            Condition::Driven => vec![q, u, Argument::UDot.declared(), tau, dt],
        }
    }

    /// What it is given besides, and what it writes.
    fn others(self) -> Vec<Declared> {
        let state = [Argument::Q, Argument::U].map(|own| after(&own.declared()));
        match self.way {
            Way::Step => state.to_vec(),
            Way::Linearized => state.into_iter().chain(matrices()).collect(),
            Way::Forward => changes(state, &[]),
            Way::ForwardWithParameters => changes(state, &[Argument::ParametersDirection]),
            Way::Adjoint => gradients(&[]),
            Way::AdjointWithParameters => gradients(&[Argument::ParametersDirection]),
            Way::ByParameters => by_parameters().to_vec(),
        }
    }
}

/// What changes, and the state and its change afterwards.
fn changes(state: [Declared; 2], others: &[Argument]) -> Vec<Declared> {
    let own = [Argument::QDirection, Argument::UDirection].map(Argument::declared);
    let others = [Argument::TauDirection].iter().chain(others);
    let written = own.clone().map(|own| after(&own));
    own.into_iter()
        .chain(others.map(|own| own.declared()))
        .chain(state)
        .chain(written)
        .collect()
}

/// The multiplier of the state afterwards, and gradients by what the step begins with.
fn gradients(others: &[Argument]) -> Vec<Declared> {
    let renamed = |own: &Argument, word: &str, of: &str| {
        let own = own.declared();
        let stem = own.name.trim_end_matches("_direction");
        Declared {
            name: format!("{stem}_{word}"),
            meaning: format!("the gradient of a cost by `{stem}`{of}").into(),
            unit: Unit::UNKNOWN,
            ..own
        }
    };
    let state = [Argument::QDirection, Argument::UDirection];
    let multipliers = state.iter();
    let multipliers = multipliers.map(|own| renamed(own, "multiplier", " after the step"));
    let all = state.iter().chain(&[Argument::TauDirection]).chain(others);
    let gradients = all.map(|own| Declared {
        access: Access::Written,
        ..renamed(own, "gradient", "")
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
