//! What the functions of any system must have to do with one another.
//!
//! In: a [`Model`], a system whose functions can be evaluated, in whatever way, and a [`State`]. Out: the relative error by
//! which an identity of mechanics is broken there. The generator's tests evaluate programs, `tests/systems` compiled text.

pub mod acting;
pub mod agreement;
pub mod composition;
pub mod energies;
pub mod forces;
pub mod kinematics;
mod list;
pub mod model;
pub mod numbering;
pub mod quantities;
mod rates;
mod solids;
pub mod state;
pub mod topology;

pub use model::Model;
pub use state::State;
