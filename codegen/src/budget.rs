//! Budgets: how many operations a function may need.
//!
//! In: limits, and functions with their operations. Out: what goes beyond its limit. Does not: decide what follows from that.

use crate::{choices::name_of, program::Operations};

/// A limit of one function's operations.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Budget {
    /// The generated function's name; of a function of a frame what is asked for, `pose(tool0)`.
    pub function: String,
    /// Which operations.
    pub kind: OperationKind,
    /// How many there may be.
    pub limit: usize,
}

/// Which operations are limited.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OperationKind {
    /// All.
    Total,
    /// Multiplications.
    Mul,
    /// Additions and subtractions.
    Add,
    /// Divisions.
    Div,
    /// Sines and cosines.
    Trig,
}

impl OperationKind {
    /// All of them, with the names that they have in `kane.toml`.
    pub const ALL: [(&str, Self); 5] = [
        ("total", Self::Total),
        ("mul", Self::Mul),
        ("add", Self::Add),
        ("div", Self::Div),
        ("trig", Self::Trig),
    ];

    /// Their number.
    pub fn of(self, operations: Operations) -> usize {
        match self {
            Self::Total => operations.total(),
            Self::Mul => operations.mul,
            Self::Add => operations.add,
            Self::Div => operations.div,
            Self::Trig => operations.trig,
        }
    }

    /// Its name in `kane.toml`.
    pub fn name(self) -> &'static str {
        name_of(&self, &Self::ALL)
    }
}

/// A function that goes beyond its budget.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Excess<'a> {
    /// The limit.
    pub budget: &'a Budget,
    /// How many operations there are.
    pub count: usize,
}

/// What goes beyond its limit, in the order of the budgets. A limit of a function that is not there is kept by it.
pub fn exceeded<'a>(budgets: &'a [Budget], functions: &[(String, Operations)]) -> Vec<Excess<'a>> {
    let excess = |budget: &'a Budget| {
        let mut functions = functions.iter();
        let (_, operations) = functions.find(|(name, _)| *name == budget.function)?;
        let count = budget.kind.of(*operations);
        (count > budget.limit).then_some(Excess { budget, count })
    };
    budgets.iter().filter_map(excess).collect()
}
