//! Where a frame is, how it moves, and what moves it: joint by joint along its path alone.
//!
//! In: a tree, a plan, a frame that has a name. Out: expressions equal to those of [`kane::frame`](crate::kane::frame), by walks
//! of passengers: what is wanted as it is seen from somewhere is walked there, so that no rotation of a body is needed beside.

mod between;
mod columns;
mod force;
mod jacobian;
mod levers;
mod motion;
mod own;
mod pose;
mod reach;
mod steps;

pub use force::{generalized_force, local_generalized_force};
pub use jacobian::{along_frame, jacobian, local_jacobian};
pub use motion::{acceleration, imu, local_acceleration, local_velocity, velocity};
pub use pose::pose;
