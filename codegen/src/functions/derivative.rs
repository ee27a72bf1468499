//! A derivative of a function of the catalogue: its outputs, and how it follows from the function's own.

use super::{
    derived::Derived,
    function::{Jacobians, Output},
    shape::Shape,
    variable::Variable,
};
use crate::{
    differentiate::{Row, Seeds, forward, reverse},
    recursive::Plan,
    tree::Tree,
};

/// What a function is differentiated by: of each output an entry is a row, each variable's entries are columns.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Derivative {
    /// The variables, in the order asked for.
    pub by: Vec<Variable>,
}

impl Derivative {
    /// The names of the variables with something between them.
    pub(super) fn joined(&self, between: &str) -> String {
        let names: Vec<&str> = self.by.iter().map(Variable::name).collect();
        names.join(between)
    }

    /// What the derivative writes: for each output, as many as there are variables.
    pub(super) fn outputs(&self, of: &[Output]) -> Vec<Output> {
        let by_all = |output: &Output| {
            let by = |variable: &Variable| Output {
                name: format!("d{}_d{}", output.name, variable.name()).into(),
                shape: Shape {
                    by: variable.axes(),
                    ..output.shape
                },
            };
            self.by.iter().map(by).collect::<Vec<_>>()
        };
        of.iter().flat_map(by_all).collect()
    }

    /// Lines of documentation; `of` is the text of the function.
    pub(super) fn doc(&self, of: &str, outputs: &[Output]) -> Vec<String> {
        let mut lines = vec![format!(
            "The derivatives of `{of}`: rows are the entries of its outputs, columns those of the variables."
        )];
        let by_all = outputs.iter().zip(self.by.iter().cycle());
        lines.extend(
            by_all.map(|(output, variable)| {
                format!("- `{}`: by {}.", output.name, variable.meaning())
            }),
        );
        lines
    }

    /// Derives them by these, where all its variables are among what is told.
    pub(super) fn by_jacobians(
        &self,
        derived: &mut Derived,
        tree: &Tree,
        plan: &Plan,
        jacobians: Jacobians,
    ) -> bool {
        let told = jacobians(&mut derived.graph, tree, plan);
        let find = |variable: &Variable| {
            let mut told = told.iter();
            let found = told.find(|(argument, _)| Variable::Given(*argument) == *variable)?;
            Some(found.1.concat())
        };
        let found: Option<Vec<_>> = self.by.iter().map(find).collect();
        let is_found = found.is_some();
        derived.roots.extend(found.into_iter().flatten().flatten());
        is_found
    }

    /// Puts the derivatives in the place of the values that were derived last, the entries of outputs with `sizes`.
    pub(super) fn apply(
        &self,
        derived: &mut Derived,
        tree: &Tree,
        (first, sizes): (usize, &[usize]),
        is_reverse: bool,
    ) {
        let values = derived.roots.split_off(first);
        let graph = &mut derived.graph;
        graph.enter(None);
        let mut seeds = Seeds::new();
        let mut columns = Vec::with_capacity(self.by.len());
        let mut n_columns = 0;
        for variable in &self.by {
            variable.seed(graph, tree, n_columns, &mut seeds);
            columns.push(n_columns..n_columns + variable.n_entries(tree));
            n_columns = columns.last().map_or(0, |last| last.end);
        }
        let sweep = if is_reverse { reverse } else { forward };
        let rows = sweep(graph, &values, &seeds);
        let mut rest = &rows[..];
        for &size in sizes {
            let (own, others) = rest.split_at(size);
            rest = others;
            for columns in &columns {
                for row in own {
                    derived.extend_by(row, columns.clone());
                }
            }
        }
    }
}

impl Derived {
    /// Adds the entries of a row in these columns, zeros among them.
    fn extend_by(&mut self, row: &Row, columns: std::ops::Range<usize>) {
        let zero = self.graph.zero();
        let start = row.partition_point(|&(place, _)| place < columns.start);
        let mut own = row[start..].iter().peekable();
        for column in columns {
            let entry = own.next_if(|&&(place, _)| place == column);
            self.roots.push(entry.map_or(zero, |&(_, entry)| entry));
        }
    }
}
