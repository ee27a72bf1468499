//! Products with derivatives of accelerations, without a sweep through the solver.
//!
//! Let `f(x, u_dot) = 0` be the forces that are lacking, with `df/du_dot = -M`. Then `d(u_dot) = M^-1 df`: along a direction that is
//! one more solution, and the gradient for a multiplier is that of `(M^-1 multiplier) · f` with the first factor kept.

use std::collections::BTreeMap;

use super::{
    argument::Argument,
    derivative::{Derivative, DerivativeKind, entry, gradient},
    derive,
    derived::Derived,
    function::Needed,
};
use crate::{
    differentiate::forward,
    expr::{Expr, Input},
    recursive::{Plan, inverse_mass},
    solve,
    tree::Tree,
};

impl Derivative {
    /// Puts the product in the place of the accelerations that were derived last; `needed` gives the forces that accelerations need,
    /// and `multipliers` are the product's own.
    pub(super) fn apply_to_solution(
        &self,
        derived: &mut Derived,
        (tree, plan): (&Tree, &Plan),
        (first, needed): (usize, Needed),
        multipliers: &[Argument],
    ) {
        let u_dot = derived.roots.split_off(first);
        let graph = &mut derived.graph;
        graph.enter(None);
        // Accelerations are inputs until the sweep is over.
        let mut lacking = derive::applied(graph, tree);
        let needed = needed(graph, tree, plan);
        solve::subtract(graph, tree, &mut lacking, &needed);
        let accelerations = Argument::UDot.inputs(tree);
        let mut values: BTreeMap<Input, Expr> = accelerations.zip(u_dot).collect();
        graph.enter(None);
        let (seeds, columns) = self.seeds(graph, tree);
        if self.kind == DerivativeKind::Forward {
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
}
