//! Deriving: from a tree to programs, by meaning and by count.

mod base_parameters;
mod chains;
mod compiled;
mod counts;
mod derivative_references;
mod derivatives;
mod equivalences;
mod evaluator;
mod expr;
mod frame_identities;
mod frame_references;
mod frames;
mod fused;
mod hessians;
mod hybrid;
mod identities;
mod multiply_add;
mod passes;
mod products;
mod reference;
mod sines;
mod sparsity;
mod techniques;
