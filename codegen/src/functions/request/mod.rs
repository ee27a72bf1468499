//! What is generated: a function of the catalogue, or several in one that share their work.
//!
//! In: parts, on the tree of a model. Out: a [`Request`]: its name, what it is given and writes. How large it is stands in `size`, how it
//! is derived in `functions::derive_request`.

mod size;

use std::collections::BTreeSet;

use super::{
    argument::Argument,
    formulation::Formulation,
    function::{Function, MassMatrixUse, Output},
    packed::Packed,
    parse::syntax::{named, sum},
    part::Part,
    shape::Dimension,
    variable::Variable,
};
use crate::{id::BodyMap, recursive::Technique, tree::Tree};

/// A function to generate.
#[derive(Clone, Debug)]
pub struct Request {
    /// What it is to be called, where that is said.
    name: Option<String>,
    parts: Vec<Part>,
    at_sin_cos: bool,
}

impl Request {
    pub(super) fn new(name: Option<String>, parts: Vec<Part>, at_sin_cos: bool) -> Self {
        Self {
            name,
            parts,
            at_sin_cos,
        }
    }

    /// What it is made of, in the order asked for.
    pub fn parts(&self) -> &[Part] {
        &self.parts
    }

    /// The part, where it is one as the catalogue has it, under its own name.
    pub fn catalogue_part(&self) -> Option<&Part> {
        self.only_part().filter(|_| self.name.is_none())
    }

    /// The part, where it is one as the catalogue has it, whatever the function is called.
    pub fn only_part(&self) -> Option<&Part> {
        match &self.parts[..] {
            [part] if !self.at_sin_cos && part.derivative.is_none() => Some(part),
            _ => None,
        }
    }

    /// True where some part is of a frame.
    pub fn is_of_frames(&self) -> bool {
        let mut parts = self.parts.iter();
        parts.any(|part| part.subject.is_some())
    }

    /// True for bodies between the inertial frame and its frames, and for all bodies where more than these paths matters.
    pub fn paths(&self, tree: &Tree) -> BodyMap<bool> {
        let mut subjects = self.parts.iter().map(|part| part.subject.as_ref());
        let is_of_paths =
            subjects.all(|subject| subject.is_some()) && !self.heeds(Technique::Regroup);
        let mut are_on = BodyMap::outward(tree.bodies.len(), |_, _| !is_of_paths);
        let subjects = self.parts.iter().filter_map(|part| part.subject.as_ref());
        let frames = subjects.flat_map(|subject| &subject.frames);
        for body in frames.filter_map(|frame| tree.frame_body(frame.frame)) {
            for on_path in tree.path(body) {
                are_on[on_path] = true;
            }
        }
        are_on
    }

    /// True where the cost of its values may depend on whether a plan uses the technique.
    pub fn heeds(&self, technique: Technique) -> bool {
        self.functions().any(|function| function.heeds(technique))
    }

    /// The function of a compact output.
    pub fn compact(&self) -> Option<&'static Function> {
        let mut functions = self.functions();
        functions.find(|function| function.is_compact())
    }

    fn functions(&self) -> impl Iterator<Item = &'static Function> {
        self.parts.iter().map(|part| part.function)
    }

    /// True where a length of an output is this one.
    pub(crate) fn writes(&self, dimension: Dimension) -> bool {
        self.functions().any(|function| function.writes(dimension))
    }

    /// The packed matrices among the outputs, each once.
    pub fn packed(&self) -> Vec<Packed> {
        let is_written = |packed: &Packed| {
            let mut functions = self.functions();
            functions.any(|function| {
                let mut outputs = function.outputs.iter();
                outputs.any(|output| output.shape.packed() == Some(*packed))
            })
        };
        Packed::ALL.into_iter().filter(is_written).collect()
    }

    /// True where the sines and cosines of the angles among the coordinates are given, after `q`.
    pub fn is_at_sin_cos(&self) -> bool {
        self.at_sin_cos
    }

    /// As it is asked for: `mass_matrix+bias(sin_cos)`, `step = mass_matrix+bias`.
    pub fn text(&self) -> String {
        named(self.name.as_deref(), self.sum())
    }

    /// The same without a name that it was given.
    pub fn sum(&self) -> String {
        sum(self.parts.iter().map(Part::text), self.at_sin_cos)
    }

    /// The generated function's name: the one that it was given, or that of its parts.
    pub fn name(&self) -> String {
        self.name.clone().unwrap_or_else(|| self.name_of_parts())
    }

    /// `mass_matrix_and_bias_at_sin_cos`.
    pub(super) fn name_of_parts(&self) -> String {
        let at_sin_cos = if self.at_sin_cos { "_at_sin_cos" } else { "" };
        self.joined("_and_", Part::name) + at_sin_cos
    }

    fn joined(&self, between: &str, name: fn(&Part) -> String) -> String {
        let names: Vec<String> = self.parts.iter().map(name).collect();
        names.join(between)
    }

    /// What it is given besides the parameters: whatever one of its parts is given, in the order of all functions.
    pub fn arguments(&self) -> Vec<Argument> {
        let all: BTreeSet<Argument> = self.parts.iter().flat_map(Part::arguments).collect();
        all.into_iter().collect()
    }

    /// What it writes, in the order asked for. An output that has the name of another one or of an argument carries the name
    /// of its part, alone where that has no other output.
    pub fn outputs(&self) -> Vec<Output> {
        let parts = self.parts.iter();
        parts.flat_map(|part| self.outputs_of(part)).collect()
    }

    /// The lengths of each output's nested arrays, outermost first; `n_columns` is the number of a compact output's columns.
    pub fn lengths(&self, tree: &Tree, n_columns: usize) -> Vec<Vec<usize>> {
        let of_part = |part: &Part| {
            let own = |dimension| part.own_length(dimension, tree, n_columns);
            let outputs = part.outputs();
            let lengths = outputs.iter();
            let lengths = lengths.map(|output| output.shape.lengths(tree, own));
            lengths.collect::<Vec<_>>()
        };
        self.parts.iter().flat_map(of_part).collect()
    }

    pub(super) fn outputs_of(&self, part: &Part) -> Vec<Output> {
        let arguments = self.arguments();
        let is_free = |name: &str| {
            let parts = self.parts.iter();
            let all = parts.flat_map(|part| part.outputs().into_owned());
            all.filter(|output| output.name == name).count() == 1
                && arguments.iter().all(|argument| argument.name() != name)
        };
        let outputs = part.outputs();
        let named = |output: &Output| {
            if self.parts.len() == 1 || is_free(&output.name) {
                return output.clone();
            }
            let own = match outputs[..] {
                [_] => part.name(),
                _ => format!("{}_{}", part.name(), output.name),
            };
            Output {
                name: own.into(),
                ..output.clone()
            }
        };
        outputs.iter().map(named).collect()
    }

    /// Lines of documentation.
    pub fn doc(&self) -> Vec<String> {
        let mut lines = self.meaning();
        if self.at_sin_cos {
            lines.push(String::new());
            lines.push(
                "`sin_cos` holds what the function `sin_cos` computes from this `q`, once for all that are called there."
                    .to_owned(),
            );
        }
        lines
    }

    fn meaning(&self) -> Vec<String> {
        if let [part] = &self.parts[..] {
            return part.doc();
        }
        let names = self.joined("` and `", Part::text);
        let mut lines = vec![format!("`{names}` in one: what they share is done once.")];
        for part in &self.parts {
            lines.push(String::new());
            let outputs = self.outputs_of(part).into_iter();
            let outputs: Vec<String> = outputs.map(|output| format!("`{}`", output.name)).collect();
            let mut doc = part.doc().into_iter();
            let first = doc.next().unwrap_or_default();
            lines.push(format!("{}: {first}", outputs.join(" and ")));
            lines.extend(doc);
        }
        lines
    }

    /// True where accelerations or the inverse of the mass matrix are solved for.
    pub fn solves(&self) -> bool {
        self.functions().any(Function::solves)
    }

    /// True where the mass matrix is factorised, whichever way it is derived.
    pub fn factorises(&self) -> bool {
        self.functions()
            .any(|function| function.mass_matrix == MassMatrixUse::Factors)
    }

    /// True where accelerations of the prescribed speeds are given, and forces of the others.
    pub fn prescribes(&self) -> bool {
        self.functions().any(|function| function.prescribes)
    }

    /// The formulations in which the function can be derived.
    pub fn formulations(&self) -> Vec<Formulation> {
        let functions = self.functions();
        let mut all: Vec<_> = functions
            .flat_map(Function::formulations)
            .copied()
            .collect();
        all.sort_unstable();
        all.dedup();
        all
    }

    /// True where some part is a derivative.
    pub fn differentiates(&self) -> bool {
        let mut parts = self.parts.iter();
        parts.any(|part| part.derivative.is_some())
    }

    /// True where some part is a derivative that has a way of its own, beside the sweeps.
    pub fn differentiates_directly(&self) -> bool {
        let mut parts = self.parts.iter();
        parts.any(Part::has_direct_derivatives)
    }

    /// The functions whose plans suit derivatives that have a way of their own, each once.
    pub fn alike(&self) -> Vec<Self> {
        let mut all: Vec<Self> = Vec::new();
        for part in self.parts.iter().flat_map(Part::alike) {
            let other = Self::new(None, vec![part], self.at_sin_cos);
            if all.iter().all(|known| known.text() != other.text()) {
                all.push(other);
            }
        }
        all
    }

    /// True where sweeps find derivatives even if dynamics are differentiated in their own way.
    pub fn sweeps_beside_direct(&self) -> bool {
        self.parts.iter().any(Part::is_swept_beside_direct)
    }

    /// True where some of these are of accelerations that forces make.
    pub fn differentiates_accelerations(&self) -> bool {
        let mut parts = self.parts.iter();
        parts.any(Part::differentiates_accelerations)
    }

    /// True where all second derivatives are of accelerations that forces make, and there are some.
    pub fn differentiates_accelerations_twice(&self) -> bool {
        let mut parts = self.parts.iter().filter(|part| part.is_second_derivative());
        self.is_second_derivative() && parts.all(|part| part.function.inverse_dynamics.is_some())
    }

    /// True where some part is a second derivative.
    pub fn is_second_derivative(&self) -> bool {
        self.parts.iter().any(Part::is_second_derivative)
    }

    /// True where some part is differentiated by all values set at run time.
    pub fn is_by_parameters(&self) -> bool {
        let derivatives = self
            .parts
            .iter()
            .filter_map(|part| part.derivative.as_ref());
        let mut variables = derivatives.flat_map(|derivative| &derivative.by);
        variables.any(|variable| *variable == Variable::Parameters)
    }

    /// The same with the values of what is differentiated in the place of its derivatives, each once.
    #[must_use]
    pub fn values(&self) -> Self {
        let mut parts: Vec<Part> = Vec::new();
        for part in self.parts.iter().map(Part::values) {
            if parts.iter().all(|known| known.text() != part.text()) {
                parts.push(part);
            }
        }
        Self::new(None, parts, self.at_sin_cos)
    }

    /// The parts, each alone.
    pub fn alone(&self) -> Vec<Self> {
        let alone = |part: &Part| Self::new(None, vec![part.clone()], self.at_sin_cos);
        self.parts.iter().map(alone).collect()
    }
}

impl From<&'static Function> for Request {
    /// A function of the whole system.
    fn from(function: &'static Function) -> Self {
        let part = Part {
            function,
            subject: None,
            derivative: None,
        };
        Self::new(None, vec![part], false)
    }
}
