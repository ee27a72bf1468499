//! Fused multiply-add: a product that is used once, by a sum, becomes part of the sum.
//!
//! In: a program. Out: one that rounds once where the other rounds twice. Afterwards: no value is a product whose only
//! use is a sum, but for those of sums of two products, of which one is fused. Keeps: what is computed, in which order,
//! and how many multiplications and additions there are. Does not: re-associate sums.

use super::{Helper, Instruction, Operand, Operation, Program, ValueId};

/// The program with its products fused into sums.
pub fn fuse(program: Program) -> Program {
    let products = lone_products(&program);
    let mut fused = vec![false; program.values.len()];
    let mut instructions = program.instructions;
    for instruction in &mut instructions {
        if let Instruction::Compute { operation, .. } = instruction
            && let Operation::Add(a, b) = *operation
        {
            // The right one first: in a long sum the left one is what has been summed so far.
            let found = [(b, a), (a, b)].into_iter().find_map(|(product, rest)| {
                let id = product.value()?;
                let (x, y) = products[id.index()]?;
                let x = if product.is_negative() { -x } else { x };
                Some((id, Operation::MulAdd(x, y, rest)))
            });
            if let Some((id, sum)) = found {
                fused[id.index()] = true;
                *operation = sum;
            }
        }
    }
    let is_left = |result: ValueId| !fused[result.index()];
    instructions.retain(|instruction| instruction.results().all(is_left));
    let helpers = program.helpers.into_iter().map(|helper| Helper {
        program: fuse(helper.program),
        ..helper
    });
    without(
        Program {
            instructions,
            helpers: helpers.collect(),
            values: program.values,
            stores: program.stores,
        },
        &fused,
    )
}

/// The factors of each value that is a product and is used once.
fn lone_products(program: &Program) -> Vec<Option<(Operand, Operand)>> {
    let uses = program.uses();
    let mut products = vec![None; program.values.len()];
    for instruction in &program.instructions {
        if let Instruction::Compute { result, operation } = instruction
            && let Operation::Mul(a, b) = *operation
            && uses[result.index()] == 1
        {
            products[result.index()] = Some((a, b));
        }
    }
    products
}

/// The program without values that nothing reads or assigns any more, the others numbered anew.
fn without(program: Program, removed: &[bool]) -> Program {
    let mut next = 0;
    let places: Vec<ValueId> = removed
        .iter()
        .map(|removed| {
            let place = ValueId(next);
            next += u32::from(!removed);
            place
        })
        .collect();
    let mut values = program.values;
    let mut removed = removed.iter();
    values.retain(|_| !removed.next().expect("fuse: one flag a value"));
    let place = |id: &mut ValueId| *id = places[id.index()];
    let read = |operand: &mut Operand| {
        if let Operand::Value { id, .. } = operand {
            place(id);
        }
    };
    let mut instructions = program.instructions;
    for instruction in &mut instructions {
        match instruction {
            Instruction::Compute { result, operation } => {
                place(result);
                operation.operands_mut().for_each(read);
            }
            Instruction::SinCos {
                angles,
                sines,
                cosines,
            } => {
                angles.iter_mut().for_each(read);
                let results = sines.iter_mut().chain(cosines);
                results.flatten().for_each(place);
            }
            Instruction::Share { values, .. } => values.iter_mut().for_each(read),
            Instruction::Call { sides, results, .. } => {
                sides.iter_mut().flatten().for_each(read);
                results.iter_mut().flatten().flatten().for_each(place);
            }
        }
    }
    let mut stores = program.stores;
    stores.iter_mut().for_each(read);
    Program {
        values,
        instructions,
        stores,
        helpers: program.helpers,
    }
}
