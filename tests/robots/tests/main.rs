//! Robots, compiled, against other software and against one another.

mod changes;
mod charts;
mod common;
#[cfg(every_system)]
mod derivatives;
mod frames;
mod hybrid;
mod joined;
mod lanes;
mod matrices;
mod mujoco;
mod multiply_add;
mod pinocchio;
mod single;
mod systems;
