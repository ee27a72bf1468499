//! Ways to derive a function: candidates, of which the one with the fewest operations is emitted.

use std::fmt;

use super::{
    derived::{Derived, pattern},
    subject::Subject,
};
use crate::{
    expr::{Expr, ExprGraph},
    id::BodyMap,
    partition::Row,
    recursive::Plan,
    tree::Tree,
};

/// How the sums over bodies are associated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Formulation {
    /// The notes' equations as they stand.
    Notes,
    /// Re-associated along the tree.
    Recursive,
}

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
#[derive(Clone, Copy)]
enum Rule {
    /// From the tree.
    Plain(fn(&mut ExprGraph, &Tree) -> Vec<Expr>),
    /// From the tree, by a plan that is searched for.
    Planned(fn(&mut ExprGraph, &Tree, &Plan) -> Vec<Expr>),
    /// Compact partial velocities, from the tree.
    Columns(fn(&mut ExprGraph, &Tree) -> BodyMap<Row>),
    /// Of frames, along the links of a plan, or by the notes' equations, which need none.
    OfFrame(OfFrame),
}

/// The entries of a function of frames; without a plan, by the notes' equations.
pub(super) type OfFrame = fn(&mut ExprGraph, &Tree, Option<&Plan>, &Subject) -> Vec<Expr>;

impl Candidate {
    /// The notes' equations.
    pub(super) const fn plain(entries: fn(&mut ExprGraph, &Tree) -> Vec<Expr>) -> Self {
        Self::new(Formulation::Notes, Rule::Plain(entries))
    }

    /// The notes' equations, for compact partial velocities.
    pub(super) const fn columns(rows: fn(&mut ExprGraph, &Tree) -> BodyMap<Row>) -> Self {
        Self::new(Formulation::Notes, Rule::Columns(rows))
    }

    /// Both, for a function of frames.
    pub(super) const fn of_frame(entries: OfFrame) -> [Self; 2] {
        [
            Self::new(Formulation::Notes, Rule::OfFrame(entries)),
            Self::new(Formulation::Recursive, Rule::OfFrame(entries)),
        ]
    }

    /// The same where sums have at least so many terms in the notes.
    pub(super) const fn of_frame_with_terms(
        entries: OfFrame,
        least_terms: fn(&Tree, &Subject) -> usize,
    ) -> [Self; 2] {
        let [mut notes, recursive] = Self::of_frame(entries);
        notes.least_terms = Terms::OfFrames(least_terms);
        [notes, recursive]
    }

    /// The same where both factorise the mass matrix, whose sums have at least so many terms in the notes.
    pub(super) const fn of_frames_factorising(
        entries: OfFrame,
        least_terms: fn(&Tree) -> usize,
    ) -> [Self; 2] {
        let [notes, recursive] = Self::of_frame(entries);
        let notes = notes.with_terms(least_terms);
        [notes.factorising(), recursive.factorising()]
    }

    /// Sums re-associated along the tree, by a plan.
    pub(super) const fn planned(entries: fn(&mut ExprGraph, &Tree, &Plan) -> Vec<Expr>) -> Self {
        Self::new(Formulation::Recursive, Rule::Planned(entries))
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
    pub(super) const fn with_terms(self, least_terms: fn(&Tree) -> usize) -> Self {
        Self {
            least_terms: Terms::OfTree(least_terms),
            ..self
        }
    }

    /// The same, for one that factorises the mass matrix.
    pub(super) const fn factorising(self) -> Self {
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
        match self.rule {
            Rule::Plain(_) | Rule::Columns(_) => false,
            Rule::Planned(_) => true,
            Rule::OfFrame(_) => self.formulation == Formulation::Recursive,
        }
    }

    /// True where inertias have a say in which plan is cheapest.
    pub(super) fn reads_inertias(&self) -> bool {
        let moves_only = matches!(self.rule, Rule::OfFrame(_)) && !self.factorises;
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
        let entries = match self.rule {
            Rule::Plain(entries) => entries(graph, tree),
            Rule::Planned(entries) => entries(graph, tree, plan),
            Rule::OfFrame(entries) => {
                let subject = subject.expect("functions: what is of a frame has one");
                entries(graph, tree, self.takes_plan().then_some(plan), subject)
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

impl Formulation {
    /// "notes" or "recursive".
    pub fn name(self) -> &'static str {
        match self {
            Self::Notes => "notes",
            Self::Recursive => "recursive",
        }
    }
}

impl fmt::Debug for Rule {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Plain(_) => "Plain",
            Self::Planned(_) => "Planned",
            Self::Columns(_) => "Columns",
            Self::OfFrame(_) => "OfFrame",
        })
    }
}
