//! A derivative of a function of the catalogue: its outputs, and how it follows from the function's own.

use std::{collections::BTreeSet, ops::Range, sync::Arc};

use super::sparsity::{LazySparsity, Sparsity, dependences};
use crate::{
    differentiate::{Row, Seeds, Sweep, reverse},
    expr::{Expr, ExprGraph},
    functions::{
        argument::Argument, derived::Derived, function::Output, multiplier::Multiplier,
        shape::Shape, unit::Unit, variable::Variable,
    },
    recursive::{Plan, Technique},
    tree::Tree,
};

/// The seeds of the numbers of which structural zeros are found: what is zero for one choice of rotations alone is none.
const DRAWN: [u64; 3] = [1, 2, 3];

/// What is asked for of a function's derivatives.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum DerivativeKind {
    /// All of them: of each output an entry is a row, each variable's entries are columns.
    Jacobian,
    /// Their product with a direction: how outputs change along it.
    Jvp,
    /// The product of a multiplier with them: how the sum of the outputs' entries, so weighted, changes with each entry of the variables.
    Vjp,
    /// As `Jacobian`, without the entries that the tree makes zero.
    PackedJacobian,
    /// The second derivative of the sum of the outputs' entries, weighted by a multiplier: one triangle, without what the tree makes zero.
    Hessian,
}

impl DerivativeKind {
    /// True for what leaves structural zeros out, and says in constants which entries it has.
    pub fn is_packed(self) -> bool {
        matches!(self, Self::PackedJacobian | Self::Hessian)
    }
}

/// What is wanted of derivatives.
#[derive(Clone, Copy)]
pub(in crate::functions) struct Asked<'a> {
    /// The arguments by which they are multiplied, where they are.
    pub(in crate::functions) multipliers: &'a [Argument],
    /// Which entries are not structurally zero, where others are left out.
    pub(in crate::functions) sparsity: Option<&'a Sparsity>,
}

/// How inputs change with the entries of all variables, and the columns of each variable.
pub(in crate::functions) type Seeded = (Seeds, Vec<Range<usize>>);

/// A derivative of a function.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Derivative {
    /// What of it.
    pub kind: DerivativeKind,
    /// The variables, in the order asked for.
    pub by: Vec<Variable>,
    /// Which of its entries are not structurally zero.
    sparsity: LazySparsity,
}

/// The way in which a plan sweeps for derivatives.
pub(in crate::functions) fn sweep(plan: &Plan) -> Sweep {
    if plan.uses(Technique::Reverse) {
        Sweep::Reverse
    } else {
        Sweep::Forward
    }
}

impl Derivative {
    pub(in crate::functions) fn new(kind: DerivativeKind, by: Vec<Variable>) -> Self {
        Self {
            kind,
            by,
            sparsity: LazySparsity::default(),
        }
    }

    /// The names of the variables with something between them.
    pub(in crate::functions) fn joined(&self, between: &str) -> String {
        let names: Vec<&str> = self.by.iter().map(Variable::name).collect();
        names.join(between)
    }

    /// As it is asked for, of a function and by these variables.
    pub(in crate::functions) fn text(kind: DerivativeKind, of: &str, by: &str) -> String {
        match kind {
            DerivativeKind::Jacobian => format!("d({of})/d({by})"),
            DerivativeKind::PackedJacobian => format!("packed(d({of})/d({by}))"),
            DerivativeKind::Jvp => format!("jvp({of}; {by})"),
            DerivativeKind::Vjp => format!("vjp({of}; {by})"),
            DerivativeKind::Hessian => format!("hessian({of}; {by})"),
        }
    }

    /// Its name in generated code, by that of the function.
    pub(in crate::functions) fn name(&self, of: &str) -> String {
        let by = self.joined("_");
        match self.kind {
            DerivativeKind::Jacobian => format!("d_{of}_d_{by}"),
            DerivativeKind::PackedJacobian => format!("d_{of}_d_{by}_packed"),
            DerivativeKind::Jvp => format!("jvp_{of}_{by}"),
            DerivativeKind::Vjp => format!("vjp_{of}_{by}"),
            DerivativeKind::Hessian => format!("hessian_{of}_{by}"),
        }
    }

    /// What it is given beside the function's own arguments; `own_length` is that of dimensions
    /// that the function decides.
    pub(in crate::functions) fn arguments(
        &self,
        of: &[Output],
        own_length: usize,
    ) -> Vec<Argument> {
        match self.kind {
            DerivativeKind::Jacobian | DerivativeKind::PackedJacobian => Vec::new(),
            DerivativeKind::Jvp => self.by.iter().filter_map(Variable::direction).collect(),
            DerivativeKind::Vjp | DerivativeKind::Hessian => {
                let outputs = of.iter().enumerate();
                let multiplier = |(place, output): (usize, &Output)| {
                    Multiplier::of(place, output.multiplier, output.shape, own_length)
                };
                outputs
                    .map(|output| Argument::Multiplier(multiplier(output)))
                    .collect()
            }
        }
    }

    /// What it writes: for each output as many as there are variables, or one for each output, or for each variable, or one packed.
    pub(in crate::functions) fn outputs(&self, of: &[Output]) -> Vec<Output> {
        let by_all = |output: &Output| {
            let by = |variable: &Variable| {
                let shape = Shape {
                    by: variable.dimensions(),
                    ..output.shape
                };
                let (of, by) = (&output.name, variable.name());
                let meaning = format!("the derivatives of `{of}` by {}", variable.meaning());
                let unit = Unit::quotients([(&output.unit, &variable.unit())]);
                Output::derived(format!("d{of}_d{by}"), shape, unit, meaning)
            };
            self.by.iter().map(by).collect::<Vec<_>>()
        };
        let along = |output: &Output| {
            let of = &output.name;
            let meaning = format!("the change of `{of}`");
            Output::derived(format!("d{of}"), output.shape, output.unit.clone(), meaning)
        };
        let gradient = |variable: &Variable| {
            let name = format!("{}_gradient", variable.name());
            let shape = Shape::of(variable.dimensions());
            let meaning = format!("the gradient by {}", variable.meaning());
            Output::derived(name, shape, Unit::UNKNOWN, meaning)
        };
        let packed = |name: &str, unit: Unit, meaning: &str| {
            vec![Output::derived(
                name.to_owned(),
                Shape::ENTRIES,
                unit,
                meaning.to_owned(),
            )]
        };
        match self.kind {
            DerivativeKind::Jacobian => of.iter().flat_map(by_all).collect(),
            DerivativeKind::Jvp => of.iter().map(along).collect(),
            DerivativeKind::Vjp => self.by.iter().map(gradient).collect(),
            DerivativeKind::PackedJacobian => {
                let by: Vec<Unit> = self.by.iter().map(Variable::unit).collect();
                let pairs = of.iter().flat_map(|of| by.iter().map(|by| (&of.unit, by)));
                let meaning = "the derivatives that the tree does not make zero";
                packed("derivatives", Unit::quotients(pairs), meaning)
            }
            DerivativeKind::Hessian => {
                let meaning = "the second derivatives that the tree does not make zero";
                packed("hessian", Unit::UNKNOWN, meaning)
            }
        }
    }

    /// Lines of documentation; `of` is the text of the function, `places` the constant that says where entries stand.
    pub(in crate::functions) fn doc(
        &self,
        of: &str,
        outputs: &[Output],
        places: &str,
    ) -> Vec<String> {
        let first = match self.kind {
            DerivativeKind::Jacobian => format!(
                "The derivatives of `{of}`: rows are the entries of its outputs, columns those of the variables."
            ),
            DerivativeKind::PackedJacobian => format!(
                "The derivatives of `{of}` without those that the tree makes zero, whatever its numbers are: `{places}` holds the row and column of each. Rows count the entries of all outputs one after the other, columns those of the variables in this order:"
            ),
            DerivativeKind::Jvp => format!(
                "How the outputs of `{of}` change along a direction: its derivatives times the change of each variable."
            ),
            DerivativeKind::Vjp => format!(
                "The gradient of the sum of the entries of `{of}`, each times its multiplier."
            ),
            DerivativeKind::Hessian => format!(
                "The second derivatives of the sum of the entries of `{of}`, each times its multiplier. They are symmetric: `{places}` holds the row and column of each on and below the diagonal that the tree does not make zero. Rows and columns count the entries of the variables in this order:"
            ),
        };
        let mut lines = vec![first];
        let of_variables = outputs.iter().zip(self.by.iter().cycle());
        let of_variables = of_variables
            .map(|(output, variable)| format!("- `{}`: by {}.", output.name, variable.meaning()));
        let in_order = self
            .by
            .iter()
            .map(|variable| format!("- By {}.", variable.meaning()));
        match self.kind {
            DerivativeKind::Jacobian | DerivativeKind::Vjp => lines.extend(of_variables),
            _ => lines.extend(in_order),
        }
        lines
    }

    /// Which of its entries are not structurally zero; `values` derives what is differentiated, of the tree of drawn numbers that
    /// it is given. `None` where none is left out.
    pub(in crate::functions) fn sparsity(
        &self,
        tree: &Tree,
        of: (&[Output], usize),
        values: impl Fn(&Tree) -> Derived,
    ) -> Option<Arc<Sparsity>> {
        if !self.kind.is_packed() {
            return None;
        }
        let is_second = self.kind == DerivativeKind::Hessian;
        Some(self.sparsity.get_or_find(tree, || {
            let mut rows: Vec<BTreeSet<usize>> = Vec::new();
            let mut n_columns = 0;
            // A number that becomes a parameter, perhaps of several coordinates, makes nothing zero.
            let drawn = DRAWN.into_iter().flat_map(|seed| {
                let apart = tree.with_drawn_parameters_apart(seed);
                std::iter::once(tree.with_drawn_parameters(seed)).chain(apart)
            });
            for drawn in drawn {
                let mut derived = values(&drawn);
                let graph = &mut derived.graph;
                graph.enter(None);
                // How inputs change follows from joints alone.
                let (seeds, columns) = self.seeds(graph, tree);
                n_columns = columns.last().map_or(0, |last| last.end);
                let roots = if is_second {
                    let multipliers = self.arguments(of.0, of.1);
                    let weighted = (&multipliers[..], &derived.roots[..]);
                    gradient(graph, tree, weighted, &seeds, n_columns)
                } else {
                    derived.roots
                };
                let found = dependences(graph, &roots, (tree, &seeds));
                rows.resize(found.len(), BTreeSet::new());
                for (row, found) in rows.iter_mut().zip(found) {
                    row.extend(found);
                }
            }
            if is_second {
                Sparsity::of_second(&rows)
            } else {
                Sparsity::of_first(&rows, n_columns)
            }
        }))
    }

    /// Adds the derivatives of these values, the entries of outputs with `sizes`, to what is derived.
    pub(in crate::functions) fn apply(
        &self,
        derived: &mut Derived,
        tree: &Tree,
        values: &[Expr],
        sizes: &[usize],
        sweep: Sweep,
        Asked {
            multipliers,
            sparsity,
        }: Asked<'_>,
    ) {
        let graph = &mut derived.graph;
        graph.enter(None);
        let (seeds, columns) = self.seeds(graph, tree);
        let n_columns = columns.last().map_or(0, |last| last.end);
        let places = sparsity.map_or(&[][..], |sparsity| &sparsity.places);
        match self.kind {
            DerivativeKind::Jacobian => {
                let rows = sweep.rows(graph, values, &seeds);
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
            DerivativeKind::PackedJacobian => {
                let rows = sweep.rows(graph, values, &seeds);
                for &[row, column] in places {
                    let entry = entry(graph, &rows[row], column);
                    derived.roots.push(entry);
                }
            }
            DerivativeKind::Jvp => {
                let seeds = self.along(graph, tree, seeds);
                for row in sweep.rows(graph, values, &seeds) {
                    derived.extend_by(&row, 0..1);
                }
            }
            DerivativeKind::Vjp => {
                let weighted = weighted(graph, tree, multipliers, values);
                let rows = sweep.rows(graph, &[weighted], &seeds);
                derived.extend_by(&rows[0], 0..n_columns);
            }
            DerivativeKind::Hessian => {
                let weighted = (multipliers, values);
                let gradient = gradient(graph, tree, weighted, &seeds, n_columns);
                let rows = sweep.rows(graph, &gradient, &seeds);
                let mixing = self.mixing(tree, &columns);
                let entries = symmetric(graph, &rows, &mixing, places);
                derived.roots.extend(entries);
            }
        }
    }

    /// How inputs change with the entries of all variables, and the columns of each.
    pub(in crate::functions) fn seeds(&self, graph: &mut ExprGraph, tree: &Tree) -> Seeded {
        let mut seeds = Seeds::new();
        let mut columns: Vec<Range<usize>> = Vec::with_capacity(self.by.len());
        for variable in &self.by {
            let first = columns.last().map_or(0, |last| last.end);
            variable.seed(graph, tree, first, &mut seeds);
            columns.push(first..first + variable.n_entries(tree));
        }
        (seeds, columns)
    }

    /// The rows and columns of second derivatives, lower triangle, along motions whose order matters.
    /// At constant speeds both are done at once, which to second order is the mean of one after the other and the other way round.
    pub(super) fn mixing(&self, tree: &Tree, columns: &[Range<usize>]) -> BTreeSet<[usize; 2]> {
        let of_variables = self.by.iter().zip(columns);
        let of_motions = of_variables.filter(|(variable, _)| variable.is_motion());
        let pairs = of_motions.flat_map(|(_, columns)| {
            let pairs = tree.order_dependent_turns().into_iter();
            pairs.map(|pair| pair.map(|speed| columns.start + speed))
        });
        pairs.collect()
    }

    /// How inputs change along the direction.
    pub(in crate::functions) fn along(
        &self,
        graph: &mut ExprGraph,
        tree: &Tree,
        seeds: Seeds,
    ) -> Seeds {
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
fn weighted(graph: &mut ExprGraph, tree: &Tree, multipliers: &[Argument], values: &[Expr]) -> Expr {
    let inputs = multipliers.iter().flat_map(|own| own.inputs(tree));
    let mut sum = graph.zero();
    for (input, &value) in inputs.zip(values) {
        let own = graph.input(input);
        let term = graph.mul(own, value);
        sum = graph.add(sum, term);
    }
    sum
}

/// How that sum changes with each variable.
pub(in crate::functions) fn gradient(
    graph: &mut ExprGraph,
    tree: &Tree,
    (multipliers, values): (&[Argument], &[Expr]),
    seeds: &Seeds,
    n_columns: usize,
) -> Vec<Expr> {
    let weighted = weighted(graph, tree, multipliers, values);
    let rows = reverse(graph, &[weighted], seeds);
    entries(graph, &rows[0], 0..n_columns)
}

/// The entry of a row in a column, zero where it has none.
pub(in crate::functions) fn entry(graph: &mut ExprGraph, row: &Row, column: usize) -> Expr {
    let place = row.binary_search_by_key(&column, |&(place, _)| place);
    place.map_or_else(|_| graph.zero(), |place| row[place].1)
}

/// The entries of second derivatives at these places: where the order of two motions matters, the mean of both orders.
pub(super) fn symmetric(
    graph: &mut ExprGraph,
    rows: &[Row],
    mixing: &BTreeSet<[usize; 2]>,
    places: &[[usize; 2]],
) -> Vec<Expr> {
    let at = |&[row, column]: &[usize; 2]| {
        let own = entry(graph, &rows[row], column);
        if !mixing.contains(&[row, column]) {
            return own;
        }
        let mirrored = entry(graph, &rows[column], row);
        let twice = graph.add(own, mirrored);
        let half = graph.number(0.5);
        graph.mul(half, twice)
    };
    places.iter().map(at).collect()
}

/// The entries of a row in these columns, zeros among them.
pub(in crate::functions) fn entries(
    graph: &mut ExprGraph,
    row: &Row,
    columns: Range<usize>,
) -> Vec<Expr> {
    columns.map(|column| entry(graph, row, column)).collect()
}

impl Derived {
    /// Adds the entries of a row in these columns.
    fn extend_by(&mut self, row: &Row, columns: Range<usize>) {
        let entries = entries(&mut self.graph, row, columns);
        self.roots.extend(entries);
    }
}
