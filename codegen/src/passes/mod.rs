//! From a graph to a graph with the same values: what folding and sharing at construction cannot see.
//!
//! In: a derived function. Out: the same roots with fewer operations, and parameters' own work taken out.
//! In order, which `compile::pipeline` keeps, with what holds afterwards:
//! 1. `factor`: no sum of a body's own terms has two products with a common factor that nothing else needs, nor two terms that are
//!    known before the loop.
//! 2. `angles`, in joined functions: no sine is taken of a short sum of angles whose sines are taken; or `sines`, where it is asked for: sines
//!    and cosines of coordinates are inputs.
//! 3. `hoist`: no operation of a function depends on parameters alone; those are `Prepared`'s.
//! 4. `branches`, where a function is long: what branches of the tree that are alike go through alike is written once.
//! 5. `reuse`: hardly a value equals another one, or the sum, difference or product of others, by more operations.
//!
//! Dead values, order and names are the program's: see `program`.

pub mod angles;
pub mod branches;
pub mod factor;
pub mod hoist;
pub mod reuse;
pub mod sines;
mod theorems;
