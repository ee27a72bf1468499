//! The flat program: straight-line code with one assignment a value.
//!
//! In: a graph and its roots. Out: a [`Program`]. Afterwards: every value is assigned once, before it is used, and is
//! used; no operation has only numbers for operands; every number is finite; every output is stored once.
//! Does not: choose what to compute. The order is that of the derivation, from body to body; only the sines and cosines
//! of all angles stand together before the rest.

mod cost;
mod evaluate;
mod flatten;
mod fuse;
mod verify;

pub use cost::Operations;
pub use flatten::flatten;
pub use fuse::fuse;
pub use verify::{VerifyError, verify};

use crate::{
    expr::{Input, Purpose},
    id::BodyId,
};

/// A value: what an instruction assigns, or an input.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct ValueId(u32);

/// Straight-line code.
#[derive(Clone, Debug)]
pub struct Program {
    /// The values, by id.
    pub values: Vec<ValueFacts>,
    /// What is computed, in order.
    pub instructions: Vec<Instruction>,
    /// What is stored, row-major; where the stores stand in the text is the listing's choice.
    pub stores: Vec<Operand>,
    /// What calls run on several columns.
    pub helpers: Vec<Helper>,
}

/// What a call runs on several columns.
#[derive(Clone, Debug)]
pub struct Helper {
    /// On how many.
    pub lanes: usize,
    /// How many numbers it is given that they share.
    pub n_shared: usize,
    /// How many it is given of each.
    pub n_sides: usize,
    /// What it does to one: it stores what it computes, and calls nothing.
    pub program: Program,
}

/// What is known of a value.
#[derive(Clone, Debug)]
pub struct ValueFacts {
    /// Where it comes from.
    pub definition: Definition,
    /// The body that it belongs to.
    pub scope: Option<BodyId>,
    /// What it is for.
    pub purpose: Purpose,
    /// The quantity and component, where a reader would know them.
    pub label: Option<String>,
}

impl ValueFacts {
    /// What the function is given, where it is that.
    pub fn input(&self) -> Option<Input> {
        match self.definition {
            Definition::Input(input) => Some(input),
            Definition::Instruction => None,
        }
    }
}

/// Where a value comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Definition {
    /// The function is given it.
    Input(Input),
    /// An instruction assigns it.
    Instruction,
}

/// One step of the program.
#[derive(Clone, Debug)]
pub enum Instruction {
    /// One operation.
    Compute {
        /// The value that is assigned.
        result: ValueId,
        /// The operation.
        operation: Operation,
    },
    /// Sines and cosines of several angles together, so that they vectorise: only the first of a program's has more than
    /// one angle.
    SinCos {
        /// The angles.
        angles: Vec<Operand>,
        /// The sine of each, where it is used.
        sines: Vec<Option<ValueId>>,
        /// The cosine of each, where it is used.
        cosines: Vec<Option<ValueId>>,
    },
    /// What several calls are given alike.
    Share {
        /// The number of these calls.
        lockstep: usize,
        /// What they are given, by place.
        values: Vec<Operand>,
    },
    /// A helper is run on several columns.
    Call {
        /// By which number it is given what calls share.
        lockstep: usize,
        /// Which of the program's helpers.
        helper: usize,
        /// For each number that it is given of a column, that of each lane.
        sides: Vec<Vec<Operand>>,
        /// For each number that it computes, that of each lane, where it is used.
        results: Vec<Vec<Option<ValueId>>>,
    },
}

/// An operation on one to three operands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Operation {
    /// `a + b`; the first is not a value's negative.
    Add(Operand, Operand),
    /// `a b`; neither is a value's negative.
    Mul(Operand, Operand),
    /// `a b + c`, rounded once; `b` is not a value's negative. Only where fused multiply-add is asked for.
    MulAdd(Operand, Operand, Operand),
    /// `a / b`; neither is a value's negative.
    Div(Operand, Operand),
    /// `|a|`; not negative.
    Abs(Operand),
    /// `-a`, for a value whose name means its negative; not negative.
    Neg(Operand),
}

/// A number or a value, with a sign.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Operand {
    /// A number.
    Number(f64),
    /// A value or its negative.
    Value {
        /// The value.
        id: ValueId,
        /// True for its negative.
        negative: bool,
    },
}

impl ValueId {
    /// The index in [`Program::values`].
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

impl Program {
    /// How often each value is used.
    pub(crate) fn uses(&self) -> Vec<usize> {
        let mut uses = vec![0; self.values.len()];
        let operands = self.instructions.iter().flat_map(Instruction::operands);
        let operands = operands.chain(self.stores.iter().copied());
        for id in operands.filter_map(Operand::value) {
            uses[id.index()] += 1;
        }
        uses
    }

    /// The value with this id.
    pub fn value(&self, id: ValueId) -> &ValueFacts {
        &self.values[id.index()]
    }
}

impl Operation {
    /// The operands.
    pub fn operands(self) -> impl Iterator<Item = Operand> {
        let operands = match self {
            Self::MulAdd(a, b, c) => [Some(a), Some(b), Some(c)],
            Self::Add(a, b) | Self::Mul(a, b) | Self::Div(a, b) => [Some(a), Some(b), None],
            Self::Abs(a) | Self::Neg(a) => [Some(a), None, None],
        };
        operands.into_iter().flatten()
    }

    /// The operands, to be changed.
    fn operands_mut(&mut self) -> impl Iterator<Item = &mut Operand> {
        let operands = match self {
            Self::MulAdd(a, b, c) => [Some(a), Some(b), Some(c)],
            Self::Add(a, b) | Self::Mul(a, b) | Self::Div(a, b) => [Some(a), Some(b), None],
            Self::Abs(a) | Self::Neg(a) => [Some(a), None, None],
        };
        operands.into_iter().flatten()
    }
}

impl Instruction {
    /// The values that are assigned.
    pub fn results(&self) -> impl Iterator<Item = ValueId> + '_ {
        let (one, sines, cosines): (_, &[_], &[_]) = match self {
            Self::Compute { result, .. } => (Some(*result), &[], &[]),
            Self::SinCos { sines, cosines, .. } => (None, sines, cosines),
            Self::Share { .. } | Self::Call { .. } => (None, &[], &[]),
        };
        let of_call: &[Vec<_>] = match self {
            Self::Call { results, .. } => results,
            _ => &[],
        };
        let several = sines.iter().chain(cosines).chain(of_call.iter().flatten());
        one.into_iter().chain(several.flatten().copied())
    }

    /// The operands.
    pub fn operands(&self) -> impl Iterator<Item = Operand> + '_ {
        let (operation, angles): (_, &[_]) = match self {
            Self::Compute { operation, .. } => (Some(*operation), &[]),
            Self::SinCos { angles, .. } => (None, angles),
            Self::Share { values, .. } => (None, values),
            Self::Call { .. } => (None, &[]),
        };
        let of_call: &[Vec<_>] = match self {
            Self::Call { sides, .. } => sides,
            _ => &[],
        };
        let own = operation.into_iter().flat_map(Operation::operands);
        own.chain(angles.iter().chain(of_call.iter().flatten()).copied())
    }
}

impl Operand {
    /// The value; `None` for a number.
    pub fn value(self) -> Option<ValueId> {
        match self {
            Self::Value { id, .. } => Some(id),
            Self::Number(_) => None,
        }
    }

    /// True for the negative of a value; a number holds its own sign.
    pub fn is_negative(self) -> bool {
        matches!(self, Self::Value { negative: true, .. })
    }
}

impl std::ops::Neg for Operand {
    type Output = Self;

    fn neg(self) -> Self {
        match self {
            // Zero has one sign.
            Self::Number(number) => Self::Number(if number == 0.0 { 0.0 } else { -number }),
            Self::Value { id, negative } => Self::Value {
                id,
                negative: !negative,
            },
        }
    }
}
