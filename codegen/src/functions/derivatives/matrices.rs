//! Whole derivatives that have a way of their own, a matrix for each variable: by coordinates, speeds, accelerations and forces in that way,
//! by loads and parameters, which it does not know, beside it.

use super::{
    derivative::{Derivative, DerivativeKind},
    solved::is_worth_an_inverse,
    sparsity::Sparsity,
};
use crate::{
    expr::Expr,
    functions::{
        argument::Argument,
        derived::Derived,
        formulation::Formulation,
        function::{ByArguments, DerivativesFn},
        part::Part,
        told::{KnownMatrix, Told},
        variable::Variable,
    },
    recursive::{Plan, Technique},
    tree::Tree,
};

/// A row for each entry of the output, a column for each of a variable.
type Matrix = Vec<Vec<Expr>>;

/// True for what such a way knows: all that functions are given but loads.
pub(in crate::functions) fn is_known(variable: &Variable) -> bool {
    matches!(variable, Variable::Given(own) if *own != Argument::Loads)
}

impl Part {
    /// Derives all matrices, those that the function has a way for and others beside. The values, where they were needed.
    pub(in crate::functions) fn derive_matrices(
        &self,
        derived: &mut Derived,
        tree: &Tree,
        (formulation, plan): (Formulation, &Plan),
        derivatives: DerivativesFn,
    ) -> ByArguments {
        let derivative = self.differentiated();
        let others = derivative.by.iter().filter(|by| !is_known(by));
        let others = others.cloned().collect();
        let subject = self.subject.as_ref();
        let told = derivatives.derive(&mut derived.graph, tree, plan, subject);
        let others = Derivative::new(DerivativeKind::Jacobian, others);
        let mut others = self
            .matrices_of_others(derived, tree, (formulation, plan), others, &told)
            .into_iter();
        let found = derivative.by.iter().map(|variable| {
            let own = told.by(variable).cloned();
            own.or_else(|| others.next())
                .expect("functions: each variable has a matrix")
        });
        let found: Vec<Matrix> = found.collect();
        let sizes = self.output_sizes(tree);
        derived.put(&sizes, &found, self.sparsity(tree).as_deref());
        told
    }

    /// Those by other variables, beside what is told.
    fn matrices_of_others(
        &self,
        derived: &mut Derived,
        tree: &Tree,
        (formulation, plan): (Formulation, &Plan),
        others: Derivative,
        told: &ByArguments,
    ) -> Vec<Matrix> {
        if others.by.is_empty() {
            return Vec::new();
        }
        let mut values = told.values.iter();
        if let Some(solution) = values.find_map(|own| self.solution(tree, own)) {
            let graph = &mut derived.graph;
            // No sweep goes through calls.
            let plan = &plan.with(Technique::Lockstep, false);
            let columns = others.columns(graph, tree, plan, &solution);
            // Where the inverse is asked for it costs nothing more.
            let tau = Variable::Given(Argument::Tau);
            let is_asked_for = self.derivative.iter().any(|own| own.by.contains(&tau));
            let is_worth_it = is_asked_for || is_worth_an_inverse(tree, &columns);
            let by_forces = told.by(&tau).filter(|_| is_worth_it);
            let solved = solution.solved(graph, tree, plan, by_forces, columns);
            return others.of_columns(tree, &solved, solution.values.len());
        }
        let n_columns = others.by.iter().map(|own| own.n_entries(tree));
        let n_columns: Vec<usize> = n_columns.collect();
        let first = derived.roots.len();
        let part = Self {
            derivative: Some(others),
            ..self.clone()
        };
        part.derive_in(derived, tree, formulation, plan);
        let roots = derived.roots.split_off(first);
        let mut rest = &roots[..];
        let mut matrices = vec![Matrix::new(); n_columns.len()];
        for n_rows in self.output_sizes(tree) {
            for (matrix, &n_columns) in matrices.iter_mut().zip(&n_columns) {
                let (own, others) = rest.split_at(n_rows * n_columns);
                rest = others;
                let row = |row: usize| own[row * n_columns..][..n_columns].to_vec();
                matrix.extend((0..n_rows).map(row));
            }
        }
        matrices
    }
}

impl ByArguments {
    /// What they tell other parts: the values are those of the function of this name; it finds these matrices.
    pub(in crate::functions) fn into_told(
        mut self,
        name: String,
        matrices: &[KnownMatrix],
    ) -> Told {
        let mut told = Told::default().with_values(name, self.values.take());
        for &matrix in matrices {
            let entries = match matrix {
                KnownMatrix::Mass => self.mass.take(),
                KnownMatrix::MassInverse => self.by(&Variable::Given(Argument::Tau)).cloned(),
                KnownMatrix::MassDot | KnownMatrix::Coriolis => {
                    unreachable!("functions: no derivatives find {matrix:?}")
                }
            };
            if let Some(entries) = entries {
                told = told.with(matrix, entries);
            }
        }
        told
    }

    pub(super) fn by(&self, variable: &Variable) -> Option<&Matrix> {
        let mut by = self.by.iter();
        let found = by.find(|(argument, _)| Variable::Given(*argument) == *variable)?;
        Some(&found.1)
    }
}

impl Derivative {
    /// The matrices, of all their columns one after the other.
    pub(in crate::functions) fn of_columns(
        &self,
        tree: &Tree,
        columns: &[Vec<Expr>],
        n_rows: usize,
    ) -> Vec<Matrix> {
        let mut rest = columns;
        let mut matrices = Vec::with_capacity(self.by.len());
        for variable in &self.by {
            let (own, others) = rest.split_at(variable.n_entries(tree));
            rest = others;
            let row = |row: usize| own.iter().map(|column| column[row]).collect();
            matrices.push((0..n_rows).map(row).collect());
        }
        matrices
    }
}

impl Derived {
    /// Adds the entries of these matrices to what is written: one for each variable, whose rows are those of outputs of these sizes, one
    /// after the other.
    pub(in crate::functions) fn put(
        &mut self,
        sizes: &[usize],
        found: &[Matrix],
        sparsity: Option<&Sparsity>,
    ) {
        let Some(Sparsity { places, .. }) = sparsity else {
            let mut first = 0;
            for size in sizes {
                let rows = first..first + size;
                let entries = found.iter().flat_map(|own| own[rows.clone()].concat());
                self.roots.extend(entries);
                first = rows.end;
            }
            return;
        };
        let of_matrix = |own: &Matrix| 0..own.first().map_or(0, Vec::len);
        let columns = found.iter().enumerate();
        let columns = columns.flat_map(|(place, own)| of_matrix(own).map(move |own| (place, own)));
        let columns: Vec<(usize, usize)> = columns.collect();
        self.roots.extend(places.iter().map(|&[row, column]| {
            let (matrix, column) = columns[column];
            found[matrix][row][column]
        }));
    }
}
