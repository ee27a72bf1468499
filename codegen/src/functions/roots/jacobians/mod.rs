//! Derivatives that have a way of their own, a matrix for each variable.

pub(in crate::functions) mod acceleration;
pub(in crate::functions) mod accelerations;
mod bias;
mod carrying;
pub(in crate::functions) mod columns;
pub(in crate::functions) mod forces;
pub(in crate::functions) mod frames;
pub(in crate::functions) mod hybrid;
pub(in crate::functions) mod linear;
mod moving;
pub(in crate::functions) mod totals;
mod turned;
pub(in crate::functions) mod velocity;
