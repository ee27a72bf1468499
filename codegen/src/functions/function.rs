//! A function as the catalogue describes it: what it is given, what it writes, what that means, how it is derived.

use std::borrow::Cow;

use super::{
    argument::Argument,
    derivation::{Derivation, EitherWay},
    formulation::Formulation,
    multiplier::MULTIPLIER,
    shape::{Dimension, Shape},
    subject::{Subject, View},
    terms::Terms,
    told::{Beside, KnownMatrix, ReadOff},
    unit::Unit,
};
use crate::{
    expr::{Expr, ExprGraph},
    recursive::{Plan, Technique},
    solve::SpeedMatrix,
    tree::Tree,
};

/// The constant that says of which speeds the accelerations are given.
pub const PRESCRIBED: &str = "PRESCRIBED";

/// A function of the generated module.
#[derive(Debug)]
pub struct Function {
    /// What it is of.
    pub of: Of,
    /// The name, of the free function and of the trait's method; of a frame's function the frame stands before it.
    pub name: &'static str,
    /// The runtime crate's trait; `None` for `q_dot` and `normalize`, which are part of `System`.
    pub trait_name: Option<&'static str>,
    /// What it is given besides the parameters, in order.
    pub arguments: &'static [Argument],
    /// What it writes, in order.
    pub outputs: &'static [Output],
    /// True for a function of the default set.
    pub is_default: bool,
    /// What of the mass matrix it takes beyond its entries.
    pub(super) mass_matrix: MassMatrixUse,
    /// Techniques that say something of few functions, of which it is one.
    pub(super) techniques: &'static [Technique],
    /// True where accelerations of the prescribed speeds are given, and forces of the others: a constant says of which.
    pub prescribes: bool,
    /// By one of its arguments alone, the function whose entries are its derivatives.
    pub(super) derivatives_are: &'static [(Argument, &'static Self)],
    /// Its derivatives, where there is a cheaper way to them than to differentiate the values.
    pub(super) derivatives: Option<DerivativesFn>,
    /// The function whose plan suits that way: most of it are expressions such as this one's.
    pub(super) derivatives_like: Option<&'static Self>,
    /// What its whole derivatives find beside, in that way.
    pub(super) derivatives_tell: &'static [KnownMatrix],
    /// What its recursion finds beside its entries.
    pub(super) beside: Option<Beside>,
    /// How its entries are read off what another part of a joined function finds.
    pub(super) read_off: Option<ReadOff>,
    /// The forces that given accelerations need, where its output is the accelerations that given forces make.
    pub(super) inverse_dynamics: Option<InverseDynamicsFn>,
    /// Lines of documentation: meaning, equation, frame, unit, signs, the aliases people search for. In that of a
    /// function of a frame words in braces stand for what the frame is and how it is seen; the name of an output in braces stands
    /// for its unit. The first sentence says what an only output means.
    pub doc: &'static [&'static str],
    /// How its values are derived.
    pub(super) derivation: Derivation,
    /// How many terms the notes' sums have at least.
    pub(super) terms: Terms,
}

/// By each argument that it tells, how the entries of the outputs change: rows are these, output after output, columns speeds.
#[derive(Clone, Copy, Debug)]
pub(super) enum DerivativesFn {
    /// Of the whole system.
    OfSystem(fn(&mut ExprGraph, &Tree, &Plan) -> ByArguments),
    /// Of frames.
    OfFrames(fn(&mut ExprGraph, &Tree, &Plan, &Subject) -> ByArguments),
}

impl DerivativesFn {
    /// Derives them, of the frames that the function is of.
    pub(super) fn derive(
        self,
        graph: &mut ExprGraph,
        tree: &Tree,
        plan: &Plan,
        subject: Option<&Subject>,
    ) -> ByArguments {
        match self {
            Self::OfSystem(derive) => derive(graph, tree, plan),
            Self::OfFrames(derive) => {
                let subject = subject.expect("functions: what is of a frame has one");
                derive(graph, tree, plan, subject)
            }
        }
    }
}

/// How a function changes with what it is given, a matrix for each argument; and its values, where the matrices needed them.
#[derive(Debug, Default)]
pub(super) struct ByArguments {
    pub(super) by: Vec<(Argument, Vec<Vec<Expr>>)>,
    pub(super) values: Option<Vec<Expr>>,
    /// The mass matrix, where they need it.
    pub(super) mass: Option<SpeedMatrix>,
}

/// Forces that accelerations need, which are inputs.
pub(super) type InverseDynamicsFn = EitherWay;

/// What a function is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Of {
    /// The whole system: `bias`.
    System,
    /// A frame that may be seen in these ways: `pose(tool0)`.
    Frame(&'static [View]),
    /// Frames, one or more, that may be seen in these ways: `operational_inverse_inertia(left_foot, right_foot)`.
    Frames(&'static [View]),
}

/// What a function takes of the mass matrix beyond its entries.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum MassMatrixUse {
    /// Nothing.
    None,
    /// Its factors, whatever the plan: articulated bodies have none.
    Factors,
    /// Accelerations of given forces, by factors or by articulated bodies.
    Accelerations,
    /// The inverse, whole or packed, by factors or by articulated bodies.
    Inverse,
}

/// What most functions are, where the catalogue does not say otherwise.
pub(super) const PLAIN: Function = Function {
    of: Of::System,
    name: "",
    trait_name: None,
    arguments: &[],
    outputs: &[],
    is_default: false,
    mass_matrix: MassMatrixUse::None,
    techniques: &[],
    prescribes: false,
    derivatives_are: &[],
    derivatives: None,
    derivatives_like: None,
    derivatives_tell: &[],
    beside: None,
    read_off: None,
    inverse_dynamics: None,
    doc: &[],
    derivation: Derivation::Notes(|_, _| unreachable!("each function says how it is derived")),
    terms: Terms::Few,
};

/// An output of a function.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Output {
    /// The argument's name.
    pub name: Cow<'static, str>,
    /// The array that is written.
    pub shape: Shape,
    /// What it is multiplied by where its function is differentiated: the argument's name.
    pub(super) multiplier: &'static str,
    /// What it means, in words, as in [`Function::doc`]; empty where the first sentence there says it.
    pub(super) meaning: Cow<'static, str>,
    /// The units of its entries.
    pub unit: Unit,
}

impl Output {
    /// The only output of a function, with a name of the catalogue.
    pub(super) const fn new(name: &'static str, shape: Shape, unit: Unit) -> Self {
        Self::of_several((name, MULTIPLIER), shape, unit, "")
    }

    /// One of several, which have a multiplier each.
    pub(super) const fn of_several(
        (name, multiplier): (&'static str, &'static str),
        shape: Shape,
        unit: Unit,
        meaning: &'static str,
    ) -> Self {
        Self {
            name: Cow::Borrowed(name),
            shape,
            multiplier,
            meaning: Cow::Borrowed(meaning),
            unit,
        }
    }

    /// One of a derivative.
    pub(super) fn derived(name: String, shape: Shape, unit: Unit, meaning: String) -> Self {
        Self {
            name: name.into(),
            meaning: meaning.into(),
            ..Self::new("", shape, unit)
        }
    }
}

impl Function {
    /// The formulations in which the function can be derived; of two that need as many operations the first is emitted.
    pub fn formulations(&self) -> &'static [Formulation] {
        self.derivation.formulations()
    }

    /// True where a module has it whatever is asked for, because the runtime's trait `System` needs it.
    pub fn is_always_generated(&self, has_quaternions: bool) -> bool {
        self.trait_name.is_none() && (has_quaternions || !self.normalizes())
    }

    /// True where it brings the quaternions that it is given to length one.
    pub fn normalizes(&self) -> bool {
        self.name == "normalize"
    }

    /// True where the cost of its values may depend on whether a plan uses the technique.
    pub(super) fn heeds(&self, technique: Technique) -> bool {
        match technique {
            Technique::Regroup | Technique::Balance | Technique::SecondMoments => {
                self.reads_inertias()
            }
            Technique::Articulated | Technique::LinkAxes | Technique::Fall => self.solves(),
            Technique::Carriers => self.mass_matrix == MassMatrixUse::Inverse,
            Technique::Inward => self.passes_frames(),
            Technique::Levers => self.passes_frames() || self.has_inertial_columns(),
            Technique::Weights | Technique::Rates => self.techniques.contains(&technique),
            Technique::DirectDerivatives
            | Technique::Reverse
            | Technique::Lockstep
            | Technique::Reuse => false,
            Technique::Slide
            | Technique::Turn
            | Technique::Parallel
            | Technique::Shortcut
            | Technique::Factor => true,
        }
    }

    /// How frames move does not depend on inertias.
    fn reads_inertias(&self) -> bool {
        match self.derivation {
            Derivation::Notes(_) | Derivation::Columns(_) => false,
            Derivation::EitherWay(_) => true,
            Derivation::OfFrames(_) => self.mass_matrix != MassMatrixUse::None,
        }
    }

    /// True for what depends only on where frames are, and what moves them.
    fn passes_frames(&self) -> bool {
        let mut arguments = self.arguments.iter();
        self.of != Of::System
            && arguments.all(|argument| matches!(argument, Argument::Q | Argument::Point))
    }

    /// True for vectors along inertial axes by speeds, of all bodies together.
    fn has_inertial_columns(&self) -> bool {
        let mut outputs = self.outputs.iter();
        self.of == Of::System && outputs.any(|output| output.shape == Shape::VECTOR_BY_SPEEDS)
    }

    /// True where accelerations or the inverse of the mass matrix are solved for.
    pub(super) fn solves(&self) -> bool {
        match self.mass_matrix {
            MassMatrixUse::None | MassMatrixUse::Factors => false,
            MassMatrixUse::Accelerations | MassMatrixUse::Inverse => true,
        }
    }

    /// True where an output has such a dimension.
    pub fn writes(&self, dimension: Dimension) -> bool {
        self.outputs
            .iter()
            .any(|output| output.shape.has(dimension))
    }

    /// True for a function of a frame whose columns belong to speeds: a constant beside it says which are not zero.
    pub fn has_frame_speeds(&self) -> bool {
        let shapes = [Shape::VECTOR_BY_SPEEDS, Shape::VECTOR_BY_FRAME_SPEEDS];
        let mut outputs = self.outputs.iter();
        self.of != Of::System && outputs.any(|output| shapes.contains(&output.shape))
    }

    /// True where the output is compact.
    pub fn is_compact(&self) -> bool {
        self.writes(Dimension::Columns)
    }

    /// The constant that holds the pattern of a compact output.
    pub fn blocks_constant(&self) -> String {
        format!("{}_BLOCKS", self.name.to_uppercase())
    }

    /// The constant that holds the number of columns of a compact output.
    pub fn compact_columns_constant(&self) -> String {
        format!("{}_COLUMNS", self.name.to_uppercase())
    }
}
