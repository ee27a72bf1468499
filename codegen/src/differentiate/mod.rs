//! How expressions change with what they are made of.
//!
//! In: a graph, roots, and for some inputs how they change with each of several variables. Out: for each root how it changes
//! with these, as expressions of the same graph. Does not: choose between its two ways, nor know what a variable is.
//!
//! [`forward`] carries the changes of every node from the inputs to the roots; [`reverse`] carries from each root to the inputs
//! by how much it changes with every node. Both give the same values, with other operations: which are fewer is counted.
//! [`tangents`] is the first with numbers in the place of expressions.

mod forward;
mod partials;
mod reverse;
mod row;
mod tangents;

pub use forward::forward;
pub use reverse::reverse;
pub use row::{Row, Seeds};
pub use tangents::tangents;
