//! Values of parameters and coordinates that are drawn, for what is found or tested by numbers, and numbers in which zeros are exact.

mod field;
pub mod parameters;
mod quaternions;

pub use field::Field;
pub(crate) use quaternions::with_unit_quaternions;
