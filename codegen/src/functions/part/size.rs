//! How large a part is.

use super::{Part, rows::Rows};
use crate::{
    differentiate::Sweep,
    expr::ExprGraph,
    functions::{
        argument::Argument,
        derivatives::derivative::DerivativeKind,
        derived::Derived,
        formulation::{Formulation, Way},
        function::Output,
        packed::Packed,
        shape::{Dimension, Length},
        terms,
        variable::Variable,
    },
    recursive::Plan,
    tree::{N_INERTIAL, Tree},
};

/// How many operations a gradient needs for each of what is differentiated, at most.
const SLOPES: usize = 4;

impl Part {
    /// How many terms the notes' sums have at least; where they are differentiated, about so many for every row that is swept.
    pub(in crate::functions) fn literal_terms(&self, tree: &Tree) -> usize {
        let terms = self.function.terms.least(tree, self.subject.as_ref());
        let Rows { forward, reverse } = self.swept_rows(tree);
        terms * forward.min(reverse).max(1)
    }

    /// How many entries each output of its values has.
    pub(in crate::functions) fn output_sizes(&self, tree: &Tree) -> Vec<usize> {
        let own_length = |dimension| self.own_length(dimension, tree, 0);
        let outputs = self.function.outputs.iter();
        let lengths = outputs.map(|output| output.shape.lengths(tree, own_length));
        lengths.map(|lengths| lengths.iter().product()).collect()
    }

    /// How many entries the variables have together.
    pub(in crate::functions) fn n_variables(&self, tree: &Tree) -> usize {
        let by = self.derivative.iter().flat_map(|derivative| &derivative.by);
        by.map(|variable| variable.n_entries(tree)).sum()
    }

    /// How many operations second derivatives build, about: four times the nodes of what is swept, for each variable. Where accelerations
    /// are differentiated directly, forces are swept, to which `tau` is only added, and products with first derivatives come to it.
    pub(in crate::functions) fn n_second_operations(&self, tree: &Tree, is_direct: bool) -> usize {
        let (plan, n_variables) = (Plan::plain(tree), self.n_variables(tree));
        let Some(forces) = self.function.inverse_dynamics.filter(|_| is_direct) else {
            let mut derived = Derived::default();
            self.derive_values(&mut derived, tree, Formulation::Recursive, &plan);
            return SLOPES * derived.graph.len() * n_variables;
        };
        let mut graph = ExprGraph::default();
        let _ = forces(&mut graph, tree, Way::Recursive(&plan));
        let by = self.derivative.iter().flat_map(|derivative| &derivative.by);
        let by = by.filter(|variable| **variable != Variable::Given(Argument::Tau));
        let n_swept: usize = by.map(|variable| variable.n_entries(tree)).sum();
        SLOPES * graph.len() * n_swept + tree.n_speeds * n_swept * n_variables
    }

    /// The way to sweep for its derivatives that carries one row, if there is one.
    pub(in crate::functions) fn one_row_sweep(&self, tree: &Tree) -> Option<Sweep> {
        match self.derivative.as_ref()?.kind {
            DerivativeKind::Jvp => Some(Sweep::Forward),
            DerivativeKind::Vjp => Some(Sweep::Reverse),
            DerivativeKind::Jacobian | DerivativeKind::PackedJacobian => {
                (self.n_values_at_most(tree) == 1).then_some(Sweep::Reverse)
            }
            DerivativeKind::Hessian => None,
        }
    }

    /// How many rows each way to sweep for its derivatives carries along.
    pub(in crate::functions) fn swept_rows(&self, tree: &Tree) -> Rows {
        let Some(derivative) = &self.derivative else {
            return Rows::default();
        };
        let [forward, reverse] = [self.n_variables(tree), self.n_values_at_most(tree)];
        match derivative.kind {
            DerivativeKind::Jacobian | DerivativeKind::PackedJacobian => Rows { forward, reverse },
            DerivativeKind::Jvp => Rows {
                forward: 1,
                reverse,
            },
            DerivativeKind::Vjp => Rows {
                forward,
                reverse: 1,
            },
            // Its gradient has an entry for each variable, and changes with accelerations where these are swept for.
            DerivativeKind::Hessian => Rows {
                forward: match self.function.inverse_dynamics {
                    Some(_) if self.sweeps_by_accelerations(derivative) => forward + tree.n_speeds,
                    _ => forward,
                },
                reverse: forward,
            },
        }
    }

    /// How many numbers its values have at most.
    fn n_values_at_most(&self, tree: &Tree) -> usize {
        self.values().n_numbers(tree)
    }

    /// How many numbers its values have.
    pub fn n_values(&self, tree: &Tree) -> usize {
        let values = self.values();
        let own = |dimension| values.own_length(dimension, tree, 0);
        let outputs = values.outputs().into_owned().into_iter();
        let size = |output: Output| output.shape.lengths(tree, own).iter().product::<usize>();
        outputs.map(size).sum()
    }

    /// How many numbers it writes at most: what takes a while to find is bounded.
    pub(in crate::functions) fn n_numbers(&self, tree: &Tree) -> usize {
        let of_output = |output: &Output| {
            let length = |dimension: &Dimension| match dimension {
                Dimension::Packed(Packed::MassMatrix) => terms::pairs(tree),
                // Not more than there are without combining them, which takes a while.
                Dimension::BaseParameters => N_INERTIAL * tree.bodies.len(),
                Dimension::Packed(Packed::Inverse) if !tree.has_followers() => {
                    terms::pairs_of_trees(tree)
                }
                // Not more than there are without finding out which are zero.
                Dimension::Entries if self.is_second_derivative() => {
                    let n = self.n_variables(tree);
                    n * (n + 1) / 2
                }
                Dimension::Entries => self.n_values_at_most(tree) * self.n_variables(tree),
                // Elimination couples more only where joints follow others.
                Dimension::Packed(Packed::Factors) if !tree.has_followers() => terms::pairs(tree),
                Dimension::Packed(Packed::Regressor) if !tree.has_followers() => {
                    N_INERTIAL * terms::of_vector(tree)
                }
                dimension => dimension
                    .length(tree)
                    .unwrap_or_else(|| self.own_length(*dimension, tree, terms::of_vector(tree))),
            };
            output
                .shape
                .all()
                .map(|dimension| length(&dimension))
                .product::<usize>()
        };
        self.outputs().iter().map(of_output).sum()
    }

    /// The length of a dimension that is its own; `n_columns` is the number of a compact output's columns.
    pub fn own_length(&self, dimension: Dimension, tree: &Tree, n_columns: usize) -> usize {
        if dimension == Dimension::Entries {
            let sparsity = self.sparsity(tree);
            return sparsity.map_or(0, |sparsity| sparsity.places.len());
        }
        let subject = self.subject.as_ref();
        let of_subject = subject.and_then(|subject| subject.length(dimension));
        of_subject.unwrap_or(n_columns)
    }

    /// The same, as generated code names it.
    pub(in crate::functions) fn own_declared(&self, dimension: Dimension) -> Length {
        let subject = self.subject.as_ref();
        let of_subject = subject.and_then(|subject| subject.length(dimension));
        match (dimension, of_subject) {
            (Dimension::Entries, _) => Length::Constant(self.len_constant()),
            (Dimension::FrameSpeeds, Some(_)) => Length::Constant(self.speeds_len_constant()),
            (_, Some(length)) => Length::Number(length),
            (_, None) => Length::Constant(self.function.compact_columns_constant()),
        }
    }
}
