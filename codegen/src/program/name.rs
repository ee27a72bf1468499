//! Names from structure: the body, then the quantity, or a number counted within the body.
//!
//! No name depends on how many values another body has, so a change to one body leaves the others' lines alone.

use std::collections::{BTreeMap, BTreeSet};

use super::{Groups, Instruction, Origin, Program};
use crate::{
    expr::{Input, Node},
    id::BodyId,
    passes::{
        hoist::{Field, Preparation},
        sines,
    },
    tree::Tree,
};

/// Names that generated functions use for other things: arguments, outputs, what holds sines and cosines.
pub const RESERVED: [&str; 31] = [
    "accelerations",
    "alpha",
    "bias",
    "columns",
    "cosines",
    "distances",
    "energy",
    "entries",
    "f",
    "loads",
    "m",
    "momentum",
    "normalized",
    "p",
    "parameters",
    "pivots",
    "positions",
    "q",
    "q_dot",
    "rates",
    "rotations",
    "sin_cos",
    "sines",
    "tau",
    "u",
    "u_dot",
    "velocities",
    "w",
    "w_rel",
    "kane",
    "core",
];

/// Where a program's values stand.
#[derive(Clone, Copy, Debug)]
pub enum Place<'a> {
    /// In a function, which reads these fields of `Prepared`.
    Function {
        /// The fields, in the order of the prepared values.
        fields: &'a [String],
        /// The names of its outputs.
        outputs: &'a [String],
    },
    /// In what computes `Prepared`.
    Preparation,
}

/// A name for each value that is an input or has a statement of its own; empty for the others.
pub fn names(program: &Program, groups: &Groups, tree: &Tree, place: Place<'_>) -> Vec<String> {
    let known = Known::of(tree);
    let mut names = vec![String::new(); program.values.len()];
    let mut taken: BTreeSet<String> = RESERVED.map(String::from).into();
    let mut counters: BTreeMap<Option<BodyId>, usize> = BTreeMap::new();
    let (fields, outputs, letter): (&[String], &[String], _) = match place {
        Place::Function { fields, outputs } => (fields, outputs, "t"),
        Place::Preparation => (&[], &[], "k"),
    };
    taken.extend(outputs.iter().cloned());
    let mut claim = |name: String| {
        let mut unique = name;
        while !taken.insert(unique.clone()) {
            unique.push('_');
        }
        unique
    };
    for (value, name) in program.values.iter().zip(&mut names) {
        if let Origin::Input(input) = value.origin {
            *name = match input {
                // A field of `Prepared`, not a local.
                Input::Prepared(place) => fields[place].clone(),
                _ => claim(known.input(tree, input)),
            };
        }
    }
    for id in program.instructions.iter().flat_map(Instruction::results) {
        if groups.inlined(id).is_some() {
            continue;
        }
        let value = program.value(id);
        let body = value
            .scope
            .map_or("system", |body| tree.body(body).identifier.as_str());
        names[id.index()] = if let Some(label) = &value.label {
            claim(format!("{body}_{label}"))
        } else {
            let counter = counters.entry(value.scope).or_default();
            *counter += 1;
            claim(format!("{body}_{letter}{counter}"))
        };
    }
    names
}

/// The fields of `Prepared`, in the order of the prepared values: a parameter's own name, or the function, the body and
/// what it is there.
pub fn prepared_fields(preparation: &Preparation, tree: &Tree) -> Vec<String> {
    let mut taken = BTreeSet::new();
    let mut counters: BTreeMap<_, usize> = BTreeMap::new();
    let name = |field: &Field| {
        let body = field
            .scope
            .map_or("system", |body| tree.body(body).identifier.as_str());
        let mut name = match (
            field.function.as_deref(),
            &field.label,
            preparation.graph.node(field.root.node()),
        ) {
            (_, _, Node::Input(input)) => Known::default().input(tree, input),
            (function, Some(label), _) => {
                format!("{}_{body}_{label}", function.unwrap_or_default())
            }
            (function, None, _) => {
                let counter = counters
                    .entry((field.function.clone(), field.scope))
                    .or_default();
                *counter += 1;
                format!("{}_{body}_k{counter}", function.unwrap_or_default())
            }
        };
        while !taken.insert(name.clone()) {
            name.push('_');
        }
        name
    };
    preparation.fields.iter().map(name).collect()
}

/// The names of coordinates, speeds and what belongs to these.
#[derive(Default)]
struct Known {
    q: Vec<String>,
    /// The body and axis of each angle: `hinge` and `3`.
    angles: Vec<(String, &'static str)>,
    u: Vec<String>,
    u_dot: Vec<String>,
    tau: Vec<String>,
}

impl Known {
    fn of(tree: &Tree) -> Self {
        Self {
            q: tree.coordinate_names(),
            angles: sines::angles(tree)
                .into_iter()
                .map(|angle| {
                    let axis = angle.kind.trim_start_matches("theta");
                    (tree.body(angle.body).identifier.clone(), axis)
                })
                .collect(),
            u: tree.speed_names(),
            u_dot: tree.along_speeds("_ddot", "_dot"),
            tau: tree.along_speeds("_tau", "_tau"),
        }
    }

    fn input(&self, tree: &Tree, input: Input) -> String {
        let component = |body: BodyId, quantity: &str, axis: usize| {
            format!(
                "{}_{quantity}_{}",
                tree.body(body).identifier,
                ["x", "y", "z"][axis]
            )
        };
        let sine = |place: usize, function: &str| {
            let (body, axis) = &self.angles[place];
            format!("{body}_{function}{axis}")
        };
        match input {
            Input::Sine(place) => sine(place, "sin"),
            Input::Cosine(place) => sine(place, "cos"),
            Input::Q(coordinate) => self.q[coordinate.index()].clone(),
            Input::U(speed) => self.u[speed.index()].clone(),
            Input::UDot(speed) => self.u_dot[speed.index()].clone(),
            Input::Tau(speed) => self.tau[speed.index()].clone(),
            Input::Force(body, axis) => component(body, "force", axis),
            Input::Moment(body, axis) => component(body, "moment", axis),
            Input::RelativeAngularVelocity(body, axis) => component(body, "w_rel", axis),
            Input::Parameter(parameter) => tree.parameters[parameter.index()].name.clone(),
            Input::Prepared(place) => format!("prepared_{place}"),
        }
    }
}
