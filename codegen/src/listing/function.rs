//! A function as data: how it is declared, what it costs, what it does.

use super::{Code, Counted, Entry, Facts, Helper, Stage};
use crate::{
    functions::{Access, Argument, Declared, DerivativeTrait, Formulation, Part, Signature},
    program::Operations,
};

/// A function.
#[derive(Clone, Debug)]
pub struct Function {
    /// How it is declared, and what it means.
    pub signature: Signature,
    /// As it is asked for; `None` for what each module has.
    pub request: Option<String>,
    /// What it is given besides the parameters.
    pub arguments: Vec<Argument>,
    /// The part of a request, where it is the first function that is one as the catalogue has it.
    pub catalogue_part: Option<Part>,
    /// The runtime's trait for the derivatives that it is, where there is one.
    pub derivative_trait: Option<DerivativeTrait>,
    /// The pattern of its output that stands before it, by its place among [`Facts::patterns`].
    pub pattern: Option<usize>,
    /// How its sums over bodies are associated.
    pub formulation: Formulation,
    /// True where they could have been associated otherwise.
    pub has_choice: bool,
    /// Its operations.
    pub operations: Operations,
    /// How many pairs of a multiplication and an addition are fused.
    pub fused: usize,
    /// What it does.
    pub code: Code,
    /// The same in parts, where it is long.
    pub stages: Vec<Stage>,
    /// What it runs on several columns.
    pub helpers: Vec<Helper>,
    /// What it fills for these: arrays that count as arguments behind its own.
    pub scratch: Vec<Declared>,
}

impl Function {
    /// One that computes nothing that could be associated otherwise.
    pub(super) fn plain(signature: Signature, operations: Operations, code: Code) -> Self {
        Self {
            signature,
            request: None,
            arguments: Vec::new(),
            catalogue_part: None,
            derivative_trait: None,
            pattern: None,
            formulation: Formulation::Notes,
            has_choice: false,
            operations,
            fused: 0,
            code,
            stages: Vec::new(),
            helpers: Vec::new(),
            scratch: Vec::new(),
        }
    }

    /// All arguments, and the arrays that it fills for its helpers.
    pub fn places(&self) -> impl Iterator<Item = &Declared> {
        self.signature.arguments.iter().chain(&self.scratch)
    }

    /// The arguments that it reads.
    pub fn inputs(&self) -> impl Iterator<Item = &Declared> {
        self.signature.with(Access::Read)
    }

    /// The arguments that it writes.
    pub fn outputs(&self) -> impl Iterator<Item = &Declared> {
        self.signature.with(Access::Written)
    }

    /// What it costs.
    pub fn counted(&self) -> Counted {
        let formulation = self.has_choice.then(|| self.formulation.name().to_owned());
        Counted {
            operations: self.operations,
            formulation,
        }
    }

    /// Lines that say what it costs.
    pub fn cost(&self) -> Vec<String> {
        self.counted().lines(self.fused)
    }
}

/// The places of all numbers that a function writes: those of one output after the other.
pub(super) fn places(signature: &Signature, facts: &Facts) -> Vec<Entry> {
    let arguments = signature.arguments.iter().enumerate();
    let outputs = arguments.filter(|(_, argument)| argument.access == Access::Written);
    let places = outputs.flat_map(|(argument, declared)| {
        let extent = facts.extent(declared);
        let places = 0..extent.size();
        places.map(move |place| Entry {
            argument,
            steps: extent.steps(place),
        })
    });
    places.collect()
}
