//! Derivatives of dynamics in a way of their own, a matrix for each variable.

pub(in crate::functions) mod accelerations;
pub(in crate::functions) mod forces;
pub(in crate::functions) mod hybrid;
