//! Derivatives of what is solved for and products with them, without a sweep through the solver.
//!
//! Let `f(x, u_dot) = tau - needed` be the forces that are lacking, which are zero, with `df/du_dot = -M`. Then `d(u_dot) = M^-1 df`: along a
//! direction that is one more solution, and the gradient for a multiplier is that of `(M^-1 multiplier) · f` with the first factor kept. Whole
//! derivatives are one solution for each column of `df`. Where accelerations of some speeds are given and their forces found, `M_ff` of the free
//! speeds takes the place of `M`, and `d(tau_p) = M_pf d(u_dot_f) - df_p`.

use std::collections::{BTreeMap, BTreeSet};

use super::{
    derivative::{Asked, Derivative, DerivativeKind, Seeded, entry, gradient},
    sparsity::Sparsity,
};
use crate::{
    differentiate::forward,
    expr::{Expr, ExprGraph, Input},
    functions::{
        argument::Argument, derived::Derived, formulation::Way, function::InverseDynamicsFn, roots,
    },
    id::SpeedId,
    recursive::{Plan, accelerations::inverse_mass},
    solve::{self, SpeedMatrix},
    tree::Tree,
};

/// Accelerations that were solved for, and forces where accelerations are given.
pub(in crate::functions) struct Solution<'a> {
    /// The outputs: accelerations, then forces if some are found.
    pub(in crate::functions) values: &'a [Expr],
    /// The forces that accelerations need.
    pub(in crate::functions) inverse_dynamics: InverseDynamicsFn,
    /// The speeds with given accelerations, where forces are found.
    pub(in crate::functions) prescribed: Option<&'a BTreeSet<SpeedId>>,
}

/// What stands for the outputs while derivatives are swept for, with an entry for each entry of these: the forces that are lacking for an acceleration
/// that is found, the same with the other sign for a force, and what is given for what is copied.
pub(in crate::functions) struct Balance {
    pub(in crate::functions) entries: Vec<Expr>,
    /// Accelerations that are inputs until a sweep is over, and what they are.
    pub(in crate::functions) found: BTreeMap<Input, Expr>,
}

impl Derivative {
    /// Adds the derivatives of this solution, or the product, to what is derived.
    pub(in crate::functions) fn apply_to_solution(
        &self,
        derived: &mut Derived,
        tree: &Tree,
        plan: &Plan,
        solution: &Solution<'_>,
        asked: Asked<'_>,
    ) {
        match self.kind {
            DerivativeKind::Jacobian | DerivativeKind::PackedJacobian => {
                self.put_solved(derived, tree, plan, solution, asked.sparsity);
            }
            DerivativeKind::Jvp => {
                let product = self.solved_along(&mut derived.graph, tree, plan, solution);
                derived.roots.extend(product);
            }
            DerivativeKind::Vjp | DerivativeKind::Hessian => {
                let (graph, multipliers) = (&mut derived.graph, asked.multipliers);
                let gradient = self.solved_gradient(graph, tree, plan, solution, multipliers);
                derived.roots.extend(gradient);
            }
        }
    }

    /// Whole derivatives, or those of their entries that are other than zero.
    fn put_solved(
        &self,
        derived: &mut Derived,
        tree: &Tree,
        plan: &Plan,
        solution: &Solution<'_>,
        sparsity: Option<&Sparsity>,
    ) {
        let graph = &mut derived.graph;
        let columns = self.columns(graph, tree, plan, solution);
        let inverse = solution.prescribed.is_none() && is_worth_an_inverse(tree, &columns);
        let inverse = inverse.then(|| inverse_mass::inverse(graph, tree, plan));
        let solved = solution.solved(graph, tree, plan, inverse.as_ref(), columns);
        let matrices = self.of_columns(tree, &solved, solution.values.len());
        derived.put(&solution.sizes(tree), &matrices, sparsity);
    }

    /// The product with a direction.
    fn solved_along(
        &self,
        graph: &mut ExprGraph,
        tree: &Tree,
        plan: &Plan,
        solution: &Solution<'_>,
    ) -> Vec<Expr> {
        let Balance { entries, found } = solution.balance(graph, tree, plan);
        let (seeds, _) = solution.seeds(self, graph, tree);
        let seeds = self.along(graph, tree, seeds);
        let rows = forward(graph, &entries, &seeds);
        let changes: Vec<Expr> = rows.iter().map(|row| entry(graph, row, 0)).collect();
        let changes = graph.substituted(&changes, &found);
        let solved = solution.solved(graph, tree, plan, None, vec![changes]);
        solved.concat()
    }

    /// The gradient for multipliers of the outputs.
    fn solved_gradient(
        &self,
        graph: &mut ExprGraph,
        tree: &Tree,
        plan: &Plan,
        solution: &Solution<'_>,
        multipliers: &[Argument],
    ) -> Vec<Expr> {
        let Balance { entries, found } = solution.balance(graph, tree, plan);
        let (seeds, columns) = solution.seeds(self, graph, tree);
        let n_columns = columns.last().map_or(0, |last| last.end);
        let weighted = (multipliers, &entries[..]);
        let gradient = gradient(graph, tree, weighted, &seeds, n_columns);
        // The solution takes the place of the multiplier after the sweep, so that it does not vary.
        let weights = solution.weights(graph, tree, plan, None, multipliers);
        let in_place = solution.in_place(tree, multipliers, &weights);
        let values = in_place.into_iter().chain(found).collect();
        graph.substituted(&gradient, &values)
    }

    /// How the balance changes with each entry of the variables, column by column.
    pub(in crate::functions) fn columns(
        &self,
        graph: &mut ExprGraph,
        tree: &Tree,
        plan: &Plan,
        solution: &Solution<'_>,
    ) -> Vec<Vec<Expr>> {
        let Balance { entries, found } = solution.balance(graph, tree, plan);
        let (seeds, columns) = solution.seeds(self, graph, tree);
        let rows = forward(graph, &entries, &seeds);
        let n_columns = columns.last().map_or(0, |last| last.end);
        let columns = (0..n_columns).map(|column| {
            let changes: Vec<Expr> = rows.iter().map(|row| entry(graph, row, column)).collect();
            graph.substituted(&changes, &found)
        });
        columns.collect()
    }
}

impl Solution<'_> {
    /// The lengths of the outputs.
    fn sizes(&self, tree: &Tree) -> Vec<usize> {
        vec![tree.n_speeds; 1 + usize::from(self.prescribed.is_some())]
    }

    /// True where the acceleration is found, not given.
    pub(in crate::functions) fn is_free(&self, speed: SpeedId) -> bool {
        self.prescribed.is_none_or(|own| !own.contains(&speed))
    }

    /// The speeds whose accelerations are found.
    pub(in crate::functions) fn free(&self, tree: &Tree) -> impl Iterator<Item = SpeedId> {
        let speeds = (0..tree.n_speeds).map(SpeedId::new);
        speeds.filter(|speed| self.is_free(*speed))
    }

    /// What is lacking and what is copied, with accelerations that are found for inputs.
    pub(in crate::functions) fn balance(
        &self,
        graph: &mut ExprGraph,
        tree: &Tree,
        plan: &Plan,
    ) -> Balance {
        graph.enter(None);
        let mut entries = roots::dynamics::applied(graph, tree);
        let needed = (self.inverse_dynamics)(graph, tree, Way::Recursive(plan));
        solve::subtract(graph, tree, &mut entries, &needed);
        graph.enter(None);
        if let Some(prescribed) = self.prescribed {
            let mut forces = roots::dynamics::applied(graph, tree);
            for &speed in prescribed {
                let given = graph.input(Input::UDot(speed));
                let lacking = std::mem::replace(&mut entries[speed.index()], given);
                forces[speed.index()] = -lacking;
            }
            entries.extend(forces);
        }
        let free = self.free(tree);
        let found = free.map(|speed| (Input::UDot(speed), self.values[speed.index()]));
        Balance {
            entries,
            found: found.collect(),
        }
    }

    /// How inputs change with the entries of the variables, and the columns of each: what is found is not given.
    pub(in crate::functions) fn seeds(
        &self,
        derivative: &Derivative,
        graph: &mut ExprGraph,
        tree: &Tree,
    ) -> Seeded {
        let (mut seeds, columns) = derivative.seeds(graph, tree);
        seeds.retain(|input, _| match input {
            Input::UDot(speed) => !self.is_free(*speed),
            Input::Tau(speed) => self.is_free(*speed),
            _ => true,
        });
        (seeds, columns)
    }

    /// How the outputs change where the balance changes so: by what the forces make where that is given, else a solution for each.
    pub(in crate::functions) fn solved(
        &self,
        graph: &mut ExprGraph,
        tree: &Tree,
        plan: &Plan,
        by_forces: Option<&SpeedMatrix>,
        columns: Vec<Vec<Expr>>,
    ) -> Vec<Vec<Expr>> {
        let none = BTreeSet::new();
        let prescribed = self.prescribed.unwrap_or(&none);
        let still = vec![graph.zero(); tree.n_speeds];
        let columns = columns.into_iter().map(|mut column| {
            let forces = column.split_off(tree.n_speeds);
            let mut lacking = column.clone();
            for speed in prescribed {
                lacking[speed.index()] = graph.zero();
            }
            let mut made = if let Some(by_forces) = by_forces {
                solve::product(graph, by_forces, &lacking)
            } else {
                let of = (lacking, &still[..]);
                let found = inverse_mass::partition(graph, tree, plan, of, prescribed);
                [found.accelerations, found.forces].concat()
            };
            made.truncate(self.values.len());
            for speed in prescribed {
                made[speed.index()] = column[speed.index()];
            }
            let bodies = tree.speed_bodies();
            for (place, force) in forces.into_iter().enumerate() {
                let made = &mut made[tree.n_speeds + place];
                graph.enter(bodies[place]);
                *made = if self.is_free(SpeedId::new(place)) {
                    force
                } else {
                    graph.add(*made, force)
                };
            }
            made
        });
        columns.collect()
    }

    /// What weighs the forces that are lacking: `M_ff^-1 (a + M_fp t)` of the free speeds, `-t` of the others, where `a` and `t` are the multipliers of
    /// accelerations and forces. `by_forces` is what the forces make, where that is known.
    pub(in crate::functions) fn weights(
        &self,
        graph: &mut ExprGraph,
        tree: &Tree,
        plan: &Plan,
        by_forces: Option<&SpeedMatrix>,
        multipliers: &[Argument],
    ) -> Vec<Expr> {
        let inputs = multipliers.iter().flat_map(|own| own.inputs(tree));
        let mut all: Vec<Expr> = inputs.map(|own| graph.input(own)).collect();
        let none = BTreeSet::new();
        let prescribed = self.prescribed.unwrap_or(&none);
        let mut of_forces = all.split_off(tree.n_speeds);
        let mut given = vec![graph.zero(); tree.n_speeds];
        for (place, force) in of_forces.iter_mut().enumerate() {
            if self.is_free(SpeedId::new(place)) {
                *force = graph.zero();
            } else {
                (all[place], given[place]) = (graph.zero(), -*force);
            }
        }
        let mut weights = if let Some(by_forces) = by_forces {
            let of_outputs = [all, of_forces].concat();
            solve::product(graph, &solve::transposed(by_forces), &of_outputs)
        } else {
            let all = (all, &given[..]);
            inverse_mass::partition(graph, tree, plan, all, prescribed).accelerations
        };
        for speed in prescribed {
            weights[speed.index()] = given[speed.index()];
        }
        weights
    }

    /// The weights by the multipliers whose place they take where the balance is weighed instead of the outputs.
    pub(in crate::functions) fn in_place(
        &self,
        tree: &Tree,
        multipliers: &[Argument],
        weights: &[Expr],
    ) -> Vec<(Input, Expr)> {
        let inputs = multipliers.iter().flat_map(|own| own.inputs(tree));
        let inputs: Vec<Input> = inputs.collect();
        let free = self.free(tree).map(SpeedId::index);
        free.map(|place| (inputs[place], weights[place])).collect()
    }
}

/// True for as many columns as the inverse has, or more: it takes no more operations than their solutions.
pub(in crate::functions) fn is_worth_an_inverse(tree: &Tree, columns: &[Vec<Expr>]) -> bool {
    columns.len() >= tree.n_speeds
}
