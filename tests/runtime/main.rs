//! The runtime: the scalar and its lanes, batches, integration, motions on manifolds, inverse kinematics, checks, charts, rotations, and the traits of systems.

#[cfg(feature = "eight_body")]
mod batch;
#[cfg(feature = "std")]
mod chart;
mod checked;
mod common;
mod conditions;
mod integrate;
mod inverse_kinematics;
#[cfg(feature = "wide")]
mod lanes;
mod manifold;
#[cfg(feature = "eight_body")]
mod operators;
mod real;
mod rotation;
mod self_test;
#[cfg(feature = "simulate")]
mod simulate;
mod system;
