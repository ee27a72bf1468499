//! A part of a request: a function of the catalogue, and what it is of.

use std::borrow::Cow;

use super::{
    argument::Argument,
    candidate::{Candidate, Formulation},
    derivatives::{
        derivative::{Derivative, DerivativeKind},
        sparsity::Sparsity,
    },
    derived::Derived,
    function::{Function, Output},
    packed::Packed,
    parse::syntax::written,
    shape::{Dimension, Length, Shape},
    subject::{Subject, View},
    terms,
};
use crate::{
    base_parameters,
    expr::Expr,
    recursive::{Plan, Technique},
    tree::{N_INERTIAL, Tree, Value},
};

/// How many rows sweeps carry along.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Rows {
    /// From the inputs to the outputs: one for each variable or direction.
    pub forward: usize,
    /// From the outputs back: one for each output or multiplied sum.
    pub reverse: usize,
}

/// What stands behind a frame whose own axes are meant.
pub(super) const LOCAL: &str = "local";

/// A part of a request, on the tree of a model.
#[derive(Clone, Debug)]
pub struct Part {
    /// The function of the catalogue.
    pub function: &'static Function,
    /// The frames that it is of; `None` of the whole system.
    pub subject: Option<Subject>,
    /// By what it is differentiated; `None` for its values.
    pub derivative: Option<Derivative>,
}

/// A function of frames as it is asked for: `velocity(tool0, local)`.
pub(super) fn text_of<'a>(
    function: &Function,
    frames: impl Iterator<Item = &'a str>,
    view: View,
) -> String {
    let mut words: Vec<String> = frames.map(written).collect();
    words.extend((view == View::Local).then(|| LOCAL.to_owned()));
    format!("{}({})", function.name, words.join(", "))
}

impl Part {
    /// As it is asked for.
    pub fn text(&self) -> String {
        let of = self.text_of_values();
        match &self.derivative {
            None => of,
            Some(derivative) => Derivative::text(derivative.kind, &of, &derivative.joined(", ")),
        }
    }

    fn text_of_values(&self) -> String {
        let Some(subject) = &self.subject else {
            return self.function.name.to_owned();
        };
        let frames = subject.frames.iter().map(|frame| frame.name.as_str());
        text_of(self.function, frames, subject.view)
    }

    /// Its name in generated code: `bias`, `tool0_velocity_local`.
    pub fn name(&self) -> String {
        let of = self.name_of(self.function.name);
        match &self.derivative {
            None => of,
            Some(derivative) => derivative.name(&of),
        }
    }

    /// The same, not differentiated.
    #[must_use]
    pub fn values(&self) -> Self {
        Self {
            derivative: None,
            ..self.clone()
        }
    }

    /// What its frames and how they are seen make of a name.
    fn name_of(&self, name: &str) -> String {
        let Some(subject) = &self.subject else {
            return name.to_owned();
        };
        let frames = subject.frames.iter();
        let frames: Vec<&str> = frames.map(|frame| frame.identifier.as_str()).collect();
        match (subject.view, &frames[..]) {
            (View::Other, [frame, other]) => format!("{frame}_{name}_from_{other}"),
            (View::Local, frames) => format!("{}_{name}_{LOCAL}", frames.join("_")),
            (_, frames) => format!("{}_{name}", frames.join("_")),
        }
    }

    /// The constant that says which speeds move the frame that it is of.
    pub fn speeds_constant(&self) -> String {
        self.name_of("speeds").to_uppercase()
    }

    /// The constant that says how many these are.
    pub fn speeds_len_constant(&self) -> String {
        self.name_of("speeds_len").to_uppercase()
    }

    /// What it is given besides the parameters.
    pub(super) fn arguments(&self) -> Vec<Argument> {
        let derivative = self.derivative.iter();
        let own = derivative.flat_map(|derivative| {
            derivative.arguments(self.function.outputs, self.own_of_subject())
        });
        let arguments = self.function.arguments.iter().copied();
        arguments.chain(own).collect()
    }

    /// The length of the dimensions of its values that its subject decides, zero where none is.
    fn own_of_subject(&self) -> usize {
        let writes = |dimension| self.function.writes(dimension);
        match &self.subject {
            Some(subject) if writes(Dimension::FrameSpeeds) => subject.n_speeds,
            Some(subject) if writes(Dimension::FrameComponents) => 6 * subject.frames.len(),
            _ => 0,
        }
    }

    /// True where all derivatives are asked for, as the function's composite bodies give them.
    pub(super) fn is_whole_derivative(&self) -> bool {
        let mut derivative = self.derivative.iter();
        derivative.any(|derivative| {
            matches!(
                derivative.kind,
                DerivativeKind::Jacobian | DerivativeKind::PackedJacobian
            )
        })
    }

    /// True where a product of derivatives with a direction or a multiplier is asked for.
    fn is_product(&self) -> bool {
        let mut derivative = self.derivative.iter();
        derivative
            .any(|derivative| matches!(derivative.kind, DerivativeKind::Jvp | DerivativeKind::Vjp))
    }

    /// True where its derivatives have a way of their own, beside the sweeps.
    pub(super) fn has_own_way(&self) -> bool {
        self.is_whole_derivative() && self.function.derivatives.is_some()
            || self.is_product() && self.function.needed.is_some()
    }

    /// True where entries are left out that the tree makes zero.
    pub(super) fn is_packed(&self) -> bool {
        let mut outputs = self.outputs().into_owned().into_iter();
        outputs.any(|output| output.shape == Shape::ENTRIES)
    }

    /// True where the product of a multiplier with derivatives is asked for.
    pub(super) fn is_gradient(&self) -> bool {
        let mut derivative = self.derivative.iter();
        derivative.any(|derivative| derivative.kind == DerivativeKind::Vjp)
    }

    /// True where second derivatives are asked for.
    pub(super) fn is_second_derivative(&self) -> bool {
        let mut derivative = self.derivative.iter();
        derivative.any(|derivative| derivative.kind == DerivativeKind::Hessian)
    }

    /// Which entries of a packed derivative it writes; `None` where it is none.
    pub fn sparsity(&self, tree: &Tree) -> Option<&Sparsity> {
        let derivative = self.derivative.as_ref()?;
        if self.function.writes(Dimension::BaseParameters) {
            // Which there are follows from the model's own numbers.
            base_parameters::of(tree);
        }
        let of = (self.function.outputs, self.own_of_subject());
        derivative.sparsity(tree, of, |tree| {
            let mut derived = Derived::default();
            let candidate = self.candidate(tree, Formulation::Recursive);
            let (plan, subject) = (Plan::plain(tree), self.subject.as_ref());
            candidate.derive_in(&mut derived, tree, &plan, subject);
            derived
        })
    }

    /// The constant that says which they are.
    pub fn places_constant(&self) -> String {
        format!("{}_PLACES", self.name().to_uppercase())
    }

    /// The constant that says how many.
    pub fn len_constant(&self) -> String {
        format!("{}_LEN", self.name().to_uppercase())
    }

    /// The constant that holds the colours of columns.
    pub fn colors_constant(&self) -> String {
        format!("{}_COLORS", self.name().to_uppercase())
    }

    /// The constant that says how many columns there are.
    pub fn columns_constant(&self) -> String {
        format!("{}_COLUMNS", self.name().to_uppercase())
    }

    /// What it writes, in order.
    pub fn outputs(&self) -> Cow<'static, [Output]> {
        match &self.derivative {
            None => self.function.outputs.into(),
            Some(derivative) => derivative.outputs(self.function.outputs).into(),
        }
    }

    /// Lines of documentation.
    pub fn doc(&self) -> Vec<String> {
        let of = self.doc_of_values();
        let Some(derivative) = &self.derivative else {
            return of;
        };
        let mut lines = derivative.doc(
            &self.text_of_values(),
            &self.outputs(),
            &self.places_constant(),
        );
        lines.extend([String::new(), "Of that function:".to_owned(), String::new()]);
        lines.extend(of);
        lines
    }

    fn doc_of_values(&self) -> Vec<String> {
        let lines = self.function.doc.iter();
        let Some(subject) = &self.subject else {
            return lines.map(ToString::to_string).collect();
        };
        let names = subject.frames.iter();
        let names: Vec<String> = names
            .map(|frame| format!("`{}`", frame.name.escape_debug()))
            .collect();
        let (frames, from) = match (subject.view, &names[..]) {
            (View::Other, [frame, other]) => (frame.clone(), other.as_str()),
            _ => (names.join(", "), "the inertial frame"),
        };
        let axes = match subject.view {
            View::Inertial => "inertial components".to_owned(),
            View::Local => "components along the frame's own axes".to_owned(),
            View::Other => format!("components along the axes of {from}"),
        };
        let is_other = subject.view == View::Other;
        let words = [
            ("{frame}", frames),
            (
                "{seen}",
                match subject.view {
                    View::Other => {
                        format!("as it is seen from {from}, which may move itself, {axes}")
                    }
                    View::Inertial | View::Local => format!("in {from}, {axes}"),
                },
            ),
            (
                "{from}",
                if is_other {
                    format!(" as it is seen from {from}")
                } else {
                    String::new()
                },
            ),
            (
                "{base}",
                if is_other {
                    format!("{from}'s")
                } else {
                    "inertial".to_owned()
                },
            ),
            (
                "{origin}",
                if is_other {
                    format!("{from}'s")
                } else {
                    "the inertial origin".to_owned()
                },
            ),
            ("{axes}", axes),
            ("{speeds}", format!("`{}`", self.speeds_constant())),
        ];
        let line = |line: &&str| {
            let line = (*line).to_owned();
            words
                .iter()
                .fold(line, |line, (word, text)| line.replace(word, text))
        };
        lines.map(line).collect()
    }

    /// How many terms the notes' sums have at least; where they are differentiated, about so many for every row that is swept.
    pub(super) fn literal_terms(&self, tree: &Tree) -> usize {
        let terms = self.function.literal_terms(tree, self.subject.as_ref());
        let Rows { forward, reverse } = self.swept_rows(tree);
        terms * forward.min(reverse).max(1)
    }

    /// How many entries the variables have together.
    pub(super) fn n_variables(&self, tree: &Tree) -> usize {
        let by = self.derivative.iter().flat_map(|derivative| &derivative.by);
        by.map(|variable| variable.n_entries(tree)).sum()
    }

    /// How many rows each way to sweep for its derivatives carries along.
    pub(super) fn swept_rows(&self, tree: &Tree) -> Rows {
        let Some(derivative) = &self.derivative else {
            return Rows::default();
        };
        let [forward, reverse] = [self.n_variables(tree), self.n_values(tree)];
        match derivative.kind {
            DerivativeKind::Jacobian | DerivativeKind::PackedJacobian => Rows { forward, reverse },
            DerivativeKind::Jvp => Rows {
                forward: 1,
                reverse,
            },
            DerivativeKind::Vjp => Rows {
                forward,
                reverse: 1,
            },
            // Its gradient has an entry for each variable.
            DerivativeKind::Hessian => Rows {
                forward,
                reverse: forward,
            },
        }
    }

    /// How many numbers its values have at most.
    fn n_values(&self, tree: &Tree) -> usize {
        self.values().n_numbers(tree)
    }

    /// How many numbers it writes at most: what takes a while to find is bounded.
    pub(super) fn n_numbers(&self, tree: &Tree) -> usize {
        let of_output = |output: &Output| {
            let length = |dimension: &Dimension| match dimension {
                Dimension::Packed(Packed::MassMatrix) => terms::pairs(tree),
                // Not more than there are without combining them, which takes a while.
                Dimension::BaseParameters => N_INERTIAL * tree.bodies.len(),
                Dimension::Packed(Packed::Inverse) if !tree.has_followers() => {
                    terms::pairs_of_trees(tree)
                }
                // Not more than there are without finding out which are zero.
                Dimension::Entries if self.is_second_derivative() => {
                    let n = self.n_variables(tree);
                    n * (n + 1) / 2
                }
                Dimension::Entries => self.n_values(tree) * self.n_variables(tree),
                // Elimination couples more only where joints follow others.
                Dimension::Packed(Packed::Factors) if !tree.has_followers() => terms::pairs(tree),
                Dimension::Packed(Packed::Regressor) if !tree.has_followers() => {
                    N_INERTIAL * terms::of_vector(tree)
                }
                dimension => dimension
                    .length(tree)
                    .unwrap_or_else(|| self.own_length(*dimension, tree, terms::of_vector(tree))),
            };
            output
                .shape
                .all()
                .map(|dimension| length(&dimension))
                .product::<usize>()
        };
        self.outputs().iter().map(of_output).sum()
    }

    /// The length of a dimension that is its own; `n_columns` is the number of a compact output's columns.
    pub fn own_length(&self, dimension: Dimension, tree: &Tree, n_columns: usize) -> usize {
        match (dimension, &self.subject) {
            (Dimension::Entries, _) => {
                let sparsity = self.sparsity(tree);
                sparsity.map_or(0, |sparsity| sparsity.places.len())
            }
            (Dimension::FrameSpeeds, Some(subject)) => subject.speeds(tree).len(),
            (Dimension::FrameComponents, Some(subject)) => 6 * subject.frames.len(),
            _ => n_columns,
        }
    }

    /// The same, as generated code names it.
    pub(super) fn own_declared(&self, dimension: Dimension) -> Length {
        match (dimension, &self.subject) {
            (Dimension::Entries, _) => Length::Constant(self.len_constant()),
            (Dimension::FrameSpeeds, Some(_)) => Length::Constant(self.speeds_len_constant()),
            (Dimension::FrameComponents, Some(subject)) => Length::Number(6 * subject.frames.len()),
            _ => Length::Constant(self.function.compact_columns_constant()),
        }
    }

    /// By what it is derived. The recursion relies on rotations being orthonormal, which they are not where an entry changes
    /// alone.
    fn candidate(&self, tree: &Tree, wanted: Formulation) -> &Candidate {
        let formulation = if self.is_by_turn(tree) {
            Formulation::Notes
        } else {
            wanted
        };
        self.function.candidate(formulation)
    }

    /// True where an entry of its frames' rotations is a variable.
    fn is_by_turn(&self, tree: &Tree) -> bool {
        let (Some(subject), Some(derivative)) = (&self.subject, &self.derivative) else {
            return false;
        };
        let frames = subject.frames.iter();
        let turns = frames.filter_map(|frame| tree.frame_turn(frame.frame));
        let mut entries = turns.flat_map(|turn| turn.as_flattened());
        entries.any(|entry| match entry {
            Value::Baked(_) => false,
            Value::Runtime(id) => derivative.by.iter().any(|variable| variable.has(*id)),
        })
    }

    /// True where `other` is derivatives of this function that may have computed its values.
    pub(super) fn may_be_told_by(&self, other: &Self) -> bool {
        let is_solved = self.function.needed.is_some() && self.derivative.is_none();
        is_solved && other.is_whole_derivative() && other.values().name() == self.name()
    }

    /// Derives it after others, in the same graph, by its candidate of this formulation or by its first. Returns the values of
    /// what it differentiates, where the derivatives needed them.
    pub(super) fn derive_in(
        &self,
        derived: &mut Derived,
        tree: &Tree,
        formulation: Formulation,
        plan: &Plan,
    ) -> Option<Vec<Expr>> {
        let candidate = self.candidate(tree, formulation);
        let first = derived.roots.len();
        let in_own_way =
            candidate.formulation == Formulation::Recursive && plan.uses(Technique::Composite);
        if in_own_way
            && self.is_whole_derivative()
            && let Some(told) = self.derive_matrices(derived, tree, formulation, plan)
        {
            return told.values;
        }
        // No sweep goes through calls.
        let is_swept = self.derivative.is_some();
        let one_by_one = is_swept.then(|| plan.with(Technique::Lockstep, false));
        let plan = one_by_one.as_ref().unwrap_or(plan);
        candidate.derive_in(derived, tree, plan, self.subject.as_ref());
        if let Some(derivative) = &self.derivative {
            let own_length = |dimension| self.own_length(dimension, tree, 0);
            let outputs = self.function.outputs.iter();
            let lengths = outputs.map(|output| output.shape.lengths(tree, own_length));
            let sizes: Vec<usize> = lengths.map(|lengths| lengths.iter().product()).collect();
            let multipliers = derivative.arguments(self.function.outputs, self.own_of_subject());
            let own = (&multipliers[..], self.sparsity(tree));
            if in_own_way
                && !self.is_second_derivative()
                && let Some(needed) = self.function.needed
            {
                let (of, needed) = ((tree, plan), (first, needed));
                derivative.apply_to_solution(derived, of, needed, own);
                return None;
            }
            let is_reverse = plan.uses(Technique::Reverse);
            derivative.apply(derived, tree, (first, &sizes), is_reverse, own);
        }
        None
    }
}
