//! The columns of the regressor as numbers: of each body and parameter what it is in seeded states.

use std::collections::BTreeMap;

use crate::{
    drawn::with_unit_quaternions,
    expr::{ExprGraph, Input},
    id::{CoordinateId, ParameterId, SpeedId},
    number::Rounded,
    random::Random,
    recursive::{Plan, regressor},
    tree::{InertialParameter, N_INERTIAL, Tree},
};

/// States for each body that a speed moves: enough for twice the columns that are compared.
const STATES: usize = 20;

/// A column is nothing where it is shorter beside the longest of its kind: rotations leave that of zeros.
const CRUMB: f64 = 1e-13;

/// Columns of unit length.
pub(super) struct Columns {
    columns: Vec<Column>,
}

/// A column.
pub(super) struct Column {
    /// Its numbers over its length; all zero where it is nothing but rounding, or not finite.
    pub(super) unit: Vec<f64>,
    /// Its length.
    pub(super) length: f64,
    /// Its length over that of the longest of its body and kind.
    pub(super) share: f64,
    /// How far rounding may have moved the unit.
    pub(super) error: f64,
    /// False where some number is too large for f64: nothing is known of it.
    pub(super) is_known: bool,
}

impl Columns {
    /// Those of the tree with these values of its parameters.
    pub(super) fn new(tree: &Tree, parameters: &[f64]) -> Self {
        let mut graph = ExprGraph::default();
        let y = regressor::regressor(&mut graph, tree, &Plan::full(tree));
        let n_columns = tree.bodies.len() * N_INERTIAL;
        let n_states = STATES * (1 + tree.bodies.len().div_ceil(tree.n_speeds.max(1)));
        let mut numbers: Vec<Vec<Rounded>> = vec![Vec::new(); n_columns];
        let mut random = Random::new(1);
        for _ in 0..n_states {
            let inputs = state(tree, parameters, &mut random);
            let values = graph.evaluate(&y, |input| Rounded::exact(inputs[&input]));
            for row in values.chunks(n_columns.max(1)) {
                for (column, &value) in numbers.iter_mut().zip(row) {
                    column.push(value);
                }
            }
        }
        let columns = numbers.iter().map(|numbers| Column::of(numbers));
        let mut columns: Vec<Column> = columns.collect();
        for of_body in columns.chunks_mut(N_INERTIAL) {
            for alike in [InertialParameter::MOMENTS, InertialParameter::INERTIAS] {
                compare(&mut of_body[alike]);
            }
        }
        Self { columns }
    }

    pub(super) fn len(&self) -> usize {
        self.columns.len()
    }

    pub(super) fn at(&self, place: usize) -> &Column {
        &self.columns[place]
    }
}

impl Column {
    fn of(numbers: &[Rounded]) -> Self {
        let length = norm(numbers.iter().map(|number| number.value));
        let error = norm(numbers.iter().map(|number| number.error));
        let is_known = length.is_finite() && error.is_finite();
        let unit = |number: &Rounded| {
            if is_known && length > error {
                number.value / length
            } else {
                0.0
            }
        };
        Self {
            unit: numbers.iter().map(unit).collect(),
            length,
            share: 1.0,
            error: if length > error { error / length } else { 0.0 },
            is_known,
        }
    }
}

/// Compares columns of a kind by length, and makes zeros of those that are nothing beside the others.
fn compare(columns: &mut [Column]) {
    let lengths = columns.iter().map(|column| column.length);
    let longest = lengths.fold(0.0, f64::max);
    for column in columns {
        if !column.is_known || longest == 0.0 {
            continue;
        }
        column.share = column.length / longest;
        if column.share < CRUMB {
            column.unit.fill(0.0);
            column.error = 0.0;
        }
    }
}

/// All that the regressor reads.
fn state(tree: &Tree, parameters: &[f64], random: &mut Random) -> BTreeMap<Input, f64> {
    let coordinates = (0..tree.n_coordinates).map(|place| Input::Q(CoordinateId::new(place)));
    let speeds = (0..tree.n_speeds).map(SpeedId::new);
    let speeds = speeds.flat_map(|speed| [Input::U(speed), Input::UDot(speed)]);
    let drawn = coordinates
        .chain(speeds)
        .map(|input| (input, random.number()));
    let mut inputs: BTreeMap<Input, f64> = drawn.collect();
    for (place, &value) in parameters.iter().enumerate() {
        inputs.insert(Input::Parameter(ParameterId::new(place)), value);
    }
    with_unit_quaternions(tree, inputs)
}

/// The Euclidean length, of numbers of any size.
pub(super) fn norm(numbers: impl Iterator<Item = f64> + Clone) -> f64 {
    let largest = numbers.clone().fold(0.0, |most: f64, number| {
        // NaN stays.
        if most >= number.abs() {
            most
        } else {
            number.abs()
        }
    });
    if largest == 0.0 || !largest.is_finite() {
        return largest;
    }
    let parts = numbers.map(|number| number / largest);
    let square: f64 = parts.map(|part| part * part).sum();
    largest * square.sqrt()
}
