//! Derivatives that have a way of their own, a matrix for each variable.

pub(in crate::functions) mod accelerations;
mod bias;
mod carrying;
pub(in crate::functions) mod center;
pub(in crate::functions) mod forces;
pub(in crate::functions) mod frames;
pub(in crate::functions) mod hybrid;
pub(in crate::functions) mod momentum;
mod swept;
pub(in crate::functions) mod totals;
mod turned;
