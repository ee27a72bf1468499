//! Runtime of `kane`: what generated systems are written in, and what can be done with them.
//!
//! A generated module holds one straight-line function per quantity. This crate gives it its scalar
//! ([`Real`]), its loads ([`Load`]) and its face to generic code ([`System`] and the traits in
//! [`functions`]); and it integrates, checks and simulates any of them.
//!
//! No allocation (except under `simulate`), no `unsafe`, and no `std` without the feature of that name.

#![no_std]

#[cfg(feature = "std")]
extern crate std;

// Generated text says `kane::Real`, here as in a user's crate.
extern crate self as kane;

// The scalar, and what the generated functions take and give.
mod array;
pub mod block;
mod load;
mod real;
mod sin_cos;

// A system as generic code sees it.
pub mod functions;
mod system;

// What can be done with any system.
pub mod checked;
pub mod integrate;
#[cfg(feature = "simulate")]
pub mod simulate;
#[cfg(feature = "nalgebra")]
pub mod view;

// The bundled systems, one feature each.
/// The eight-body example of the notes: eight free bodies, 48 speeds, no gravity.
#[cfg(feature = "eight_body")]
#[allow(clippy::pedantic, reason = "generated: nobody wrote these lines, and nobody will polish them")]
#[rustfmt::skip]
#[path = "../generated/eight_body.rs"]
pub mod eight_body;

pub use array::Array;
pub use block::Block;
pub use load::Load;
pub use real::Real;
pub use system::System;
