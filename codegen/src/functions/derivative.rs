//! A derivative of a function of the catalogue: its outputs, and how it follows from the function's own.

use super::{
    argument::Argument,
    derived::Derived,
    function::{Jacobians, Output},
    shape::Shape,
    variable::Variable,
};
use crate::{
    differentiate::{Row, Seeds, forward, reverse},
    expr::{Expr, ExprGraph},
    recursive::Plan,
    tree::Tree,
};

/// What is asked for of a function's derivatives.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum DerivativeKind {
    /// All of them: of each output an entry is a row, each variable's entries are columns.
    Whole,
    /// Their product with a direction: how outputs change along it.
    Forward,
    /// The product of a multiplier with them: how the sum of the output's entries, so weighted, changes with each entry of the variables.
    Reverse,
}

/// A derivative of a function.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Derivative {
    /// What of it.
    pub kind: DerivativeKind,
    /// The variables, in the order asked for.
    pub by: Vec<Variable>,
}

impl Derivative {
    /// The names of the variables with something between them.
    pub(super) fn joined(&self, between: &str) -> String {
        let names: Vec<&str> = self.by.iter().map(Variable::name).collect();
        names.join(between)
    }

    /// As it is asked for, of a function and by these variables.
    pub(super) fn text(kind: DerivativeKind, of: &str, by: &str) -> String {
        match kind {
            DerivativeKind::Whole => format!("d({of})/d({by})"),
            DerivativeKind::Forward => format!("jvp({of}; {by})"),
            DerivativeKind::Reverse => format!("vjp({of}; {by})"),
        }
    }

    /// Its name in generated code, by that of the function.
    pub(super) fn name(&self, of: &str) -> String {
        let by = self.joined("_");
        match self.kind {
            DerivativeKind::Whole => format!("d_{of}_d_{by}"),
            DerivativeKind::Forward => format!("jvp_{of}_{by}"),
            DerivativeKind::Reverse => format!("vjp_{of}_{by}"),
        }
    }

    /// What it is given beside the function's own arguments.
    pub(super) fn arguments(&self, of: &[Output]) -> Vec<Argument> {
        match self.kind {
            DerivativeKind::Whole => Vec::new(),
            DerivativeKind::Forward => self.by.iter().filter_map(Variable::direction).collect(),
            DerivativeKind::Reverse => of
                .iter()
                .filter_map(|output| Argument::multiplier(output.shape))
                .collect(),
        }
    }

    /// What it writes: for each output as many as there are variables, or one for each output, or for each variable.
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
        let along = |output: &Output| Output {
            name: format!("d{}", output.name).into(),
            shape: output.shape,
        };
        let gradient = |variable: &Variable| Output {
            name: format!("{}_gradient", variable.name()).into(),
            shape: Shape::of(variable.axes()),
        };
        match self.kind {
            DerivativeKind::Whole => of.iter().flat_map(by_all).collect(),
            DerivativeKind::Forward => of.iter().map(along).collect(),
            DerivativeKind::Reverse => self.by.iter().map(gradient).collect(),
        }
    }

    /// Lines of documentation; `of` is the text of the function.
    pub(super) fn doc(&self, of: &str, outputs: &[Output]) -> Vec<String> {
        let first = match self.kind {
            DerivativeKind::Whole => format!(
                "The derivatives of `{of}`: rows are the entries of its outputs, columns those of the variables."
            ),
            DerivativeKind::Forward => format!(
                "How the outputs of `{of}` change along a direction: its derivatives times the change of each variable."
            ),
            DerivativeKind::Reverse => format!(
                "The multiplier times the derivatives of `{of}`: the gradient of the sum of its output's entries, each times its multiplier."
            ),
        };
        let mut lines = vec![first];
        let of_variables = outputs.iter().zip(self.by.iter().cycle());
        let of_variables = of_variables
            .map(|(output, variable)| format!("- `{}`: by {}.", output.name, variable.meaning()));
        let directions = self
            .by
            .iter()
            .map(|variable| format!("- By {}.", variable.meaning()));
        match self.kind {
            DerivativeKind::Forward => lines.extend(directions),
            DerivativeKind::Whole | DerivativeKind::Reverse => lines.extend(of_variables),
        }
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

    /// Puts the derivatives in the place of the values that were derived last, the entries of outputs with `sizes`, of which
    /// the only one has this multiplier where it has any.
    pub(super) fn apply(
        &self,
        derived: &mut Derived,
        tree: &Tree,
        (first, sizes): (usize, &[usize]),
        (is_reverse, multiplier): (bool, Option<Argument>),
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
        match self.kind {
            DerivativeKind::Whole => {
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
            DerivativeKind::Forward => {
                let seeds = self.along(graph, tree, seeds);
                for row in sweep(graph, &values, &seeds) {
                    derived.extend_by(&row, 0..1);
                }
            }
            DerivativeKind::Reverse => {
                let weighted = weighted(graph, tree, multiplier, &values);
                let rows = sweep(graph, &[weighted], &seeds);
                derived.extend_by(&rows[0], 0..n_columns);
            }
        }
    }

    /// How inputs change along the direction.
    fn along(&self, graph: &mut ExprGraph, tree: &Tree, seeds: Seeds) -> Seeds {
        let directions = self.by.iter().filter_map(Variable::direction);
        let directions = directions.flat_map(|direction| direction.inputs(tree));
        let directions: Vec<Expr> = directions.map(|input| graph.input(input)).collect();
        let along = seeds.into_iter().map(|(input, row)| {
            let mut sum = graph.zero();
            for (place, entry) in row {
                let change = graph.mul(entry, directions[place]);
                sum = graph.add(sum, change);
            }
            (input, vec![(0, sum)])
        });
        along.collect()
    }
}

/// The sum of values, each times its multiplier.
fn weighted(
    graph: &mut ExprGraph,
    tree: &Tree,
    multiplier: Option<Argument>,
    values: &[Expr],
) -> Expr {
    let inputs = multiplier.into_iter().flat_map(|own| own.inputs(tree));
    let mut sum = graph.zero();
    for (input, &value) in inputs.zip(values) {
        let own = graph.input(input);
        let term = graph.mul(own, value);
        sum = graph.add(sum, term);
    }
    sum
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
