//! Names of what a helper is given, of each column and of all: those that the function which calls it has, for the first column, else a
//! number counted within the body that uses it first, so that one number more renames none of other bodies.

use std::collections::BTreeMap;

use super::input_names::InputNames;
use crate::{
    expr::Input,
    id::BodyId,
    program::{Definition, Helper, Instruction, Operand, Program},
    tree::Tree,
};

/// What the function knows by names: its inputs, and its fields that were computed before.
pub(super) struct Known<'a> {
    pub(super) tree: &'a Tree,
    pub(super) inputs: &'a InputNames,
    pub(super) fields: &'a [String],
}

/// Names of what a helper is given, by place.
#[derive(Default)]
pub(super) struct GivenNames {
    pub(super) shared: Vec<String>,
    pub(super) sides: Vec<String>,
}

impl Known<'_> {
    /// As the first call of the helper has them.
    pub(super) fn given(&self, program: &Program, helper: usize) -> GivenNames {
        let mut instructions = program.instructions.iter();
        let call = instructions.find_map(|instruction| match instruction {
            Instruction::Call {
                helper: own,
                lockstep,
                sides,
                ..
            } if *own == helper => Some((*lockstep, sides)),
            _ => None,
        });
        let Some((lockstep, sides)) = call else {
            return GivenNames::default();
        };
        let mut instructions = program.instructions.iter();
        let shared = instructions.find_map(|instruction| match instruction {
            Instruction::Share {
                lockstep: own,
                values,
            } if *own == lockstep => Some(values),
            _ => None,
        });
        let shared = shared.into_iter().flatten().map(|&own| Some(own));
        let firsts = sides.iter().map(|lanes| lanes.first().copied());
        let users = Users::of(&program.helpers[helper]);
        GivenNames {
            shared: self.names(program, shared.zip(users.shared), "shared"),
            sides: self.names(program, firsts.zip(users.sides), "side"),
        }
    }

    /// The names of numbers, each with the body within which it is counted if it has none.
    fn names(
        &self,
        program: &Program,
        numbers: impl Iterator<Item = (Option<Operand>, Option<BodyId>)>,
        what: &str,
    ) -> Vec<String> {
        let mut counters: BTreeMap<Option<BodyId>, usize> = BTreeMap::new();
        let names = numbers.map(|(number, body)| {
            let known = number.and_then(|number| self.name(program, number));
            known.unwrap_or_else(|| {
                let counter = counters.entry(body).or_default();
                *counter += 1;
                format!("{}_{what}{counter}", self.tree.identifier(body))
            })
        });
        names.collect()
    }

    fn name(&self, program: &Program, operand: Operand) -> Option<String> {
        let Operand::Value { id, negative } = operand else {
            return None;
        };
        let value = program.value(id);
        let name = match (&value.label, value.definition) {
            (Some(label), _) => {
                let body = self.tree.identifier(value.scope);
                let own = label.strip_prefix("minus_").filter(|_| negative);
                return Some(match own {
                    Some(own) => format!("{body}_{own}"),
                    None if negative => format!("{body}_minus_{label}"),
                    None => format!("{body}_{label}"),
                });
            }
            (None, Definition::Input(Input::Prepared(place))) => self.fields[place].clone(),
            (None, Definition::Input(Input::Shared(_) | Input::Side(_) | Input::CallResult(_))) => {
                return None;
            }
            (None, Definition::Input(input)) => self.inputs.input(self.tree, input),
            (None, Definition::Instruction) => return None,
        };
        Some(if negative {
            format!("minus_{name}")
        } else {
            name
        })
    }
}

/// The bodies of what uses each number first.
struct Users {
    shared: Vec<Option<BodyId>>,
    sides: Vec<Option<BodyId>>,
}

impl Users {
    fn of(helper: &Helper) -> Self {
        let program = &helper.program;
        let mut users = Self {
            shared: vec![None; helper.n_shared],
            sides: vec![None; helper.n_sides],
        };
        // The first one is what remains.
        for instruction in program.instructions.iter().rev() {
            let result = instruction.results().next();
            let body = result.and_then(|result| program.value(result).scope);
            for id in instruction.operands().filter_map(Operand::value) {
                match program.value(id).input() {
                    Some(Input::Shared(place)) => users.shared[place] = body,
                    Some(Input::Side(place)) => users.sides[place] = body,
                    _ => {}
                }
            }
        }
        users
    }
}
