//! Deriving: from a tree to programs, by meaning and by count.

mod chains;
mod compiled;
mod counts;
mod equivalences;
mod evaluator;
mod expr;
mod frame_identities;
mod frames;
mod fused;
mod hybrid;
mod identities;
mod multiply_add;
mod passes;
mod reference;
mod sines;
mod techniques;
