//! Derivatives of functions of frames, from the columns of their Jacobians.
//!
//! A motion on the way to a frame carries the axes of those after it (`super::carrying`), and what these add to the frame's velocity and acceleration
//! (`moving`).

pub(in crate::functions) mod acceleration;
pub(in crate::functions) mod columns;
pub(in crate::functions) mod imu;
pub(in crate::functions) mod linear;
mod moving;
pub(in crate::functions) mod pose;
pub(in crate::functions) mod velocity;
