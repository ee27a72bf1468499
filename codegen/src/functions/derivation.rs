//! How the entries of a function are derived.

use super::{
    derived::{Derived, pattern},
    formulation::{Formulation, Way},
    subject::Subject,
};
use crate::{
    expr::{Expr, ExprGraph},
    id::BodyMap,
    partition::Row,
    tree::Tree,
};

/// How the entries of a function are derived: from which equations, of what.
#[derive(Clone, Copy, Debug)]
pub(super) enum Derivation {
    /// By the notes' equations alone.
    Notes(fn(&mut ExprGraph, &Tree) -> Vec<Expr>),
    /// Compact partial velocities, by the notes' equations alone.
    Columns(fn(&mut ExprGraph, &Tree) -> BodyMap<Row>),
    /// Either way.
    EitherWay(EitherWay),
    /// Of frames, either way.
    OfFrames(fn(&mut ExprGraph, &Tree, Way<'_>, &Subject) -> Vec<Expr>),
}

/// The derivation by the notes' equations, or by the recursion, whose entries are all that the function has.
macro_rules! either {
    ($notes:path, $recursive:path) => {
        $crate::functions::derivation::Derivation::EitherWay(|graph, tree, way| match way {
            $crate::functions::formulation::Way::Notes => {
                $crate::functions::entries::Entries::entries($notes(graph, tree))
            }
            $crate::functions::formulation::Way::Recursive(plan) => {
                $crate::functions::entries::Entries::entries($recursive(graph, tree, plan))
            }
        })
    };
}
pub(super) use either;

/// The entries of a function of the system, either way.
pub(super) type EitherWay = fn(&mut ExprGraph, &Tree, Way<'_>) -> Vec<Expr>;

impl Derivation {
    /// Those in which it can be derived, the notes' first.
    pub(super) fn formulations(self) -> &'static [Formulation] {
        match self {
            Self::Notes(_) | Self::Columns(_) => &[Formulation::Notes],
            Self::EitherWay(_) | Self::OfFrames(_) => &[Formulation::Notes, Formulation::Recursive],
        }
    }

    /// Adds the entries to what was derived before. What is derived by the notes alone takes no notice of the way.
    pub(super) fn derive_in(
        self,
        derived: &mut Derived,
        tree: &Tree,
        way: Way<'_>,
        subject: Option<&Subject>,
    ) {
        let graph = &mut derived.graph;
        let entries = match self {
            Self::Notes(entries) => entries(graph, tree),
            Self::EitherWay(entries) => entries(graph, tree, way),
            Self::OfFrames(entries) => {
                let subject = subject.expect("functions: what is of a frame has one");
                entries(graph, tree, way, subject)
            }
            Self::Columns(rows) => {
                let rows = rows(graph, tree);
                derived.blocks = pattern(tree, &rows);
                let columns = rows.iter().flat_map(|row| row.columns(graph, tree));
                columns.flat_map(|(_, column)| column).collect()
            }
        };
        derived.roots.extend(entries);
    }
}
