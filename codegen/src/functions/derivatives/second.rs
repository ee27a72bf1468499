//! Second derivatives of what is solved for, without a sweep through the solver.
//!
//! Let `f(x, u_dot) = 0` be the forces that are lacking, with `df/du_dot = -M`, and `L` their sum weighted by `M^-1 multiplier`, which is kept.
//! Then the second derivatives of the sum of the accelerations, weighted by the multiplier, are `L_xx + L_xa Y + (L_xa Y)^T`, where `a` are the
//! accelerations and `Y` how these change with `x`: forces are linear in accelerations, so that `L_aa` is zero. Where accelerations of some speeds are given and
//! their forces found, `a` are those of the others, and the weights also come from the multiplier of the forces.

use std::collections::BTreeMap;

use super::{
    derivative::{Derivative, DerivativeKind, Seeded, entries, gradient, sweep, symmetric},
    solved::Balance,
};
use crate::{
    expr::{Expr, ExprGraph, Input},
    functions::{
        argument::Argument,
        derived::Derived,
        formulation::Formulation,
        function::ByArguments,
        part::{Direct, Part},
        told::Told,
        variable::Variable,
    },
    given::Accelerations,
    id::SpeedId,
    recursive::{Plan, Technique, derivatives},
    solve,
    tree::Tree,
};

/// What was solved for, and how accelerations change.
struct First {
    values: Vec<Expr>,
    /// What was found beside.
    told: ByArguments,
    /// `Y`: a row for each acceleration, a column for each entry of the variables; zero where it is given.
    rows: Vec<Vec<Expr>>,
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
    ) -> Told {
        let derivative = self.differentiated();
        let sparsity = self.sparsity(tree);
        let places = sparsity.as_ref().map_or(&[][..], |own| &own.places);
        let multipliers = derivative.arguments(self.function.outputs, 0);
        let First { values, told, rows } =
            self.first(derived, tree, (formulation, plan), &derivative.by);
        // No sweep goes through calls.
        let plan = &plan.with(Technique::Lockstep, false);
        let graph = &mut derived.graph;
        let solution = self.solution(tree, &values);
        let solution = solution.expect("functions: what has second derivatives so is solved for");
        let by_forces = told.by(&Variable::Given(Argument::Tau));
        let weights = solution.weights(graph, tree, plan, by_forces, &multipliers);
        let Balance { entries, mut found } = solution.balance(graph, tree, plan);
        let is_swept = self.sweeps_by_accelerations(derivative);
        let free = solution.free(tree).filter(|_| is_swept).collect();
        let weighted = (&multipliers[..], &entries[..]);
        graph.enter(None);
        let seeds = solution.seeds(derivative, graph, tree);
        let second = derivative.second(graph, tree, (weighted, seeds), plan, (places, free));
        found.extend(solution.in_place(tree, &multipliers, &weights));
        let mut second = second.substituted(graph, &found);
        if !is_swept {
            second.mixed = derivative.mixed(graph, tree, plan, &weights);
        }
        graph.enter(None);
        let changes = second.with_accelerations(graph, &rows, places);
        derived.roots.extend(changes);
        let found = ByArguments {
            values: Some(values),
            ..told
        };
        found.into_told(self.values().name(), self.function.derivatives_tell)
    }

    /// First derivatives, and what they leave.
    fn first(
        &self,
        derived: &mut Derived,
        tree: &Tree,
        (formulation, plan): (Formulation, &Plan),
        by: &[Variable],
    ) -> First {
        let part = Self {
            derivative: Some(Derivative::new(DerivativeKind::Jacobian, by.to_vec())),
            ..self.clone()
        };
        let begin = derived.roots.len();
        let mut told = ByArguments::default();
        if let Some(Direct::Matrices(derivatives)) = part.direct_by(tree, formulation, plan) {
            told = part.derive_matrices(derived, tree, (formulation, plan), derivatives);
        } else {
            part.derive_in(derived, tree, formulation, plan);
        }
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
        let values = told.values.take().unwrap_or_else(|| {
            let one_by_one = &plan.with(Technique::Lockstep, false);
            self.derive_values(derived, tree, formulation, one_by_one);
            derived.roots.split_off(begin)
        });
        let prescribed = tree.prescribed.iter().filter(|_| self.function.prescribes);
        for speed in prescribed {
            rows[speed.index()].fill(derived.graph.zero());
        }
        First { values, told, rows }
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
        (weighted, (mut seeds, columns)): ((&[Argument], &[Expr]), Seeded),
        plan: &Plan,
        (places, free): (&[[usize; 2]], Vec<SpeedId>),
    ) -> Second {
        let n_columns = columns.last().map_or(0, |last| last.end);
        let gradient = gradient(graph, tree, weighted, &seeds, n_columns);
        let one = graph.one();
        let all = n_columns..n_columns + tree.n_speeds;
        for speed in free {
            seeds.insert(Input::UDot(speed), vec![(all.start + speed.index(), one)]);
        }
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
