//! What a function runs on several columns, as a function of one.

use super::{Code, Counted, Stage};
use crate::{
    functions::{Declared, Signature},
    program::Operations,
};

/// A helper of a function.
#[derive(Clone, Debug)]
pub struct Helper {
    /// On how many columns it is run.
    pub lanes: usize,
    /// How it is declared, for one of them.
    pub signature: Signature,
    /// What each argument is.
    pub roles: Vec<Role>,
    /// Its operations, for one column.
    pub operations: Operations,
    /// How many pairs of a multiplication and an addition are fused.
    pub fused: usize,
    /// What it does.
    pub code: Code,
    /// The same in several loops over the columns, where it reads and writes many rows.
    pub loops: Vec<Stage>,
}

/// What an argument of a helper is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// What all columns share.
    Shared,
    /// What is of one column.
    Sides,
    /// What is computed of one column.
    Solved,
}

impl Helper {
    /// The argument that is this, if there is one.
    pub fn argument(&self, role: Role) -> Option<&Declared> {
        let place = self.roles.iter().position(|own| *own == role)?;
        self.signature.arguments.get(place)
    }

    /// Lines that say what it costs, for one column.
    pub fn cost(&self) -> Vec<String> {
        let counted = Counted {
            operations: self.operations,
            formulation: None,
        };
        counted.lines(self.fused)
    }
}

impl Role {
    /// What such an argument is called.
    pub fn name(self) -> &'static str {
        match self {
            Self::Shared => "shared",
            Self::Sides => "sides",
            Self::Solved => "solved",
        }
    }
}
