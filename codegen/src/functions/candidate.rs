//! Ways to derive a function: candidates, of which the one with the fewest operations is emitted.

use super::{
    derived::{Derived, pattern},
    formulation::{Formulation, Way},
    subject::Subject,
};
use crate::{
    expr::{Expr, ExprGraph},
    id::BodyMap,
    partition::Row,
    recursive::Plan,
    tree::Tree,
};

/// One way to derive a function.
#[derive(Clone, Copy, Debug)]
pub struct Candidate {
    /// How sums over bodies are associated.
    pub formulation: Formulation,
    least_terms: Terms,
    /// True where the mass matrix is factorised whatever the plan, though no accelerations are solved for.
    pub factorises: bool,
    rule: Rule,
}

/// How many terms sums have at least.
#[derive(Clone, Copy, Debug)]
enum Terms {
    OfTree(fn(&Tree) -> usize),
    OfFrames(fn(&Tree, &Subject) -> usize),
}

/// How entries are built.
#[derive(Clone, Copy, Debug)]
enum Rule {
    /// By the notes' equations alone.
    Notes(fn(&mut ExprGraph, &Tree) -> Vec<Expr>),
    /// Compact partial velocities, by the notes' equations alone.
    Columns(fn(&mut ExprGraph, &Tree) -> BodyMap<Row>),
    /// Either way.
    Either(Either),
    /// Of frames, either way.
    OfFrames(OfFrames),
}

/// The entries of a function of the system.
pub(super) type Either = fn(&mut ExprGraph, &Tree, Way<'_>) -> Vec<Expr>;

/// The entries of a function of frames.
pub(super) type OfFrames = fn(&mut ExprGraph, &Tree, Way<'_>, &Subject) -> Vec<Expr>;

impl Candidate {
    /// The notes' equations.
    pub(super) const fn notes(entries: fn(&mut ExprGraph, &Tree) -> Vec<Expr>) -> Self {
        Self::new(Formulation::Notes, Rule::Notes(entries))
    }

    /// The notes' equations, for compact partial velocities.
    pub(super) const fn columns(rows: fn(&mut ExprGraph, &Tree) -> BodyMap<Row>) -> Self {
        Self::new(Formulation::Notes, Rule::Columns(rows))
    }

    /// Both ways.
    pub(super) const fn either(entries: Either) -> [Self; 2] {
        Self::both(Rule::Either(entries))
    }

    /// The same where sums have at least so many terms in the notes.
    pub(super) const fn either_with_terms(
        entries: Either,
        least_terms: fn(&Tree) -> usize,
    ) -> [Self; 2] {
        let [notes, recursive] = Self::either(entries);
        [notes.with_terms(least_terms), recursive]
    }

    /// The same where both factorise the mass matrix.
    pub(super) const fn either_factorising(
        entries: Either,
        least_terms: fn(&Tree) -> usize,
    ) -> [Self; 2] {
        let [notes, recursive] = Self::either_with_terms(entries, least_terms);
        [notes.factorising(), recursive.factorising()]
    }

    /// Both ways, for a function of frames.
    pub(super) const fn of_frame(entries: OfFrames) -> [Self; 2] {
        Self::both(Rule::OfFrames(entries))
    }

    /// The same where sums have at least so many terms in the notes.
    pub(super) const fn of_frame_with_terms(
        entries: OfFrames,
        least_terms: fn(&Tree, &Subject) -> usize,
    ) -> [Self; 2] {
        let [mut notes, recursive] = Self::of_frame(entries);
        notes.least_terms = Terms::OfFrames(least_terms);
        [notes, recursive]
    }

    /// The same where both factorise the mass matrix, whose sums have at least so many terms in the notes.
    pub(super) const fn of_frames_factorising(
        entries: OfFrames,
        least_terms: fn(&Tree) -> usize,
    ) -> [Self; 2] {
        let [notes, recursive] = Self::of_frame(entries);
        let notes = notes.with_terms(least_terms);
        [notes.factorising(), recursive.factorising()]
    }

    const fn both(rule: Rule) -> [Self; 2] {
        [
            Self::new(Formulation::Notes, rule),
            Self::new(Formulation::Recursive, rule),
        ]
    }

    const fn new(formulation: Formulation, rule: Rule) -> Self {
        Self {
            formulation,
            least_terms: Terms::OfTree(|_| 0),
            factorises: false,
            rule,
        }
    }

    /// The same, with a lower bound of its terms.
    const fn with_terms(self, least_terms: fn(&Tree) -> usize) -> Self {
        Self {
            least_terms: Terms::OfTree(least_terms),
            ..self
        }
    }

    /// The same, for one that factorises the mass matrix.
    const fn factorising(self) -> Self {
        Self {
            factorises: true,
            ..self
        }
    }

    /// How many terms its sums have at least: where another candidate needs fewer operations than that, this one need
    /// not be derived to know which is cheaper.
    pub(super) fn least_terms(&self, tree: &Tree, subject: Option<&Subject>) -> usize {
        match (self.least_terms, subject) {
            (Terms::OfTree(terms), _) => terms(tree),
            (Terms::OfFrames(terms), Some(subject)) => terms(tree, subject),
            (Terms::OfFrames(_), None) => 0,
        }
    }

    /// True where a plan is to be searched for.
    pub(super) fn takes_plan(&self) -> bool {
        self.formulation == Formulation::Recursive
    }

    /// True where inertias have a say in which plan is cheapest.
    pub(super) fn reads_inertias(&self) -> bool {
        let moves_only = matches!(self.rule, Rule::OfFrames(_)) && !self.factorises;
        self.takes_plan() && !moves_only
    }

    /// Adds the entries to what was derived before.
    pub(super) fn derive_in(
        &self,
        derived: &mut Derived,
        tree: &Tree,
        plan: &Plan,
        subject: Option<&Subject>,
    ) {
        let graph = &mut derived.graph;
        let way = self.formulation.by(plan);
        let entries = match self.rule {
            Rule::Notes(entries) => entries(graph, tree),
            Rule::Either(entries) => entries(graph, tree, way),
            Rule::OfFrames(entries) => {
                let subject = subject.expect("functions: what is of a frame has one");
                entries(graph, tree, way, subject)
            }
            Rule::Columns(rows) => {
                let rows = rows(graph, tree);
                derived.blocks = pattern(tree, &rows);
                let columns = rows.iter().flat_map(|row| row.columns(graph, tree));
                columns.flat_map(|(_, column)| column).collect()
            }
        };
        derived.roots.extend(entries);
    }
}
