//! A function as the catalogue describes it: what it is given, what it writes, what that means, how it is derived.

use std::borrow::Cow;

use super::{
    argument::Argument,
    candidate::{Candidate, Formulation, FrameRule, Rule},
    derived::Derived,
    shape::{Axis, Shape},
};
use crate::{recursive::Plan, tree::Tree};

/// A function of the generated module: of the whole system, or, as a [`FrameFunction`], of a frame.
#[derive(Debug)]
pub struct Function<R: 'static = Rule> {
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
    /// True where accelerations are solved for along the tree, by factors or by articulated bodies.
    pub solves: bool,
    /// True for a function of a frame whose vectors may be along the frame's own axes too.
    pub has_local: bool,
    /// Lines of documentation: meaning, equation, frame, unit, signs, the aliases people search for. In that of a
    /// function of a frame `{frame}` and `{axes}` stand for these.
    pub doc: &'static [&'static str],
    /// The ways to derive it; of two that need as many operations the first is emitted.
    pub candidates: &'static [Candidate<R>],
}

/// A function of a frame: `pose(tool0)`.
pub type FrameFunction = Function<FrameRule>;

/// An output of a function.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Output {
    /// The argument's name.
    pub name: Cow<'static, str>,
    /// The array that is written.
    pub shape: Shape,
}

impl Output {
    /// An output with a name of the catalogue.
    pub(super) const fn new(name: &'static str, shape: Shape) -> Self {
        Self {
            name: Cow::Borrowed(name),
            shape,
        }
    }
}

impl<R> Function<R> {
    /// The formulations in which the function can be derived.
    pub fn formulations(&self) -> Vec<Formulation> {
        let candidates = self.candidates.iter();
        candidates.map(|candidate| candidate.formulation).collect()
    }

    /// How many terms the notes' sums have at least.
    pub(super) fn literal_terms(&self, tree: &Tree) -> usize {
        let mut candidates = self.candidates.iter();
        let notes = candidates.find(|candidate| candidate.formulation == Formulation::Notes);
        notes.map_or(0, |candidate| (candidate.least_terms)(tree))
    }

    /// The candidate of this formulation, or the first.
    pub(super) fn candidate(&self, formulation: Formulation) -> &Candidate<R> {
        let mut candidates = self.candidates.iter();
        candidates
            .find(|candidate| candidate.formulation == formulation)
            .unwrap_or(&self.candidates[0])
    }

    /// True where an output has such an axis.
    pub(super) fn writes(&self, axis: Axis) -> bool {
        self.outputs.iter().any(|output| output.shape.has(axis))
    }
}

impl Function {
    /// Derives the function; one that has a single formulation takes no notice of `formulation`, and only the recursive one
    /// of `plan`.
    pub fn derive(&self, tree: &Tree, formulation: Formulation, plan: &Plan) -> Derived {
        let mut derived = Derived::default();
        let candidate = self.candidate(formulation);
        candidate.derive_in(&mut derived, tree, plan);
        derived
    }

    /// True where the output is compact.
    pub fn is_compact(&self) -> bool {
        self.writes(Axis::Columns)
    }

    /// The constant that holds the pattern of a compact output.
    pub fn blocks_constant(&self) -> String {
        format!("{}_BLOCKS", self.name.to_uppercase())
    }

    /// The constant that holds the number of columns of a compact output.
    pub fn columns_constant(&self) -> String {
        format!("{}_COLUMNS", self.name.to_uppercase())
    }
}
