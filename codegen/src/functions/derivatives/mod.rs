//! Derivatives of functions: what can be asked for, which outputs and patterns that has, and whether a function has a way of its
//! own for it or is swept for.

pub(super) mod coloring;
pub(super) mod derivative;
pub(super) mod derivative_trait;
pub(super) mod matrices;
mod second;
pub(super) mod solved;
pub(super) mod sparsity;
