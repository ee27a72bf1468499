//! What functions are differentiated by.
//!
//! In: a [`Variable`]. Out: its name, the dimensions that it adds to an output, and how what the equations are given changes with
//! each of its entries. Coordinates change along the motions of the speeds: a column for each speed, whatever the chart.

use super::{
    argument::Argument,
    roots,
    shape::{Dimension, Shape},
    unit::Unit,
};
use crate::{
    differentiate::{Seeds, forward},
    expr::{Expr, ExprGraph, Input},
    id::{ParameterId, SpeedId},
    tree::Tree,
};

/// What a function can be differentiated by.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Variable {
    /// What it is given.
    Given(Argument),
    /// All values set at run time.
    Parameters,
    /// One of them.
    Parameter {
        /// Which.
        id: ParameterId,
        /// The field of `Parameters`.
        name: String,
        /// Its unit.
        unit: &'static str,
    },
}

/// The arguments that are variables.
const ARGUMENTS: [Argument; 5] = [
    Argument::Q,
    Argument::U,
    Argument::UDot,
    Argument::Tau,
    Argument::Loads,
];

/// What stands for all values set at run time.
pub const PARAMETERS: &str = "parameters";

/// The constant that holds their names.
pub const PARAMETER_NAMES: &str = "PARAMETER_NAMES";

impl super::function::Function {
    /// The arguments by which it can be differentiated.
    pub(super) fn variables(&self) -> impl Iterator<Item = Argument> {
        let variables = ARGUMENTS.into_iter();
        variables.filter(|argument| self.arguments.contains(argument))
    }
}

/// The variable of which a name is that of an entry: a coordinate or a speed.
pub(super) fn holding(tree: &Tree, name: &str) -> Option<&'static str> {
    let has = |names: Vec<String>| names.iter().any(|own| own == name);
    if has(tree.coordinate_names()) {
        Some(Argument::Q.name())
    } else if has(tree.speed_names()) {
        Some(Argument::U.name())
    } else {
        None
    }
}

impl Variable {
    /// The variable with this name, if there is one.
    pub(super) fn find(tree: Option<&Tree>, name: &str) -> Option<Self> {
        let mut arguments = ARGUMENTS.into_iter();
        let argument = arguments.find(|argument| argument.name() == name);
        let of_name = |tree: &Tree| {
            let mut parameters = tree.parameters.iter();
            let place = parameters.position(|parameter| parameter.name == name)?;
            Some(Self::Parameter {
                id: ParameterId::new(place),
                name: name.to_owned(),
                unit: tree.parameters[place].unit,
            })
        };
        let all = (name == PARAMETERS).then_some(Self::Parameters);
        let found = argument.map(Self::Given).or(all);
        found.or_else(|| tree.and_then(of_name))
    }

    /// Its name in generated code.
    pub fn name(&self) -> &str {
        match self {
            Self::Given(argument) => argument.name(),
            Self::Parameters => PARAMETERS,
            Self::Parameter { name, .. } => name,
        }
    }

    /// The dimensions that it adds to an output, innermost.
    pub fn dimensions(&self) -> &'static [Dimension] {
        match self {
            Self::Given(Argument::Q) => Shape::SPEEDS.dimensions,
            Self::Given(Argument::Loads) => &[Dimension::Bodies, Dimension::LoadComponents],
            Self::Given(argument) => argument.shape().dimensions,
            Self::Parameters => &[Dimension::Values],
            Self::Parameter { .. } => &[],
        }
    }

    /// True for coordinates, which change along motions.
    pub(super) fn is_motion(&self) -> bool {
        *self == Self::Given(Argument::Q)
    }

    /// True where this value set at run time is an entry of it.
    pub(super) fn has(&self, parameter: ParameterId) -> bool {
        match self {
            Self::Given(_) => false,
            Self::Parameters => true,
            Self::Parameter { id, .. } => *id == parameter,
        }
    }

    /// The direction along which it changes; `None` for one value set at run time.
    pub(super) fn direction(&self) -> Option<Argument> {
        match self {
            Self::Given(argument) => argument.direction(),
            Self::Parameters => Some(Argument::ParametersDirection),
            Self::Parameter { .. } => None,
        }
    }

    /// What an entry of it means, in words.
    pub fn meaning(&self) -> String {
        let name = self.name();
        match self {
            Self::Given(Argument::Q) => {
                "`q` along the motion of each speed, per rad or m of that motion".to_owned()
            }
            Self::Given(Argument::Loads) => "`loads`, of each body force before moment".to_owned(),
            Self::Parameters => {
                "the values set at run time, in the order of `PARAMETER_NAMES`".to_owned()
            }
            Self::Given(_) | Self::Parameter { .. } => format!("`{name}`"),
        }
    }

    /// The units of its entries.
    pub(super) fn unit(&self) -> Unit {
        match self {
            Self::Given(Argument::Q) => Argument::QDirection.unit(),
            Self::Given(argument) => argument.unit(),
            Self::Parameters => Unit::UNKNOWN,
            Self::Parameter { unit, .. } => Unit::Single(unit),
        }
    }

    /// How many entries it has.
    pub fn n_entries(&self, tree: &Tree) -> usize {
        let lengths = self
            .dimensions()
            .iter()
            .map(|dimension| dimension.length(tree));
        let lengths = lengths
            .map(|length| length.expect("functions: a variable's dimensions are the tree's"));
        lengths.product()
    }

    /// How inputs change with its entries, of which the first stands at `first`.
    pub(super) fn seed(&self, graph: &mut ExprGraph, tree: &Tree, first: usize, seeds: &mut Seeds) {
        let one = graph.one();
        let inputs: Vec<Input> = match self {
            Self::Given(Argument::Q) => {
                let rates = rates(graph, tree);
                let moved = Argument::Q.inputs(tree).zip(rates);
                for (input, row) in moved {
                    let row = row.into_iter().map(|(place, entry)| (first + place, entry));
                    seeds.entry(input).or_default().extend(row);
                }
                return;
            }
            Self::Given(argument) => argument.inputs(tree).collect(),
            Self::Parameters => {
                let all = 0..tree.parameters.len();
                all.map(|place| Input::Parameter(ParameterId::new(place)))
                    .collect()
            }
            Self::Parameter { id, .. } => vec![Input::Parameter(*id)],
        };
        for (place, input) in (first..).zip(inputs) {
            seeds.entry(input).or_default().push((place, one));
        }
    }
}

/// By how much each coordinate's rate changes with every speed: the motion of that speed alone.
fn rates(graph: &mut ExprGraph, tree: &Tree) -> Vec<Vec<(usize, Expr)>> {
    let q_dot = roots::coordinates::q_dot(graph, tree);
    let one = graph.one();
    let speeds = 0..tree.n_speeds;
    let seeds = speeds.map(|place| (Input::U(SpeedId::new(place)), vec![(place, one)]));
    forward(graph, &q_dot, &seeds.collect())
}
