//! Names of what a helper is given of each column: those that the function which calls it has for the first, else a number counted
//! within the body that uses it first, so that one number more renames none of other bodies.

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

impl Known<'_> {
    /// By place, as the first call of the helper has them.
    pub(super) fn sides(&self, program: &Program, helper: usize) -> Vec<String> {
        let mut instructions = program.instructions.iter();
        let sides = instructions.find_map(|instruction| match instruction {
            Instruction::Call {
                helper: own, sides, ..
            } if *own == helper => Some(sides),
            _ => None,
        });
        let sides = sides
            .into_iter()
            .flatten()
            .zip(users(&program.helpers[helper]));
        let mut counters: BTreeMap<Option<BodyId>, usize> = BTreeMap::new();
        let sides = sides.map(|(lanes, user)| {
            let known = lanes.first().and_then(|&first| self.name(program, first));
            known.unwrap_or_else(|| {
                let counter = counters.entry(user).or_default();
                *counter += 1;
                format!("{}_side{counter}", self.tree.identifier(user))
            })
        });
        sides.collect()
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

/// The body of what uses each number of a column first.
fn users(helper: &Helper) -> Vec<Option<BodyId>> {
    let program = &helper.program;
    let mut users = vec![None; helper.n_sides];
    // The first one is what remains.
    for instruction in program.instructions.iter().rev() {
        let result = instruction.results().next();
        let body = result.and_then(|result| program.value(result).scope);
        for id in instruction.operands().filter_map(Operand::value) {
            if let Some(Input::Side(place)) = program.value(id).input() {
                users[place] = body;
            }
        }
    }
    users
}
