//! Derivatives of expressions by their inputs.
//!
//! In: a graph, roots, and for some inputs how they change with each of several variables. Out: for each root how it changes
//! with these, as expressions of the same graph. Does not: choose between its two ways, nor know what a variable is.
//!
//! [`forward`] goes from the inputs to the roots and computes how every node changes with the variables. [`reverse`] goes from
//! each root to the inputs and computes how the root changes with every node. Both give the same values by different operations;
//! the compiler counts which needs fewer. [`tangents`] is [`forward`] with numbers instead of expressions.
//!
//! Both read off what changes like a component beside it (`turned`); [`reverse`] also what an angle changes by of its sine and
//! cosine (`entries`), and has twice what changes with squares (`squares`).

mod entries;
mod forward;
mod partials;
mod reverse;
mod row;
mod squares;
mod sweep;
mod tangents;
mod turned;

pub use forward::forward;
pub use reverse::reverse;
pub use row::{Row, Seeds};
pub use sweep::Sweep;
pub use tangents::tangents;
