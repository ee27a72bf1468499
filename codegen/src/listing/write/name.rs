//! Names of locals, from structure: the body, then the quantity, or a number counted within the body.
//!
//! No name depends on how many values another body has, so a change to one body leaves the others' lines alone.

use std::collections::BTreeMap;

use super::group::Groups;
use crate::{
    expr::Input,
    id::BodyId,
    program::{Definition, Instruction, Program},
    taken::Taken,
    tree::Tree,
    words,
};

/// Names that generated functions use for other things: arguments, outputs, what holds sines and cosines.
pub const RESERVED: [&str; 51] = [
    "acceleration",
    "accelerations",
    "alpha",
    "angular",
    "angular_velocity",
    "bias",
    "c",
    "columns",
    "cosines",
    "distances",
    "energies",
    "energy",
    "entries",
    "f",
    "force",
    "inverse",
    "inverse_inertia",
    "jacobian",
    "lane",
    "linear",
    "loads",
    "m",
    "m_dot",
    "moment",
    "momentum",
    "normalized",
    "p",
    "parameters",
    "pi",
    "pivots",
    "point",
    "position",
    "positions",
    "q",
    "q_dot",
    "rates",
    "rotation",
    "rotations",
    "sin_cos",
    "sines",
    "specific_force",
    "tau",
    "u",
    "u_dot",
    "velocities",
    "velocity",
    "w",
    "w_rel",
    "whole_tau",
    "whole_u_dot",
    "y",
];

/// What the values of a program are called that are only counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Numbering {
    /// `hub_t1`, in a function.
    InFunction,
    /// `hub_k1`, in what depends on parameters alone.
    InPreparation,
}

/// What the locals of a function are called.
pub(super) struct Names {
    /// A name for each value that is to have a local; empty for the others.
    pub(super) of_values: Vec<String>,
    /// These, and what else is a name in the function.
    pub(super) taken: Taken,
}

/// The names of a program's values, with these of its inputs. `arguments` are the function's own.
pub(super) fn names<'a>(
    program: &Program,
    groups: &Groups,
    (tree, of_input): (&Tree, &dyn Fn(Input) -> String),
    arguments: impl Iterator<Item = &'a str>,
    numbering: Numbering,
) -> Names {
    let mut of_values = vec![String::new(); program.values.len()];
    let reserved = RESERVED.into_iter().chain(words::RUST_CRATES);
    let mut taken: Taken = reserved.chain(arguments).collect();
    let mut counters: BTreeMap<Option<BodyId>, usize> = BTreeMap::new();
    for (value, name) in program.values.iter().zip(&mut of_values) {
        match value.definition {
            // Read where it stands.
            Definition::Input(Input::Prepared(_)) | Definition::Instruction => {}
            Definition::Input(input) => *name = taken.take(of_input(input)),
        }
    }
    let letter = match numbering {
        Numbering::InFunction => 't',
        Numbering::InPreparation => 'k',
    };
    for id in program.instructions.iter().flat_map(Instruction::results) {
        if groups.inlined(id).is_some() {
            continue;
        }
        let value = program.value(id);
        let body = tree.identifier(value.scope);
        let name = if let Some(label) = &value.label {
            format!("{body}_{label}")
        } else {
            let counter = counters.entry(value.scope).or_default();
            *counter += 1;
            format!("{body}_{letter}{counter}")
        };
        of_values[id.index()] = taken.take(name);
    }
    Names { of_values, taken }
}
