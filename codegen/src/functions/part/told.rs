//! What parts of a joined function tell one another.

use super::Part;
use crate::{
    expr::{Expr, ExprGraph},
    functions::{
        derivatives::{derivative::Derivative, jacobians},
        told::{ReadOff, Told},
    },
    recursive::Plan,
    tree::Tree,
};

impl Part {
    /// True where deriving this part may tell the other one.
    pub(in crate::functions) fn may_tell(&self, other: &Self) -> bool {
        if other.function.read_off.is_some() {
            return self.finds_matrix_of(other);
        }
        let tells = self.is_whole_derivative() && self.function.derivatives.is_some()
            || self.is_second_derivative() && self.function.inverse_dynamics.is_some();
        tells && other.derivative.is_none() && self.values().name() == other.name()
    }

    /// True where the other one may be read off a matrix that this part finds.
    pub(in crate::functions) fn finds_matrix_of(&self, other: &Self) -> bool {
        let Some(ReadOff { matrix, .. }) = &other.function.read_off else {
            return false;
        };
        let function = self.function;
        let found = match &self.derivative {
            None => function.beside.map_or(&[][..], |own| own.matrices),
            Some(derivative) if self.finds_matrices(derivative) => function.derivatives_tell,
            Some(_) => &[],
        };
        other.derivative.is_none() && found.contains(matrix)
    }

    /// True where its derivatives come from matrices, its own or those that second ones are made of.
    fn finds_matrices(&self, derivative: &Derivative) -> bool {
        let is_second = self.is_second_derivative() && self.function.inverse_dynamics.is_some();
        (self.is_whole_derivative() || is_second) && derivative.by.iter().any(jacobians::is_known)
    }

    /// Its entries, if others told them. `is_read_off`: they may be read off a matrix.
    pub(in crate::functions) fn told_by(
        &self,
        graph: &mut ExprGraph,
        tree: &Tree,
        plan: &Plan,
        told: &Told,
        is_read_off: bool,
    ) -> Option<Vec<Expr>> {
        if self.derivative.is_some() {
            return None;
        }
        let Some(ReadOff { matrix, entries }) = self.function.read_off else {
            return told.values(&self.name()).cloned();
        };
        let matrix = told.matrix(matrix).filter(|_| is_read_off)?;
        Some(entries(graph, tree, plan, matrix))
    }
}
