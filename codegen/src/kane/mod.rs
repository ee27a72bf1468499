//! The notes' equations on partitions, literally: the meaning of every function, and the oracle for `recursive`.
//!
//! In: a [`Tree`](crate::tree::Tree). Out: expressions of one graph, one module a section of the notes.
//! Afterwards: every quantity is resolved in the frame that the notes name, and a zero partition was never built.
//! Does not: re-associate the sums over bodies; that is `recursive`.

pub mod angular;
pub mod center;
pub mod coriolis;
pub mod dynamics;
pub mod energy;
pub mod frame;
pub mod joint_wrench;
pub mod orientation;
pub mod position;
pub mod regressor;
pub mod velocity;
