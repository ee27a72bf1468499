//! The constant rotations and axes of a description: made orthonormal, and exact where they are nearly so.

mod alignment;
mod exact;
mod near;
mod orthonormal;
mod snap;

pub use alignment::Alignment;
pub(crate) use exact::{ConstantRotations, Snapped, exact};
pub use near::{NearlyExact, nearly_exact};
pub use orthonormal::orthonormal;
pub use snap::{snapped, snapped_sin_cos};
