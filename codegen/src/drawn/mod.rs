//! Values of parameters and coordinates that are drawn, for what is found or tested by numbers.

pub mod parameters;
mod quaternions;

pub(crate) use quaternions::with_unit_quaternions;
