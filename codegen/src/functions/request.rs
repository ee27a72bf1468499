//! What is generated: a function of the catalogue, or several in one that share their work.
//!
//! In: parts, on the tree of a model. Out: a [`Request`]: its name, what it is given and writes, and its derivation.

use super::{
    argument::Argument,
    candidate::Formulation,
    derived::Derived,
    function::{FrameFunction, Function, Output},
    part::Part,
    shape::Axis,
    subject::Subject,
    syntax::AT_SIN_COS,
};
use crate::{recursive::Plan, tree::Tree};

/// A function to generate.
#[derive(Clone, Debug)]
pub struct Request {
    parts: Vec<Part>,
    at_sin_cos: bool,
}

impl Request {
    pub(super) fn new(parts: Vec<Part>, at_sin_cos: bool) -> Self {
        Self { parts, at_sin_cos }
    }

    /// What it is made of, in the order asked for.
    pub fn parts(&self) -> &[Part] {
        &self.parts
    }

    /// The function of the catalogue, where it is one as it stands there.
    pub fn alone(&self) -> Option<&'static Function> {
        match self.parts[..] {
            [Part::System(function)] if !self.at_sin_cos => Some(function),
            _ => None,
        }
    }

    /// The function of a frame, where it is one alone.
    pub fn alone_of_frame(&self) -> Option<(&'static FrameFunction, &Subject)> {
        match &self.parts[..] {
            [Part::Frame(function, subject)] if !self.at_sin_cos => Some((function, subject)),
            _ => None,
        }
    }

    /// True where some part is of a frame.
    pub fn is_of_frames(&self) -> bool {
        let mut parts = self.parts.iter();
        parts.any(|part| matches!(part, Part::Frame(..)))
    }

    /// The function of a compact output.
    pub fn compact(&self) -> Option<&'static Function> {
        self.parts.iter().find_map(|part| match part {
            Part::System(function) if function.is_compact() => Some(*function),
            _ => None,
        })
    }

    /// True where a packed mass matrix is among the outputs.
    pub fn is_packed(&self) -> bool {
        let mut outputs = self.parts.iter().flat_map(Part::outputs);
        outputs.any(|output| output.shape.has(Axis::SpeedPairs))
    }

    /// True where the sines and cosines of the angles among the coordinates are given, after `q`.
    pub fn is_at_sin_cos(&self) -> bool {
        self.at_sin_cos
    }

    /// As it is asked for: `mass_matrix+bias(sin_cos)`.
    pub fn text(&self) -> String {
        self.joined("+", Part::text) + self.suffix(AT_SIN_COS)
    }

    /// The generated function's name: `mass_matrix_and_bias_at_sin_cos`.
    pub fn name(&self) -> String {
        self.joined("_and_", Part::name) + self.suffix("_at_sin_cos")
    }

    fn joined(&self, between: &str, name: fn(&Part) -> String) -> String {
        let names: Vec<String> = self.parts.iter().map(name).collect();
        names.join(between)
    }

    fn suffix<'a>(&self, at_sin_cos: &'a str) -> &'a str {
        if self.at_sin_cos { at_sin_cos } else { "" }
    }

    /// What it is given besides the parameters: whatever one of its parts is given, in the order of all functions.
    pub fn arguments(&self) -> Vec<Argument> {
        let is_given = |argument: &Argument| {
            let mut parts = self.parts.iter();
            parts.any(|part| part.arguments().contains(argument))
        };
        Argument::ALL.into_iter().filter(is_given).collect()
    }

    /// What it writes, in the order asked for. An output that has the name of another one or of an argument carries the name
    /// of its part, alone where that has no other output.
    pub fn outputs(&self) -> Vec<Output> {
        let parts = self.parts.iter();
        parts.flat_map(|part| self.outputs_of(part)).collect()
    }

    fn outputs_of(&self, part: &Part) -> Vec<Output> {
        let arguments = self.arguments();
        let is_free = |name: &str| {
            let all = self.parts.iter().flat_map(Part::outputs);
            let among = all.filter(|output| output.name == name);
            among.count() == 1 && arguments.iter().all(|argument| argument.name() != name)
        };
        let outputs = part.outputs();
        let named = |output: &Output| {
            if self.parts.len() == 1 || is_free(&output.name) {
                return output.clone();
            }
            let own = match outputs {
                [_] => part.name(),
                _ => format!("{}_{}", part.name(), output.name),
            };
            Output {
                name: own.into(),
                shape: output.shape,
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

    /// True where accelerations are solved for.
    pub fn solves(&self) -> bool {
        self.parts.iter().any(Part::solves)
    }

    /// The formulations in which the function can be derived.
    pub fn formulations(&self) -> Vec<Formulation> {
        let mut all: Vec<Formulation> = self.parts.iter().flat_map(Part::formulations).collect();
        all.sort_unstable();
        all.dedup();
        all
    }

    /// How many terms the notes' sums have at least: where another formulation needs fewer operations than that, the notes'
    /// need not be derived to know which is cheaper. Parts may have all theirs in common.
    pub fn literal_terms(&self, tree: &Tree) -> usize {
        let terms = self.parts.iter().map(|part| part.literal_terms(tree));
        terms.max().unwrap_or(0)
    }

    /// How many numbers it writes, or somewhat more, where joints follow others.
    pub fn n_numbers(&self, tree: &Tree) -> usize {
        self.parts.iter().map(|part| part.n_numbers(tree)).sum()
    }

    /// True where this formulation needs a plan, which is searched for.
    pub fn takes_plan(&self, formulation: Formulation) -> bool {
        self.parts.iter().any(|part| part.takes_plan(formulation))
    }

    /// Derives all parts in one graph, where what they share is built once. A part that has a single formulation takes no
    /// notice of `formulation`, and only what needs a plan of `plan`.
    pub fn derive(&self, tree: &Tree, formulation: Formulation, plan: &Plan) -> Derived {
        let mut derived = Derived::default();
        for part in &self.parts {
            derived.graph.enter(None);
            part.derive_in(&mut derived, tree, formulation, plan);
        }
        derived
    }
}

impl From<&'static Function> for Request {
    fn from(function: &'static Function) -> Self {
        Self::new(vec![Part::System(function)], false)
    }
}
