//! What every program must hold; a breach is a bug of a pass, but for a number too large for f64.

use std::collections::BTreeMap;

use super::{Definition, Instruction, Operand, Operation, Program, ValueFacts};
use crate::expr::Input;

/// A broken promise of a program.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum VerifyError {
    /// The description's numbers multiply to more than f64 holds.
    #[error("the numbers of the description multiply to a value that f64 does not hold")]
    NotFinite,
    /// A value is used before it is assigned, or never assigned.
    #[error("value {0} is used before it is assigned")]
    Unassigned(usize),
    /// A value is assigned twice.
    #[error("value {0} is assigned twice")]
    AssignedTwice(usize),
    /// A value is assigned and not used.
    #[error("value {0} is never used")]
    Dead(usize),
    /// An operation has only numbers for operands.
    #[error("value {0} has only numbers for operands")]
    Unfolded(usize),
    /// Sines of several angles are taken together more than once.
    #[error("sines are taken together in {0} places")]
    SinesApart(usize),
    /// A call runs a helper that is not there, or gives it other numbers than it needs.
    #[error("a call does not fit helper {0}")]
    Unfit(usize),
    /// A helper has helpers of its own.
    #[error("helper {0} has helpers of its own")]
    Nested(usize),
    /// A sign stands where it costs an operation.
    #[error("value {0} has a misplaced sign")]
    MisplacedSign(usize),
}

/// Checks that values are assigned once, before they are used, and are used; that nothing is left to fold; that signs
/// stand where they cost nothing; that sines of several angles are taken in one place; that calls fit their helpers, which have none
/// themselves; and that every number is finite.
///
/// # Errors
/// The first promise that is broken.
pub fn verify(program: &Program) -> Result<(), VerifyError> {
    for (place, helper) in program.helpers.iter().enumerate() {
        if !helper.program.helpers.is_empty() {
            return Err(VerifyError::Nested(place));
        }
        verify(&helper.program)?;
    }
    check_calls(program)?;
    let mut assigned: Vec<bool> = program
        .values
        .iter()
        .map(|value| matches!(value.definition, Definition::Input(_)))
        .collect();
    let mut used = vec![false; program.values.len()];
    let mut read = |operand: Operand, assigned: &[bool]| match operand {
        Operand::Number(number) if !number.is_finite() => Err(VerifyError::NotFinite),
        Operand::Number(_) => Ok(()),
        Operand::Value { id, .. } if assigned[id.index()] => {
            used[id.index()] = true;
            Ok(())
        }
        Operand::Value { id, .. } => Err(VerifyError::Unassigned(id.index())),
    };
    for instruction in &program.instructions {
        instruction
            .operands()
            .try_for_each(|operand| read(operand, &assigned))?;
        if let Instruction::Compute { result, operation } = instruction {
            check_operation(result.index(), *operation)?;
        }
        for result in instruction.results() {
            if std::mem::replace(&mut assigned[result.index()], true) {
                return Err(VerifyError::AssignedTwice(result.index()));
            }
        }
    }
    let is_array = |instruction: &&Instruction| match instruction {
        Instruction::SinCos { angles, .. } => angles.len() > 1,
        _ => false,
    };
    let n_arrays = program.instructions.iter().filter(is_array).count();
    if n_arrays > 1 {
        return Err(VerifyError::SinesApart(n_arrays));
    }
    program
        .stores
        .iter()
        .try_for_each(|&store| read(store, &assigned))?;
    used.iter()
        .position(|&used| !used)
        .map_or(Ok(()), |dead| Err(VerifyError::Dead(dead)))
}

/// Checks that what calls share is there before them, and that each gives its helper what that needs.
fn check_calls(program: &Program) -> Result<(), VerifyError> {
    let mut shared = BTreeMap::new();
    for instruction in &program.instructions {
        match instruction {
            Instruction::Share { lockstep, values } => {
                shared.insert(*lockstep, values.len());
            }
            Instruction::Call {
                lockstep,
                helper,
                sides,
                results,
            } => {
                let of = program.helpers.get(*helper);
                let of = of.ok_or(VerifyError::Unfit(*helper))?;
                let n_shared = shared.get(lockstep).copied().unwrap_or(0);
                let is_given = |input| match input {
                    Input::Shared(place) => place < of.n_shared,
                    Input::Side(place) => place < of.n_sides,
                    _ => false,
                };
                let mut inputs = of.program.values.iter().filter_map(ValueFacts::input);
                let has_lanes = |n: usize| n == of.lanes;
                let is_fit = inputs.all(is_given)
                    && [n_shared, sides.len()] == [of.n_shared, of.n_sides]
                    && results.len() == of.program.stores.len()
                    && sides.iter().map(Vec::len).all(has_lanes)
                    && results.iter().map(Vec::len).all(has_lanes);
                if !is_fit {
                    return Err(VerifyError::Unfit(*helper));
                }
            }
            Instruction::Compute { .. } | Instruction::SinCos { .. } => {}
        }
    }
    Ok(())
}

fn check_operation(result: usize, operation: Operation) -> Result<(), VerifyError> {
    if operation
        .operands()
        .all(|operand| operand.value().is_none())
    {
        return Err(VerifyError::Unfolded(result));
    }
    let allowed = match operation {
        Operation::Add(..) => [false, true, false],
        Operation::MulAdd(..) => [true, false, true],
        _ => [false; 3],
    };
    let misplaced = operation
        .operands()
        .zip(allowed)
        .any(|(operand, allowed)| operand.is_negative() && !allowed);
    if misplaced {
        Err(VerifyError::MisplacedSign(result))
    } else {
        Ok(())
    }
}
