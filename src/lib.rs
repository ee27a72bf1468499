// Compiled code does not depend on the README, or its every change would compile all that calls this crate anew.
#![cfg_attr(
    all(any(doc, doctest), feature = "cart_pole"),
    doc = include_str!("../README.md")
)]
#![cfg_attr(
    not(all(any(doc, doctest), feature = "cart_pole")),
    doc = "Runtime of multibody systems compiled to flat Rust."
)]
#![no_std]

#[cfg(feature = "std")]
extern crate std;

// Generated text says `kane::Real`, here as in a user's crate.
extern crate self as kane;

// Each module imports only from those that stand before it.

// Sines and cosines, the same bits on every machine.
mod sin_cos;

// The scalar.
mod real;

// What the generated functions take and give.
mod array;
mod base_term;
pub mod block;
mod cost;
mod joint;
mod lanes;
mod load;

// A system as generic code sees it.
mod system;

// Its functions, a trait each.
pub mod functions;

// Sums of arrays.
mod vector;

// Coordinates as points of a manifold, which steps move.
pub mod manifold;

// What can be done with any system.
pub mod batch;
#[cfg(feature = "std")]
pub mod chart;
pub mod checked;
pub mod discrete;
pub mod integrate;
pub mod inverse_kinematics;
pub mod self_test;
#[cfg(feature = "simulate")]
pub mod simulate;
#[cfg(feature = "nalgebra")]
pub mod view;

// The bundled systems, one feature each.
/// A pole on a cart, with the pole's mass as a runtime parameter.
#[cfg(feature = "cart_pole")]
#[allow(
    clippy::pedantic,
    reason = "generated: nobody wrote these lines, and nobody will polish them"
)]
#[rustfmt::skip]
#[path = "../generated/cart_pole.rs"]
pub mod cart_pole;

/// The eight-body example of the notes: eight free bodies, 48 speeds, no gravity.
#[cfg(feature = "eight_body")]
#[allow(clippy::pedantic, reason = "generated: nobody wrote these lines, and nobody will polish them")]
#[rustfmt::skip]
#[path = "../generated/eight_body.rs"]
pub mod eight_body;

pub use array::Array;
pub use base_term::BaseTerm;
pub use block::Block;
pub use cost::Cost;
pub use joint::{Chart, Frame, Joint};
pub use lanes::Lanes;
pub use load::Load;
pub use real::Real;
pub use system::System;
/// The crate of vectors for which [`Lanes`] is implemented.
#[cfg(feature = "wide")]
pub use wide;
