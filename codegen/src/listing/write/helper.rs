//! What a function runs on several columns: a function of one column, of which nobody else knows.

use super::InputPlaces;
use crate::listing::{Code, Function, Stage, Step};
use crate::{
    expr::Input,
    functions::Signature,
    program::{Instruction, Program, ValueFacts},
};

/// Its argument that all columns share.
pub const SHARED: &str = "shared";
/// Its argument that is of one column.
pub const SIDES: &str = "sides";
/// What it computes of one column.
pub const SOLVED: &str = "solved";

/// How the helper of a function at this place is declared, for one column.
pub(super) fn signature(function: &str, program: &Program, place: usize) -> Signature {
    let (n_shared, n_sides) = given(program, place);
    let n_solved = program.helpers[place].stores.len();
    Signature::helper(
        function,
        (place + 1, program.helpers[place].lanes),
        [(SHARED, n_shared), (SIDES, n_sides)],
        (SOLVED, n_solved),
    )
}

/// How many numbers a helper is given that columns share, and how many of a column.
fn given(program: &Program, place: usize) -> (usize, usize) {
    let mut instructions = program.instructions.iter();
    let call = instructions.find_map(|instruction| match instruction {
        Instruction::Call {
            lockstep,
            helper,
            sides,
            ..
        } if *helper == place => Some((*lockstep, sides.len())),
        _ => None,
    });
    let (number, n_sides) =
        call.unwrap_or_else(|| unreachable!("listing: helper {place} is not called"));
    let mut instructions = program.instructions.iter();
    let n_shared = instructions.find_map(|instruction| match instruction {
        Instruction::Share { lockstep, values } if *lockstep == number => Some(values.len()),
        _ => None,
    });
    (n_shared.unwrap_or_default(), n_sides)
}

/// Where a helper finds what it is given.
pub(super) fn entries(signature: &Signature, program: &Program) -> InputPlaces {
    let inputs = program.values.iter().filter_map(ValueFacts::input);
    let entries = inputs.map(|input| {
        let (name, place) = match input {
            Input::Shared(place) => (SHARED, place),
            Input::Side(place) => (SIDES, place),
            other => unreachable!("listing: {} is not given {other:?}", signature.name),
        };
        (input, (name, vec![Step::Index(place)]))
    });
    entries.collect()
}

impl Function {
    /// A helper, with its loops where it has several.
    pub(super) fn helper(
        signature: Signature,
        program: &Program,
        code: Code,
        loops: Vec<Stage>,
    ) -> Self {
        Self {
            fused: program.fused(),
            lanes: program.lanes,
            stages: loops,
            ..Self::plain(signature, program.operations(), code)
        }
    }
}
