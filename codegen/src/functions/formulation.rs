//! How the sums over bodies are associated: what a user may choose, and what a derivation is told.

use crate::recursive::Plan;

/// How the sums over bodies are associated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Formulation {
    /// The notes' equations as they stand.
    Notes,
    /// Re-associated along the tree.
    Recursive,
}

/// A formulation with all that deriving by it takes.
#[derive(Clone, Copy, Debug)]
pub(super) enum Way<'a> {
    /// The notes' equations as they stand.
    Notes,
    /// Re-associated along the tree, as this plan says.
    Recursive(&'a Plan),
}

impl Formulation {
    /// "notes" or "recursive".
    pub fn name(self) -> &'static str {
        match self {
            Self::Notes => "notes",
            Self::Recursive => "recursive",
        }
    }

    /// The way to derive by it; only the recursion reads the plan.
    pub(super) fn by(self, plan: &Plan) -> Way<'_> {
        match self {
            Self::Notes => Way::Notes,
            Self::Recursive => Way::Recursive(plan),
        }
    }
}
