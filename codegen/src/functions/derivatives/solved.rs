//! Derivatives of accelerations and products with them, without a sweep through the solver.
//!
//! Let `f(x, u_dot) = 0` be the forces that are lacking, with `df/du_dot = -M`. Then `d(u_dot) = M^-1 df`: along a direction that is
//! one more solution, and the gradient for a multiplier is that of `(M^-1 multiplier) · f` with the first factor kept. Whole derivatives are one solution for each column of `df`.

use std::collections::BTreeMap;

use super::derivative::{Asked, Derivative, DerivativeKind, entry, gradient};
use crate::{
    differentiate::forward,
    expr::{Expr, ExprGraph, Input},
    functions::{
        argument::Argument, derived::Derived, formulation::Way, function::InverseDynamicsFn, roots,
    },
    recursive::{Plan, accelerations::inverse_mass},
    solve::{self, SpeedMatrix},
    tree::Tree,
};

/// Accelerations that were solved for.
pub(in crate::functions) struct Solution<'a> {
    pub(in crate::functions) u_dot: &'a [Expr],
    /// The forces that they need.
    pub(in crate::functions) inverse_dynamics: InverseDynamicsFn,
}

impl Derivative {
    /// Adds the derivatives of these accelerations, or the product, to what is derived.
    pub(in crate::functions) fn apply_to_solution(
        &self,
        derived: &mut Derived,
        tree: &Tree,
        plan: &Plan,
        solution: &Solution<'_>,
        Asked {
            multipliers,
            sparsity,
        }: Asked<'_>,
    ) {
        let graph = &mut derived.graph;
        if matches!(
            self.kind,
            DerivativeKind::Jacobian | DerivativeKind::PackedJacobian
        ) {
            let columns = self.columns(graph, tree, plan, solution);
            let inverse = is_worth_an_inverse(tree, &columns);
            let inverse = inverse.then(|| inverse_mass::inverse(graph, tree, plan));
            let solved = solved(graph, tree, plan, inverse.as_ref(), columns);
            return derived.put(&[tree.n_speeds], &self.of_columns(tree, &solved), sparsity);
        }
        let (lacking, mut values) = lacking(graph, tree, plan, solution);
        let (seeds, columns) = self.seeds(graph, tree);
        if self.kind == DerivativeKind::Jvp {
            let seeds = self.along(graph, tree, seeds);
            let rows = forward(graph, &lacking, &seeds);
            let changes: Vec<Expr> = rows.iter().map(|row| entry(graph, row, 0)).collect();
            let changes = graph.substituted(&changes, &values);
            let solved = inverse_mass::solution(graph, tree, plan, changes);
            derived.roots.extend(solved);
            return;
        }
        let n_columns = columns.last().map_or(0, |last| last.end);
        let weighted = (multipliers, &lacking[..]);
        let gradient = gradient(graph, tree, weighted, &seeds, n_columns);
        // The solution takes the place of the multiplier after the sweep, so that it does not vary.
        let inputs: Vec<Input> = multipliers
            .iter()
            .flat_map(|own| own.inputs(tree))
            .collect();
        let weights = inputs.iter().map(|input| graph.input(*input)).collect();
        let solved = inverse_mass::solution(graph, tree, plan, weights);
        values.extend(inputs.into_iter().zip(solved));
        let gradient = graph.substituted(&gradient, &values);
        derived.roots.extend(gradient);
    }

    /// How the forces that are lacking change with each entry of the variables, at these accelerations: `df`, column by column.
    pub(in crate::functions) fn columns(
        &self,
        graph: &mut ExprGraph,
        tree: &Tree,
        plan: &Plan,
        solution: &Solution<'_>,
    ) -> Vec<Vec<Expr>> {
        let (lacking, values) = lacking(graph, tree, plan, solution);
        let (seeds, columns) = self.seeds(graph, tree);
        let rows = forward(graph, &lacking, &seeds);
        let n_columns = columns.last().map_or(0, |last| last.end);
        let columns = (0..n_columns).map(|column| {
            let changes: Vec<Expr> = rows.iter().map(|row| entry(graph, row, column)).collect();
            graph.substituted(&changes, &values)
        });
        columns.collect()
    }
}

/// The forces that are lacking, of accelerations that are inputs until a sweep is over; and what these are.
pub(super) fn lacking(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    solution: &Solution<'_>,
) -> (Vec<Expr>, BTreeMap<Input, Expr>) {
    graph.enter(None);
    let mut lacking = roots::dynamics::applied(graph, tree);
    let needed = (solution.inverse_dynamics)(graph, tree, Way::Recursive(plan));
    solve::subtract(graph, tree, &mut lacking, &needed);
    let accelerations = Argument::UDot.inputs(tree);
    let values = accelerations.zip(solution.u_dot.iter().copied()).collect();
    graph.enter(None);
    (lacking, values)
}

/// True for as many columns as the inverse has, or more: it takes no more operations than their solutions.
pub(in crate::functions) fn is_worth_an_inverse(tree: &Tree, columns: &[Vec<Expr>]) -> bool {
    columns.len() >= tree.n_speeds
}

/// `M^-1` times each of these columns: by the inverse where it is given, else a solution for each.
pub(in crate::functions) fn solved(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    inverse: Option<&SpeedMatrix>,
    columns: Vec<Vec<Expr>>,
) -> Vec<Vec<Expr>> {
    let columns = columns.into_iter().map(|own| match inverse {
        Some(inverse) => solve::product(graph, inverse, &own),
        None => inverse_mass::solution(graph, tree, plan, own),
    });
    columns.collect()
}
