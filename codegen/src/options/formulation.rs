//! Which of the equations' forms is asked for.

use crate::functions;

/// Which of the equations' forms to generate.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Formulation {
    /// For each function whichever costs less: operations, a sine as eleven.
    #[default]
    Cheapest,
    /// The notes' equations as they stand.
    Notes,
    /// Sums over bodies re-associated along the tree.
    Recursive,
}

impl Formulation {
    /// All of them, with the names that they have in `kane.toml`.
    pub const ALL: [(&str, Self); 3] = [
        ("cheapest", Self::Cheapest),
        ("notes", Self::Notes),
        ("recursive", Self::Recursive),
    ];

    /// The one that is asked for, where it does not go by operations.
    pub fn wanted(self) -> Option<functions::Formulation> {
        match self {
            Self::Cheapest => None,
            Self::Notes => Some(functions::Formulation::Notes),
            Self::Recursive => Some(functions::Formulation::Recursive),
        }
    }
}
