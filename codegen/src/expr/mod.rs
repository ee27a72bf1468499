//! Scalar expressions: a hash-consed graph that simplifies as it is built.
//!
//! In: calls that add, multiply, divide, take sines. Out: [`Expr`]s of one [`ExprGraph`].
//! Afterwards: equal expressions are one node; no operation has only numbers for operands, no operand is a
//! zero or a one that could be left out, and signs stand on references, never in nodes of their own.
//! Does not: reorder sums, distribute products, or know mechanics: of bodies it knows nothing but their numbers. Inputs carry them, and they are
//! the order of scopes: the greater one is further out.

mod calls;
mod copy;
mod dump;
mod evaluate;
mod graph;
mod lockstep;
mod lookup;
mod needed;
mod node;
mod nodes;
mod outline;
mod purpose;
mod rebuilt;
mod shared;
mod vector;

pub(crate) use evaluate::signed;
pub use graph::ExprGraph;
pub use lockstep::{Call, Helper, LANES, Lockstep};
pub use node::{Binding, CallId, CallResult, Expr, Input, Label, Node, NodeId, SINE};
pub use purpose::Purpose;
pub(crate) use rebuilt::Rebuilt;
pub use shared::Shared;
pub use vector::{Axis, Matrix, Symmetric, Vector, negated, transpose};
