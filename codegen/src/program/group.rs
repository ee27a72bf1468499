//! Which operations share a statement: a sum of products reads better on one line than on five.
//!
//! A value joins the expression that uses it where it has no label, is used once, and was computed just before, so
//! that the order of evaluation stays the order of the program.

use super::{Instruction, Operation, Origin, Program, ValueId};

/// The most operations in one statement.
const LARGEST: usize = 12;

/// The statements of a program.
#[derive(Clone, Debug)]
pub struct Groups {
    /// For each value, the operation that computes it where it stands inside a larger expression.
    inlined: Vec<Option<Operation>>,
}

impl Groups {
    /// Groups the operations of a program.
    pub fn of(program: &Program) -> Self {
        let uses = uses(program);
        let mut groups = Self {
            inlined: vec![None; program.values.len()],
        };
        // The group that ends at each instruction: where it begins, and its operations.
        let mut starts = vec![0; program.instructions.len()];
        let mut sizes = vec![0; program.instructions.len()];
        let mut assigned_at = vec![None; program.values.len()];
        for (place, instruction) in program.instructions.iter().enumerate() {
            starts[place] = place;
            sizes[place] = 1;
            let Instruction::Compute { result, operation } = instruction else {
                continue;
            };
            assigned_at[result.index()] = Some(place);
            let mut operands: Vec<ValueId> = operation
                .operands()
                .filter_map(super::Operand::value)
                .collect();
            operands.sort_by_key(|id| std::cmp::Reverse(assigned_at[id.index()]));
            for id in operands {
                let value = program.value(id);
                let joins = value.origin == Origin::Instruction
                    && value.label.is_none()
                    && uses[id.index()] == 1;
                let Some(end) = assigned_at[id.index()].filter(|_| joins) else {
                    continue;
                };
                if end + 1 == starts[place] && sizes[place] + sizes[end] <= LARGEST {
                    groups.inlined[id.index()] = operation_at(program, end);
                    starts[place] = starts[end];
                    sizes[place] += sizes[end];
                }
            }
        }
        groups
    }

    /// The operation of a value that stands inside a larger expression; `None` for one with a statement of its own.
    pub fn inlined(&self, id: ValueId) -> Option<Operation> {
        self.inlined[id.index()]
    }
}

fn operation_at(program: &Program, place: usize) -> Option<Operation> {
    match program.instructions[place] {
        Instruction::Compute { operation, .. } => Some(operation),
        Instruction::SinCos { .. } => None,
    }
}

/// How often each value is used.
fn uses(program: &Program) -> Vec<usize> {
    let mut uses = vec![0; program.values.len()];
    let operands = program.instructions.iter().flat_map(Instruction::operands);
    for id in operands
        .chain(program.stores.iter().copied())
        .filter_map(super::Operand::value)
    {
        uses[id.index()] += 1;
    }
    uses
}
