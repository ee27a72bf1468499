//! Runtime for robot and multibody dynamics generated as plain Rust.
//!
//! The command `kane` of the package `kane-codegen` reads a model in URDF, MJCF or TOML and writes a Rust module: one function for the mass
//! matrix, one for inverse dynamics, and so on. The functions have no branch, allocation or panic. This crate holds what such a module needs,
//! and tools to use it: integration, batches of states, inverse kinematics, derivatives of a controller's steps.
//!
//! # A control loop
//!
//! ```sh
//! kane generate cart_pole.toml --output src/cart_pole.rs
//! ```
//!
//! ```
//! # mod cart_pole { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/generated/cart_pole.rs")); }
//! # fn main() {
//! // At the top of your crate: #[rustfmt::skip] mod cart_pole;
//! use cart_pole::{NQ, NU, Parameters, Prepared};
//! use kane::integrate::rk4_step;
//!
//! let parameters = Parameters { pole_mass: 0.55 }; // measured today
//! let system = Prepared::<f64>::new(&parameters);  // once, outside the loop
//!
//! let (mut q, mut u): ([f64; NQ], [f64; NU]) = ([0.0, 0.1], [0.0; NU]);
//! for _ in 0..10_000 {
//!     // The motor moves the cart alone, toward the side to which the pole falls.
//!     let tau = [60.0 * q[1] + 12.0 * u[1] + 4.0 * q[0] + 6.0 * u[0], 0.0];
//!     rk4_step(&system, &tau, 1e-3, &mut q, &mut u); // the simulated plant
//! }
//! assert!(q[0].abs() < 0.01 && q[1].abs() < 0.01, "the pole stands, the cart is home");
//! # }
//! ```
//!
//! This loop needs no feature: with `default-features = false` the crate is `no_std` and has no dependencies.
//!
//! # Where to look
//!
//! | you want to know | look at |
//! | --- | --- |
//! | what a function computes, with shapes, units and axes | [`functions`]: a trait for each |
//! | units, frames, rotations, signs, order of coordinates | [`conventions`] |
//! | the sizes and names of a system, in generic code | [`System`] |
//! | the available scalars | [`Real`] |
//! | how to integrate | [`integrate`], the module `simulate` to a tolerance, [`discrete`] with derivatives or exactly on quaternions |
//! | how to check a state before you solve | [`checked`] |
//! | the same numbers as vectors and matrices of nalgebra | the module `view` |
//! | which columns a compact output has | [`block`] |
//! | how to set parameters, or to read them as an array | [`Parametric`] |
//! | how to convert states between angles and quaternions | the module `chart` |
//! | how many operations a function needs | [`Cost`] |
//! | how to compute many states at once | [`batch`], [`Lanes`] |
//! | how to find coordinates for given poses | [`inverse_kinematics`] |
//! | the place of a name in `q`, `u` or the bodies | [`place`] |
//! | the orientation error of a controller, rotation vectors for costs of poses | [`rotation`] |
//! | discrete steps with their derivatives, for regulators and planners | [`discrete`], [`manifold`] |
//! | steps under a push, or with joints that something drives | [`conditions`] |
//! | the tests that `kane generate --with-tests` writes | [`self_test`] |
//!
//! # Features
//!
//! | feature | default | what it adds |
//! | --- | --- | --- |
//! | `std` | yes | conversion between angles and quaternions (the module `chart`), fused multiply-add if a module uses it |
//! | `nalgebra` | yes | views of arrays as nalgebra matrices |
//! | `eight_body` | yes | a bundled system: eight free bodies |
//! | `cart_pole` | | a bundled system: a pole on a cart |
//! | `wide` | | vectors of the crate `wide` as scalars |
//! | `simulate` | | integration with adaptive steps |

#![no_std]

#[cfg(feature = "std")]
extern crate std;

// Generated text says `kane::Real`, here as in a user's crate.
extern crate self as kane;

// Each module imports only from those that stand before it.

// Sines and cosines, the same bits on every machine.
mod sin_cos;

// The scalar, and what `core` lacks of it.
mod real;
mod square_root;
mod three;

// What the generated functions take and give.
mod array;
mod base_term;
pub mod block;
mod cost;
mod joint;
mod lanes;
mod load;
mod place;
mod store;

// A system as generic code sees it.
mod system;

// Its values that are set at run time.
mod parametric;

// Its functions, a trait each.
pub mod functions;

// Sums of arrays.
mod vector;

// Coordinates as points of a manifold, which steps move.
pub mod manifold;

// How far one orientation is from another.
pub mod rotation;

// What can be done with any system.
pub mod batch;
#[cfg(feature = "std")]
pub mod chart;
pub mod checked;
pub mod conditions;
pub mod discrete;
pub mod integrate;
pub mod inverse_kinematics;
pub mod self_test;
#[cfg(feature = "simulate")]
pub mod simulate;
#[cfg(feature = "nalgebra")]
pub mod view;

// What the words of the documentation mean: text alone. The first of two definitions of a link counts, so that the page's own link to a file is not
// taken here.
#[cfg(doc)]
#[doc = "[figures]: #figures"]
#[doc = ""]
#[doc = include_str!("../docs/conventions.md")]
#[doc = "\n# Figures\n\nAttachment, translation, mass centre:\n"]
#[doc = include_str!("../docs/pictures/attachment.svg")]
#[doc = "\nThe three angles:\n"]
#[doc = include_str!("../docs/pictures/rotation.svg")]
#[doc = "\nComponents of a vector along the axes of two bodies:\n"]
#[doc = include_str!("../docs/pictures/matrix.svg")]
pub mod conventions {}

// The code of pages, compiled and run as tests of this documentation. Compiled code does not depend on them, or their every change would
// compile all that calls this crate anew.
#[cfg(all(
    doctest,
    feature = "cart_pole",
    feature = "eight_body",
    feature = "wide"
))]
mod pages {
    #[doc = include_str!("../README.md")]
    mod readme {}
    #[doc = include_str!("../docs/start.md")]
    mod start {}
}

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

/// Eight free bodies, 48 speeds, no gravity: the example in the lecture notes behind the equations.
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
pub use parametric::Parametric;
pub use place::place;
pub use real::Real;
pub use store::store;
pub use system::System;
/// The SIMD crate whose vectors implement [`Lanes`].
#[cfg(feature = "wide")]
pub use wide;
