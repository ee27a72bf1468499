//! One system, described in two ways: other charts and speeds, frames turned on both sides of a joint, bodies that are fixed
//! merged by hand, joints that follow others projected out by hand. On random trees, through the programs that would be
//! emitted.
//!
//! Where the speeds of the one are `T` times those of the other, `u_b = T u_a`, so are its partial velocities, and its mass
//! matrix and forces are projected: `M_a = T^T M_b T`, `tau_a = T^T tau_b`.
#![allow(
    clippy::print_stdout,
    reason = "the largest errors found, shown with --nocapture"
)]

mod by_hand;
mod charts;
mod pair;
mod turned;
