//! What parts of a joined function tell one another.

use super::{Direct, Part};
use crate::{
    expr::{Expr, ExprGraph},
    functions::{
        derivatives::matrices::is_known,
        derived::Derived,
        told::{KnownMatrix, ReadOff, Told},
    },
    recursive::Plan,
    tree::Tree,
};

impl Part {
    /// True where deriving this part may tell the other one.
    pub(in crate::functions) fn may_tell(&self, other: &Self) -> bool {
        if other.read_off().is_some() {
            return self.finds_matrix_of(other);
        }
        let direct = self.direct();
        let tells = matches!(direct, Some(Direct::Matrices(_) | Direct::Second));
        tells && other.derivative.is_none() && self.values().name() == other.name()
    }

    /// True where the other one may be read off a matrix that this part finds.
    pub(in crate::functions) fn finds_matrix_of(&self, other: &Self) -> bool {
        let read_off = other.read_off();
        read_off.is_some_and(|own| self.finds().contains(&own.matrix))
    }

    /// How its entries are read off a matrix that others may find, if they can be.
    fn read_off(&self) -> Option<&'static ReadOff> {
        let function = match self.direct() {
            Some(Direct::Function(function)) => function,
            _ if self.derivative.is_some() => return None,
            _ => self.function,
        };
        function.read_off.as_ref()
    }

    /// The matrices that it may find beside its entries. Second derivatives find those of first ones.
    fn finds(&self) -> &'static [KnownMatrix] {
        let function = self.function;
        let Some(derivative) = &self.derivative else {
            return function.beside.map_or(&[][..], |own| own.matrices);
        };
        match self.direct() {
            Some(Direct::Function(own)) => {
                let read_off = own.read_off.as_ref();
                read_off.map_or(&[], |own| std::slice::from_ref(&own.matrix))
            }
            Some(Direct::Matrices(_) | Direct::Second) if derivative.by.iter().any(is_known) => {
                function.derivatives_tell
            }
            _ => &[],
        }
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
        let Some(ReadOff { matrix, entries }) = self.read_off() else {
            let is_value = self.derivative.is_none();
            return is_value
                .then(|| told.values(&self.name()).cloned())
                .flatten();
        };
        let matrix = told.matrix(*matrix).filter(|_| is_read_off)?;
        if self.derivative.is_none() {
            return Some(entries(graph, tree, plan, matrix));
        }
        let mut read = Derived::default();
        let sparsity = self.sparsity(tree);
        let sizes = self.output_sizes(tree);
        read.put(&sizes, std::slice::from_ref(matrix), sparsity.as_deref());
        Some(read.roots)
    }
}
