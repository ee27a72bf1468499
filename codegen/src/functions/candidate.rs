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
pub struct Candidate<R> {
    /// How sums over bodies are associated.
    pub formulation: Formulation,
    /// How many terms its sums have at least: where another candidate needs fewer operations than that, this one need
    /// not be derived to know which is cheaper.
    pub least_terms: fn(&Tree) -> usize,
    pub(super) rule: R,
}

/// How entries of a function of the whole system are built.
#[derive(Clone, Copy)]
pub enum Rule {
    /// From the tree.
    Plain(fn(&mut ExprGraph, &Tree) -> Vec<Expr>),
    /// From the tree, by a plan that is searched for.
    Planned(fn(&mut ExprGraph, &Tree, &Plan) -> Vec<Expr>),
    /// Compact partial velocities.
    Columns(fn(&mut ExprGraph, &Tree) -> BodyMap<Row>),
}

/// How entries of a function of a frame are built.
#[derive(Clone, Copy)]
pub enum FrameRule {
    /// From the tree.
    Plain(fn(&mut ExprGraph, &Tree, &Subject) -> Vec<Expr>),
    /// From the tree, by a plan that is searched for.
    Planned(fn(&mut ExprGraph, &Tree, &Plan, &Subject) -> Vec<Expr>),
}

impl Candidate<Rule> {
    /// The notes' equations.
    pub(super) const fn plain(entries: fn(&mut ExprGraph, &Tree) -> Vec<Expr>) -> Self {
        Self::new(Formulation::Notes, Rule::Plain(entries))
    }

    /// The notes' equations, for compact partial velocities.
    pub(super) const fn columns(rows: fn(&mut ExprGraph, &Tree) -> BodyMap<Row>) -> Self {
        Self::new(Formulation::Notes, Rule::Columns(rows))
    }

    /// Sums re-associated along the tree, by a plan.
    pub(super) const fn planned(entries: fn(&mut ExprGraph, &Tree, &Plan) -> Vec<Expr>) -> Self {
        Self::new(Formulation::Recursive, Rule::Planned(entries))
    }

    /// True where a plan is to be searched for.
    pub(super) fn takes_plan(&self) -> bool {
        matches!(self.rule, Rule::Planned(_))
    }

    /// Adds the entries to what was derived before.
    pub(super) fn derive_in(&self, derived: &mut Derived, tree: &Tree, plan: &Plan) {
        let graph = &mut derived.graph;
        match self.rule {
            Rule::Plain(entries) => derived.roots.extend(entries(graph, tree)),
            Rule::Planned(entries) => derived.roots.extend(entries(graph, tree, plan)),
            Rule::Columns(rows) => {
                let rows = rows(graph, tree);
                derived.blocks = pattern(tree, &rows);
                for row in rows.iter() {
                    let columns = row.columns(graph, tree);
                    let columns = columns.into_iter().flat_map(|(_, column)| column);
                    derived.roots.extend(columns);
                }
            }
        }
    }
}

impl Candidate<FrameRule> {
    /// The notes' equations.
    pub(super) const fn plain_of_frame(
        entries: fn(&mut ExprGraph, &Tree, &Subject) -> Vec<Expr>,
    ) -> Self {
        Self::new(Formulation::Notes, FrameRule::Plain(entries))
    }

    /// Along the links of a plan.
    pub(super) const fn planned_of_frame(
        entries: fn(&mut ExprGraph, &Tree, &Plan, &Subject) -> Vec<Expr>,
    ) -> Self {
        Self::new(Formulation::Recursive, FrameRule::Planned(entries))
    }

    /// True where a plan is to be searched for.
    pub(super) fn takes_plan(&self) -> bool {
        matches!(self.rule, FrameRule::Planned(_))
    }

    /// Adds the entries to what was derived before.
    pub(super) fn derive_in(
        &self,
        derived: &mut Derived,
        tree: &Tree,
        plan: &Plan,
        subject: &Subject,
    ) {
        let graph = &mut derived.graph;
        derived.roots.extend(match self.rule {
            FrameRule::Plain(entries) => entries(graph, tree, subject),
            FrameRule::Planned(entries) => entries(graph, tree, plan, subject),
        });
    }
}

impl<R: Copy> Candidate<R> {
    const fn new(formulation: Formulation, rule: R) -> Self {
        Self {
            formulation,
            least_terms: |_| 0,
            rule,
        }
    }

    /// The same, with a lower bound of its terms.
    pub(super) const fn with_terms(self, least_terms: fn(&Tree) -> usize) -> Self {
        Self {
            least_terms,
            ..self
        }
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
        })
    }
}

impl fmt::Debug for FrameRule {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Plain(_) => "Plain",
            Self::Planned(_) => "Planned",
        })
    }
}
