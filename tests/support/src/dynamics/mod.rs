//! What the functions of any system must have to do with one another.
//!
//! In: a [`Model`], a system whose functions can be evaluated, in whatever way, and a [`State`]. Out: the relative error by
//! which an identity of mechanics is broken there. The generator's tests evaluate programs, `tests/systems` compiled text.

pub mod acting;
pub mod agreement;
pub mod center;
pub mod composition;
pub mod coriolis;
pub mod energies;
pub mod forces;
pub mod hybrid;
pub mod kinematics;
mod list;
pub mod loaded;
pub mod model;
pub mod numbering;
pub mod operators;
pub mod quantities;
mod rates;
pub mod regressor;
mod solids;
pub mod state;
pub mod topology;

pub use model::Model;
pub use state::State;
