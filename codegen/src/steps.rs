//! The steps of `kane::discrete` that C has: what they are called, and which requests they need.

/// A step: under which condition, what it computes, by which scheme.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Step {
    pub(crate) condition: Condition,
    pub(crate) way: Way,
    pub(crate) scheme: Scheme,
}

/// What acts during a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Condition {
    /// `tau` alone.
    Free,
    /// Loads, too.
    Loaded,
    /// What drives the prescribed speeds, too.
    Driven,
}

/// What a step computes.
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

/// How a step reaches the state after it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Scheme {
    Euler,
    Rk4,
}

impl Condition {
    const ALL: [Self; 3] = [Self::Free, Self::Loaded, Self::Driven];

    /// The word before a step's name.
    fn before(self) -> &'static str {
        match self {
            Self::Free => "",
            Self::Loaded => "loaded_",
            Self::Driven => "driven_",
        }
    }

    /// The dynamics of a system under it.
    fn dynamics(self) -> &'static str {
        match self {
            Self::Free => "forward_dynamics",
            Self::Loaded => "loaded_forward_dynamics",
            Self::Driven => "hybrid_dynamics",
        }
    }

    /// What takes the system's place, of `kane::conditions`.
    fn system(self) -> Option<&'static str> {
        match self {
            Self::Free => None,
            Self::Loaded => Some("Loaded"),
            Self::Driven => Some("Driven"),
        }
    }
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
    pub(crate) fn function(self) -> &'static str {
        match self {
            Self::Step => "step",
            Self::Linearized => "linearized",
            Self::Forward => "forward",
            Self::Adjoint => "adjoint",
            Self::ByParameters => "by_parameters",
            Self::ForwardWithParameters => "forward_with_parameters",
            Self::AdjointWithParameters => "adjoint_with_parameters",
        }
    }

    /// True where values set at run time are no constants.
    fn is_by_parameters(self) -> bool {
        match self {
            Self::Step | Self::Linearized | Self::Forward | Self::Adjoint => false,
            Self::ByParameters | Self::ForwardWithParameters | Self::AdjointWithParameters => true,
        }
    }
}

impl Scheme {
    const ALL: [Self; 2] = [Self::Euler, Self::Rk4];

    /// The module of `kane::discrete`.
    pub(crate) fn module(self) -> &'static str {
        match self {
            Self::Euler => "euler",
            Self::Rk4 => "rk4",
        }
    }
}

impl Step {
    /// All that there are, in the order of C's header: derivatives by values set at run time under no condition alone.
    pub(crate) fn all() -> impl Iterator<Item = Self> {
        let ways = Condition::ALL
            .into_iter()
            .flat_map(|condition| Way::ALL.map(|way| (condition, way)));
        let there_are = ways
            .filter(|(condition, way)| *condition == Condition::Free || !way.is_by_parameters());
        there_are.flat_map(|(condition, way)| {
            Scheme::ALL.map(|scheme| Self {
                condition,
                way,
                scheme,
            })
        })
    }

    /// What C calls it, behind a module's name.
    pub(crate) fn name(self) -> String {
        let (before, scheme) = (self.condition.before(), self.scheme.module());
        format!("{before}{scheme}_{}", self.way.function())
    }

    /// The function of the runtime crate, and what takes the system's place: `kane::discrete::rk4::step` with `kane::conditions::Loaded`.
    pub(crate) fn of_runtime(self) -> String {
        let function = format!(
            "`kane::discrete::{}::{}`",
            self.scheme.module(),
            self.way.function()
        );
        match self.condition.system() {
            None => function,
            Some(system) => format!("{function} with `kane::conditions::{system}`"),
        }
    }

    /// The requests that it needs.
    pub(crate) fn needs(self) -> Vec<String> {
        let dynamics = self.condition.dynamics();
        let plain = dynamics.to_owned();
        let linearized = format!("{dynamics}+d({dynamics})/d(q, u, tau)");
        match self.way {
            Way::Step => vec![plain],
            Way::Linearized => vec![linearized],
            Way::Forward => vec![plain, format!("jvp({dynamics}; q, u, tau)")],
            Way::Adjoint => vec![plain, format!("vjp({dynamics}; q, u, tau)")],
            Way::ByParameters => {
                let values = match self.scheme {
                    Scheme::Euler => plain,
                    Scheme::Rk4 => linearized,
                };
                vec![values, format!("d({dynamics})/d(parameters)")]
            }
            Way::ForwardWithParameters => {
                vec![plain, format!("jvp({dynamics}; q, u, tau, parameters)")]
            }
            Way::AdjointWithParameters => {
                vec![plain, format!("vjp({dynamics}; q, u, tau, parameters)")]
            }
        }
    }
}
