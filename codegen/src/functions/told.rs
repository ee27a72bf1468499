//! What deriving one part of a function finds of others: these are then not derived again.

use crate::{
    expr::{Expr, ExprGraph},
    recursive::Plan,
    solve::SpeedMatrix,
    tree::Tree,
};

/// A matrix over speeds that several functions need.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum KnownMatrix {
    /// The mass matrix, rotors included.
    Mass,
    /// Its rate.
    MassDot,
    /// Its inverse.
    MassInverse,
    /// The Coriolis matrix.
    Coriolis,
}

/// How the entries of a function are read off a matrix that is known.
#[derive(Clone, Copy, Debug)]
pub(super) struct ReadOff {
    pub(super) matrix: KnownMatrix,
    pub(super) entries: fn(&mut ExprGraph, &Tree, &Plan, &SpeedMatrix) -> Vec<Expr>,
}

/// What a function's recursion finds beside its own entries.
#[derive(Clone, Copy, Debug)]
pub(super) struct Beside {
    pub(super) matrices: &'static [KnownMatrix],
    /// The entries, and the matrices.
    pub(super) derive: fn(&mut ExprGraph, &Tree, &Plan) -> (Vec<Expr>, Told),
}

/// What is known when a part is derived.
#[derive(Debug, Default)]
pub(super) struct Told {
    /// Of functions that were differentiated, by their names in generated code.
    values: Vec<(String, Vec<Expr>)>,
    matrices: Vec<(KnownMatrix, SpeedMatrix)>,
}

impl Told {
    /// With a matrix that was found.
    pub(super) fn with(mut self, matrix: KnownMatrix, entries: SpeedMatrix) -> Self {
        self.matrices.push((matrix, entries));
        self
    }

    /// With the values of the function of this name, where they were found.
    pub(super) fn with_values(mut self, name: String, values: Option<Vec<Expr>>) -> Self {
        self.values.extend(values.map(|values| (name, values)));
        self
    }

    /// With what another part told, which is taken first if that part is a derivative: it may write the matrix itself.
    pub(super) fn extend(&mut self, other: Self, is_derivative: bool) {
        self.values.extend(other.values);
        let place = if is_derivative {
            0
        } else {
            self.matrices.len()
        };
        self.matrices.splice(place..place, other.matrices);
    }

    /// A matrix, if it is known.
    pub(super) fn matrix(&self, matrix: KnownMatrix) -> Option<&SpeedMatrix> {
        let mut matrices = self.matrices.iter();
        let (_, found) = matrices.find(|(own, _)| *own == matrix)?;
        Some(found)
    }

    /// The values of the function of this name, if they are known.
    pub(super) fn values(&self, name: &str) -> Option<&Vec<Expr>> {
        let mut values = self.values.iter();
        let (_, found) = values.find(|(own, _)| own == name)?;
        Some(found)
    }
}
