//! Second derivatives of accelerations, without a sweep through the solver.
//!
//! Let `f(x, u_dot) = 0` be the forces that are lacking, with `df/du_dot = -M`, and `L` their sum weighted by `M^-1 multiplier`, which is kept.
//! Then the second derivatives of the sum of the accelerations, weighted by the multiplier, are `L_xx + L_xa Y + (L_xa Y)^T`, where `a` are the
//! accelerations and `Y` how these change with `x`: forces are linear in accelerations, so that `L_aa` is zero.

use std::collections::BTreeMap;

use super::{
    derivative::{Derivative, DerivativeKind, entries, gradient, sweep, symmetric},
    solved::{Solution, lacking},
};
use crate::{
    expr::{Expr, ExprGraph, Input},
    functions::{
        argument::Argument,
        derived::Derived,
        formulation::Formulation,
        function::{InverseDynamicsFn, Jacobians},
        part::{Direct, Part},
        told::Told,
        variable::Variable,
    },
    given::Accelerations,
    recursive::{Plan, Technique, accelerations::inverse_mass, derivatives},
    solve,
    tree::Tree,
};

/// Accelerations, how they change, and what weighs the forces that are lacking.
struct First {
    u_dot: Vec<Expr>,
    /// What was found of other parts.
    told: Told,
    /// `Y`: a row for each acceleration, a column for each entry of the variables.
    rows: Vec<Vec<Expr>>,
    /// `M^-1 multiplier`.
    weights: Vec<Expr>,
}

/// Second derivatives before accelerations and weights are known.
struct Second {
    /// Those of `L` by the variables, at the places that are written.
    own: Vec<Expr>,
    /// `L_xa`: a row for each entry of the variables, a column for each acceleration.
    mixed: Vec<Vec<Expr>>,
}

impl Part {
    /// True where `L_xa` is swept for beside `L_xx`: the mass matrix depends on parameters too, and without speeds both sweeps share
    /// most of their work.
    pub(in crate::functions) fn sweeps_by_accelerations(&self, derivative: &Derivative) -> bool {
        let is_given = |variable: &Variable| matches!(variable, Variable::Given(_));
        let has_speeds = self.function.arguments.contains(&Argument::U);
        !(has_speeds && derivative.by.iter().all(is_given))
    }

    /// Derives these second derivatives of accelerations that need such forces. Returns what it found of other parts.
    pub(in crate::functions) fn derive_second(
        &self,
        derived: &mut Derived,
        tree: &Tree,
        (formulation, plan): (Formulation, &Plan),
        inverse_dynamics: InverseDynamicsFn,
    ) -> Told {
        let derivative = self.differentiated();
        let sparsity = self.sparsity(tree);
        let places = sparsity.as_ref().map_or(&[][..], |own| &own.places);
        let multipliers = derivative.arguments(self.function.outputs, 0);
        let inputs = multipliers.iter().flat_map(|own| own.inputs(tree));
        let inputs: Vec<Input> = inputs.collect();
        let first = self.first(derived, tree, (formulation, plan), &derivative.by, &inputs);
        // No sweep goes through calls.
        let plan = &plan.with(Technique::Lockstep, false);
        let graph = &mut derived.graph;
        let solution = Solution {
            u_dot: &first.u_dot,
            inverse_dynamics,
        };
        let (lacking, mut values) = lacking(graph, tree, plan, &solution);
        let weighted = (&multipliers[..], &lacking[..]);
        let is_swept = self.sweeps_by_accelerations(derivative);
        let accelerations = Argument::UDot.inputs(tree).filter(|_| is_swept).collect();
        let second = derivative.second(graph, tree, weighted, plan, (places, accelerations));
        values.extend(inputs.into_iter().zip(first.weights.iter().copied()));
        let mut second = second.substituted(graph, &values);
        if !is_swept {
            second.mixed = derivative.mixed(graph, tree, plan, &first.weights);
        }
        graph.enter(None);
        let changes = second.with_accelerations(graph, &first.rows, places);
        derived.roots.extend(changes);
        first.told
    }

    /// First derivatives, and what they leave.
    fn first(
        &self,
        derived: &mut Derived,
        tree: &Tree,
        (formulation, plan): (Formulation, &Plan),
        by: &[Variable],
        multipliers: &[Input],
    ) -> First {
        let part = Self {
            derivative: Some(Derivative::new(DerivativeKind::Jacobian, by.to_vec())),
            ..self.clone()
        };
        let begin = derived.roots.len();
        let told =
            if let Some(Direct::Matrices(jacobians)) = part.direct_by(tree, formulation, plan) {
                Some(part.derive_matrices(derived, tree, (formulation, plan), jacobians))
            } else {
                part.derive_in(derived, tree, formulation, plan);
                None
            };
        let entries = derived.roots.split_off(begin);
        let mut rest = &entries[..];
        let mut rows = vec![Vec::new(); tree.n_speeds];
        for variable in by {
            for row in &mut rows {
                let (own, others) = rest.split_at(variable.n_entries(tree));
                row.extend_from_slice(own);
                rest = others;
            }
        }
        let graph = &mut derived.graph;
        let weights: Vec<Expr> = multipliers.iter().map(|own| graph.input(*own)).collect();
        let one_by_one = &plan.with(Technique::Lockstep, false);
        let tau = Variable::Given(Argument::Tau);
        let inverse = told.as_ref().and_then(|told| told.by(&tau));
        let weights = match inverse {
            Some(inverse) => solve::product(graph, inverse, &weights),
            None => inverse_mass::solution(graph, tree, one_by_one, weights),
        };
        let u_dot = told.as_ref().and_then(|told| told.values.clone());
        let u_dot = u_dot.unwrap_or_else(|| {
            self.derive_values(derived, tree, formulation, one_by_one);
            derived.roots.split_off(begin)
        });
        let found = Jacobians {
            values: Some(u_dot.clone()),
            ..told.unwrap_or_default()
        };
        First {
            told: found.into_told(self.values().name(), self.function.derivatives_tell),
            u_dot,
            rows,
            weights,
        }
    }
}

impl Derivative {
    /// `L_xa` at these weights: by coordinates the derivatives of the mass matrix times the weights, by others zero.
    fn mixed(
        &self,
        graph: &mut ExprGraph,
        tree: &Tree,
        plan: &Plan,
        weights: &[Expr],
    ) -> Vec<Vec<Expr>> {
        let by_q = Variable::Given(Argument::Q);
        let columns = self.by.contains(&by_q).then(|| {
            let accelerations = Accelerations::Values(weights);
            let found = derivatives::of_mass_matrix_product(graph, tree, plan, accelerations);
            solve::transposed(&found.by_q)
        });
        let zero = vec![graph.zero(); tree.n_speeds];
        let mut rows = Vec::new();
        for variable in &self.by {
            if let Some(columns) = columns.as_ref().filter(|_| *variable == by_q) {
                let columns = columns.iter().map(|own| own.iter().map(|entry| -*entry));
                rows.extend(columns.map(Iterator::collect));
            } else {
                rows.resize(rows.len() + variable.n_entries(tree), zero.clone());
            }
        }
        rows
    }

    /// Second derivatives of the weighted sum of forces, by the variables and these accelerations, which are inputs.
    fn second(
        &self,
        graph: &mut ExprGraph,
        tree: &Tree,
        weighted: (&[Argument], &[Expr]),
        plan: &Plan,
        (places, accelerations): (&[[usize; 2]], Vec<Input>),
    ) -> Second {
        graph.enter(None);
        let (mut seeds, columns) = self.seeds(graph, tree);
        let n_columns = columns.last().map_or(0, |last| last.end);
        let gradient = gradient(graph, tree, weighted, &seeds, n_columns);
        let one = graph.one();
        let all = n_columns..n_columns + accelerations.len();
        let accelerations = accelerations.into_iter().zip(all.clone());
        seeds.extend(accelerations.map(|(input, column)| (input, vec![(column, one)])));
        let rows = sweep(plan).rows(graph, &gradient, &seeds);
        let mixed = rows.iter().map(|row| entries(graph, row, all.clone()));
        Second {
            mixed: mixed.collect(),
            own: symmetric(graph, &rows, &self.mixing(tree, &columns), places),
        }
    }
}

impl Second {
    fn substituted(self, graph: &mut ExprGraph, values: &BTreeMap<Input, Expr>) -> Self {
        let lengths: Vec<usize> = self.mixed.iter().map(Vec::len).collect();
        let all = [self.own, self.mixed.concat()].concat();
        let n_own = all.len() - lengths.iter().sum::<usize>();
        let all = graph.substituted(&all, values);
        let (own, mut rest) = all.split_at(n_own);
        let mixed = lengths.into_iter().map(|length| {
            let (row, others) = rest.split_at(length);
            rest = others;
            row.to_vec()
        });
        Self {
            mixed: mixed.collect(),
            own: own.to_vec(),
        }
    }

    /// With what they have by the accelerations, which change with the variables by these rows.
    fn with_accelerations(
        self,
        graph: &mut ExprGraph,
        rows: &[Vec<Expr>],
        places: &[[usize; 2]],
    ) -> Vec<Expr> {
        let mut carried = |row: usize, column: usize| {
            let terms = self.mixed[row].iter().zip(rows);
            terms.fold(graph.zero(), |sum, (&entry, changes)| {
                let term = graph.mul(entry, changes[column]);
                graph.add(sum, term)
            })
        };
        let pairs: Vec<[Expr; 2]> = places
            .iter()
            .map(|&[row, column]| [carried(row, column), carried(column, row)])
            .collect();
        let all = self.own.into_iter().zip(pairs);
        all.map(|(own, pair)| {
            let both = graph.add(pair[0], pair[1]);
            graph.add(own, both)
        })
        .collect()
    }
}
