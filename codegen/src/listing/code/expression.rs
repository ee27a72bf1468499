//! What a statement computes, as a tree.

use super::{ArrayId, Entry, LocalId};

/// A number, or operations on numbers. The order of evaluation is that of the tree: no printer re-associates.
#[derive(Clone, Debug, PartialEq)]
pub enum Expression {
    /// A finite number of the model.
    Number(f64),
    /// A local.
    Local(LocalId),
    /// An element of a local array.
    Element(ArrayId, usize),
    /// What stands in an argument.
    Entry(Entry),
    /// What an earlier stage keeps: the stage, and the place among what it keeps.
    Kept(usize, usize),
    /// `-a`.
    Negative(Box<Expression>),
    /// `|a|`.
    Absolute(Box<Expression>),
    /// `a + b`.
    Sum(Box<[Expression; 2]>),
    /// `a - b`.
    Difference(Box<[Expression; 2]>),
    /// `a b`.
    Product(Box<[Expression; 2]>),
    /// `a / b`.
    Quotient(Box<[Expression; 2]>),
    /// `a b + c`, rounded once.
    Fused(Box<[Expression; 3]>),
}

/// How tightly what is written with signs between operands holds together, loosest first; the same in every language that
/// writes them so.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Tightness {
    /// Sums and differences.
    Sum,
    /// Products and quotients.
    Product,
    /// All that is one piece.
    Whole,
}

impl Expression {
    /// How tightly it holds together.
    pub fn tightness(&self) -> Tightness {
        match self {
            Self::Sum(_) | Self::Difference(_) => Tightness::Sum,
            Self::Product(_) | Self::Quotient(_) => Tightness::Product,
            Self::Number(_)
            | Self::Local(_)
            | Self::Element(..)
            | Self::Entry(_)
            | Self::Kept(..)
            | Self::Negative(_)
            | Self::Absolute(_)
            | Self::Fused(_) => Tightness::Whole,
        }
    }

    /// What it is made of, in the order of evaluation.
    pub fn operands(&self) -> &[Expression] {
        match self {
            Self::Number(_)
            | Self::Local(_)
            | Self::Element(..)
            | Self::Entry(_)
            | Self::Kept(..) => &[],
            Self::Negative(a) | Self::Absolute(a) => std::slice::from_ref(a),
            Self::Sum(both)
            | Self::Difference(both)
            | Self::Product(both)
            | Self::Quotient(both) => both.as_slice(),
            Self::Fused(all) => all.as_slice(),
        }
    }
}
