//! What the outputs of a function are multiplied by, entry by entry, before their sum is differentiated.
//!
//! In: an output, and its place among the function's. Out: a [`Multiplier`], an array like the output.

use super::shape::{Length, Shape};
use crate::tree::Tree;

/// The multiplier of an output.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Multiplier {
    /// The place of the output among its function's.
    place: usize,
    name: &'static str,
    shape: Shape,
    /// The length of the dimensions that the function decides.
    own_length: usize,
}

/// What it is called where the output is the only one.
pub(super) const MULTIPLIER: &str = "multiplier";

/// The constants that hold samples, by shapes that many outputs have.
const SAMPLED: [(Shape, &str); 4] = [
    (Shape::VECTOR, "VECTOR_MULTIPLIERS"),
    (Shape::COORDINATES, "COORDINATE_MULTIPLIERS"),
    (Shape::SPEEDS, "SPEED_MULTIPLIERS"),
    (Shape::SPEED_MATRIX, "MATRIX_MULTIPLIERS"),
];

impl Multiplier {
    /// One with this name, of the output at a place with this shape; `own_length` is that of dimensions that the function decides.
    pub(super) fn of(place: usize, name: &'static str, shape: Shape, own_length: usize) -> Self {
        Self {
            place,
            name,
            shape,
            own_length,
        }
    }

    /// The place of the output among its function's.
    pub(super) fn place(self) -> usize {
        self.place
    }

    /// The name in generated code.
    pub(super) fn name(self) -> &'static str {
        self.name
    }

    /// The array.
    pub(super) fn shape(self) -> Shape {
        self.shape
    }

    /// What it means, in words.
    pub(super) fn meaning(self) -> &'static str {
        if self.name == MULTIPLIER {
            "multiplies the output, entry by entry, before the sum is differentiated"
        } else {
            "multiplies its output, entry by entry, before the sum of all outputs is differentiated"
        }
    }

    /// The constant that holds its samples: no two arrays with different names or types have the same.
    pub(super) fn sampled(self) -> String {
        let mut known = SAMPLED.iter();
        if let Some((_, constant)) =
            known.find(|(shape, _)| self.name == MULTIPLIER && *shape == self.shape)
        {
            return (*constant).to_owned();
        }
        let lengths = self.declared().into_iter().map(|length| match length {
            Length::Number(number) => format!("_{number}"),
            Length::Constant(name) => format!("_{name}"),
            Length::Twice(name) => format!("_2_{name}"),
        });
        let lengths: String = lengths.collect();
        format!("{}S{lengths}", self.name.to_uppercase())
    }

    /// The lengths of its nested arrays, outermost first.
    pub(super) fn lengths(self, tree: &Tree) -> Vec<usize> {
        self.shape.lengths(tree, |_| self.own_length)
    }

    /// The same as generated code names them.
    pub(super) fn declared(self) -> Vec<Length> {
        self.shape.declared(|_| Length::Number(self.own_length))
    }
}
