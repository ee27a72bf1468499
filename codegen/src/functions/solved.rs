//! Products with derivatives of accelerations. With forces `f(x, u_dot) = 0` and `df/du_dot = M` is `d(u_dot) = -M^-1 df`, so no sweep
//! goes through the solution: along a direction it is one more solution, and the gradient is that of `-(M^-1 multiplier) · f`.

use std::collections::BTreeMap;

use super::{
    argument::Argument,
    derivative::{Derivative, DerivativeKind, entry},
    derive,
    derived::Derived,
    function::Needed,
};
use crate::{
    differentiate::{forward, reverse},
    expr::{Expr, Input},
    recursive::{Plan, inverse_mass},
    solve,
    tree::Tree,
};

/// Stands for a solution where it is not to vary; no product that is asked for has this number.
const SOLUTION: usize = usize::MAX;

impl Derivative {
    /// Puts the product in the place of the accelerations that were derived last, by what forces these need; `multipliers` are its own.
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
        let multipliers = multipliers.iter().flat_map(|own| own.inputs(tree));
        let multipliers: Vec<Expr> = multipliers.map(|input| graph.input(input)).collect();
        let solved = inverse_mass::solution(graph, tree, plan, multipliers);
        graph.enter(None);
        let mut weighted = graph.zero();
        for (place, (&force, solved)) in lacking.iter().zip(solved).enumerate() {
            let input = Input::Product(SOLUTION, place);
            values.insert(input, solved);
            let multiplier = graph.input(input);
            let term = graph.mul(multiplier, force);
            weighted = graph.add(weighted, term);
        }
        let rows = reverse(graph, &[weighted], &seeds);
        let columns = 0..columns.last().map_or(0, |last| last.end);
        let entries: Vec<Expr> = columns
            .map(|column| entry(graph, &rows[0], column))
            .collect();
        let entries = graph.substituted(&entries, &values);
        derived.roots.extend(entries);
    }
}
