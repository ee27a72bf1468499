//! What a function fills for its calls: arrays that stand beside its arguments.
//!
//! Each number is stored there as soon as it is known, as in an output, so that none waits for a call.

use std::collections::BTreeMap;

use crate::listing::{Entry, Role, Step};
use crate::{
    functions::{Declared, Element, Length},
    program::{Instruction, Operand, Program},
};

/// Where a function's calls find what they read.
#[derive(Debug, Default)]
pub(super) struct Scratch {
    /// How many arguments come before it.
    n_arguments: usize,
    /// The arrays.
    pub(super) declared: Vec<Declared>,
    /// By number, where what calls share stands.
    shared: BTreeMap<usize, usize>,
    /// For each call, where what is of its columns stands.
    sides: Vec<usize>,
}

impl Scratch {
    /// That of a program, behind so many arguments.
    pub(super) fn of(program: &Program, n_arguments: usize) -> Self {
        let mut scratch = Self {
            n_arguments,
            ..Self::default()
        };
        for instruction in &program.instructions {
            match instruction {
                Instruction::Share { lockstep, values } => {
                    let name = numbered(Role::Shared.name(), scratch.shared.len());
                    let place = scratch.declare(&name, &[values.len()]);
                    scratch.shared.insert(*lockstep, place);
                }
                Instruction::Call { helper, sides, .. } => {
                    let lanes = program.helpers[*helper].lanes;
                    let name = numbered(Role::Sides.name(), scratch.sides.len());
                    let place = scratch.declare(&name, &[sides.len(), lanes]);
                    scratch.sides.push(place);
                }
                Instruction::Compute { .. } | Instruction::SinCos { .. } => {}
            }
        }
        scratch
    }

    fn declare(&mut self, name: &str, lengths: &[usize]) -> usize {
        let lengths = lengths.iter().map(|&length| Length::Number(length));
        self.declared.push(Declared {
            lengths: lengths.collect(),
            ..Declared::written(name, Element::Scalar)
        });
        self.n_arguments + self.declared.len() - 1
    }

    /// What a call is given: what all columns share, if there is any, and what is of each.
    pub(super) fn given(&self, lockstep: usize, call: usize) -> (Option<usize>, usize) {
        (self.shared.get(&lockstep).copied(), self.sides[call])
    }

    /// What is stored, and where.
    pub(super) fn stores(&self, program: &Program) -> Vec<(Entry, Operand)> {
        let mut stores = Vec::new();
        let mut sides_of = self.sides.iter();
        for instruction in &program.instructions {
            match instruction {
                Instruction::Share { lockstep, values } => {
                    let argument = self.shared[lockstep];
                    let values = values.iter().enumerate();
                    stores.extend(values.map(|(place, &value)| (at(argument, &[place]), value)));
                }
                Instruction::Call { sides, .. } => {
                    let argument = sides_of.next().copied().unwrap_or_default();
                    for (row, lanes) in sides.iter().enumerate() {
                        let lanes = lanes.iter().enumerate();
                        stores
                            .extend(lanes.map(|(lane, &side)| (at(argument, &[row, lane]), side)));
                    }
                }
                Instruction::Compute { .. } | Instruction::SinCos { .. } => {}
            }
        }
        stores
    }
}

fn at(argument: usize, places: &[usize]) -> Entry {
    Entry {
        argument,
        steps: places.iter().map(|&place| Step::Index(place)).collect(),
    }
}

/// The name of one of several: the first has no number.
pub(super) fn numbered(name: &str, place: usize) -> String {
    match place {
        0 => name.to_owned(),
        _ => format!("{name}_{}", place + 1),
    }
}
