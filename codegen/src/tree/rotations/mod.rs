//! The constant rotations and axes of a description: made orthonormal, and exact where they are nearly so.

mod alignment;
mod exact;
mod orthonormal;
mod snap;

pub(crate) use exact::{ConstantRotations, exact};
pub(crate) use orthonormal::orthonormal;
pub(crate) use snap::snapped;
pub use snap::snapped_sin_cos;
