//! A part of a request: a function of the catalogue, and what it is of.

use super::{
    argument::Argument,
    candidate::Formulation,
    derived::Derived,
    function::{FrameFunction, Function, Output},
    shape::Axis,
    subject::{Axes, Subject},
    syntax::written,
    terms,
};
use crate::{recursive::Plan, tree::Tree};

/// What stands behind a frame whose own axes are meant.
pub(super) const LOCAL: &str = "local";

/// A part of a request, on the tree of a model.
#[derive(Clone, Debug)]
pub enum Part {
    /// A function of the whole system.
    System(&'static Function),
    /// A function of a frame.
    Frame(&'static FrameFunction, Subject),
}

/// A function of a frame as it is asked for: `velocity(tool0, local)`.
pub(super) fn text_of(function: &FrameFunction, frame: &str, axes: Axes) -> String {
    let (name, frame) = (function.name, written(frame));
    match axes {
        Axes::Inertial => format!("{name}({frame})"),
        Axes::Local => format!("{name}({frame}, {LOCAL})"),
    }
}

impl Part {
    /// As it is asked for.
    pub fn text(&self) -> String {
        match self {
            Self::System(function) => function.name.to_owned(),
            Self::Frame(function, subject) => text_of(function, &subject.name, subject.axes),
        }
    }

    /// Its name in generated code: `bias`, `tool0_velocity_local`.
    pub fn name(&self) -> String {
        match self {
            Self::System(function) => function.name.to_owned(),
            Self::Frame(function, subject) => {
                let local = match subject.axes {
                    Axes::Inertial => String::new(),
                    Axes::Local => format!("_{LOCAL}"),
                };
                format!("{}_{}{local}", subject.identifier, function.name)
            }
        }
    }

    /// What it is given besides the parameters, in order.
    pub fn arguments(&self) -> &'static [Argument] {
        match self {
            Self::System(function) => function.arguments,
            Self::Frame(function, _) => function.arguments,
        }
    }

    /// What it writes, in order.
    pub fn outputs(&self) -> &'static [Output] {
        match self {
            Self::System(function) => function.outputs,
            Self::Frame(function, _) => function.outputs,
        }
    }

    /// Lines of documentation.
    pub fn doc(&self) -> Vec<String> {
        match self {
            Self::System(function) => function.doc.iter().map(ToString::to_string).collect(),
            Self::Frame(function, subject) => {
                let axes = match subject.axes {
                    Axes::Inertial => "inertial components",
                    Axes::Local => "components along the frame's own axes",
                };
                let frame = format!("`{}`", subject.name.escape_debug());
                let line = |line: &&str| line.replace("{frame}", &frame).replace("{axes}", axes);
                function.doc.iter().map(line).collect()
            }
        }
    }

    /// True where accelerations are solved for.
    pub fn solves(&self) -> bool {
        match self {
            Self::System(function) => function.solves,
            Self::Frame(function, _) => function.solves,
        }
    }

    /// The formulations in which it can be derived.
    pub fn formulations(&self) -> Vec<Formulation> {
        match self {
            Self::System(function) => function.formulations(),
            Self::Frame(function, _) => function.formulations(),
        }
    }

    /// How many terms the notes' sums have at least.
    pub(super) fn literal_terms(&self, tree: &Tree) -> usize {
        match self {
            Self::System(function) => function.literal_terms(tree),
            Self::Frame(function, _) => function.literal_terms(tree),
        }
    }

    /// How many numbers it writes, or somewhat more, where joints follow others.
    pub(super) fn n_numbers(&self, tree: &Tree) -> usize {
        let of_output = |output: &Output| {
            let length = |axis: &Axis| match axis {
                Axis::Columns => terms::of_vector(tree),
                Axis::SpeedPairs => terms::pairs(tree),
                axis => axis.length(tree, 0),
            };
            output.shape.axes.iter().map(length).product::<usize>()
        };
        self.outputs().iter().map(of_output).sum()
    }

    /// True where this formulation needs a plan.
    pub(super) fn takes_plan(&self, formulation: Formulation) -> bool {
        match self {
            Self::System(function) => function.candidate(formulation).takes_plan(),
            Self::Frame(function, _) => function.candidate(formulation).takes_plan(),
        }
    }

    /// Derives it after others, in the same graph, by its candidate of this formulation or by its first.
    pub(super) fn derive_in(
        &self,
        derived: &mut Derived,
        tree: &Tree,
        formulation: Formulation,
        plan: &Plan,
    ) {
        match self {
            Self::System(function) => {
                let candidate = function.candidate(formulation);
                candidate.derive_in(derived, tree, plan);
            }
            Self::Frame(function, subject) => {
                let candidate = function.candidate(formulation);
                candidate.derive_in(derived, tree, plan, subject);
            }
        }
    }
}
