//! From a part to the expressions of its outputs.

use super::{
    Part,
    route::{Direct, Route},
};
use crate::{
    expr::Expr,
    functions::{
        derivatives::{
            derivative::{Asked, Derivative, sweep},
            solved::Solution,
        },
        derived::Derived,
        formulation::Formulation,
        function::Function,
        told::Told,
    },
    recursive::{Plan, Technique},
    tree::Tree,
};

impl Part {
    /// Derives the values of its function after others, in the same graph, in this formulation where it can be.
    pub(in crate::functions) fn derive_values(
        &self,
        derived: &mut Derived,
        tree: &Tree,
        formulation: Formulation,
        plan: &Plan,
    ) {
        let way = self.formulation(tree, formulation).by(plan);
        let subject = self.subject.as_ref();
        self.function
            .derivation
            .derive_in(derived, tree, way, subject);
    }

    /// Derives it after others, in the same graph, in this formulation where it can be. Returns what it found of
    /// others.
    pub(in crate::functions) fn derive_in(
        &self,
        derived: &mut Derived,
        tree: &Tree,
        formulation: Formulation,
        plan: &Plan,
    ) -> Told {
        let by = (formulation, plan);
        match self.route(tree, formulation, plan) {
            Route::Values => self.derive_values(derived, tree, formulation, plan),
            Route::Swept => self.derive_swept(derived, tree, by, false),
            Route::Direct(Direct::Function(function)) => {
                return self.derive_as(function, derived, tree, by);
            }
            Route::Direct(Direct::Matrices(derivatives)) => {
                let found = self.derive_matrices(derived, tree, by, derivatives);
                let matrices = self.function.derivatives_tell;
                return found.into_told(self.values().name(), matrices);
            }
            Route::Direct(Direct::Second) => {
                return self.derive_second(derived, tree, by);
            }
            Route::Direct(Direct::Solved) => self.derive_swept(derived, tree, by, true),
        }
        Told::default()
    }

    /// Derivatives that are the entries of a function: of a matrix over speeds that others may be read off, or of rows.
    fn derive_as(
        &self,
        function: &Function,
        derived: &mut Derived,
        tree: &Tree,
        (formulation, plan): (Formulation, &Plan),
    ) -> Told {
        let first = derived.roots.len();
        let (way, subject) = (formulation.by(plan), self.subject.as_ref());
        function.derivation.derive_in(derived, tree, way, subject);
        let entries = derived.roots.split_off(first);
        let n_columns = self.n_variables(tree);
        let rows: Vec<Vec<Expr>> = entries.chunks(n_columns).map(<[Expr]>::to_vec).collect();
        let sizes = self.output_sizes(tree);
        let sparsity = self.sparsity(tree);
        derived.put(&sizes, std::slice::from_ref(&rows), sparsity.as_deref());
        let told = Told::default();
        match function.read_off {
            Some(own) => told.with(own.matrix, rows),
            None => told,
        }
    }

    /// Derivatives by sweeps over the values; where these are accelerations that need such forces, over the forces.
    fn derive_swept(
        &self,
        derived: &mut Derived,
        tree: &Tree,
        (formulation, plan): (Formulation, &Plan),
        is_solved: bool,
    ) {
        // No sweep goes through calls.
        let plan = &plan.with(Technique::Lockstep, false);
        let first = derived.roots.len();
        self.derive_values(derived, tree, formulation, plan);
        let values = derived.roots.split_off(first);
        let derivative = self.differentiated();
        let multipliers = derivative.arguments(self.function.outputs, self.subject_length());
        let sparsity = self.sparsity(tree);
        let asked = Asked {
            multipliers: &multipliers,
            sparsity: sparsity.as_deref(),
        };
        if let Some(solution) = self.solution(tree, &values).filter(|_| is_solved) {
            return derivative.apply_to_solution(derived, tree, plan, &solution, asked);
        }
        let sizes = self.output_sizes(tree);
        derivative.apply(derived, tree, &values, &sizes, sweep(plan), asked);
    }

    /// What it solves for, if it does.
    pub(in crate::functions) fn solution<'a>(
        &self,
        tree: &'a Tree,
        values: &'a [Expr],
    ) -> Option<Solution<'a>> {
        Some(Solution {
            values,
            inverse_dynamics: self.function.inverse_dynamics?,
            prescribed: self.function.prescribes.then_some(&tree.prescribed),
        })
    }

    /// The derivative that it is.
    pub(in crate::functions) fn differentiated(&self) -> &Derivative {
        let derivative = self.derivative.as_ref();
        derivative.expect("functions: a route of derivatives is of one")
    }

    /// The same where others ask for what its recursion finds beside its entries.
    pub(in crate::functions) fn derive_with_matrices(
        &self,
        derived: &mut Derived,
        tree: &Tree,
        formulation: Formulation,
        plan: &Plan,
    ) -> Told {
        if let Some(beside) = self.function.beside
            && self.derivative.is_none()
            && self.formulation(tree, formulation) == Formulation::Recursive
        {
            let (entries, told) = (beside.derive)(&mut derived.graph, tree, plan);
            derived.roots.extend(entries);
            return told;
        }
        self.derive_in(derived, tree, formulation, plan)
    }
}
