//! Optimal control and estimation by generated derivatives.
//!
//! | module | |
//! | --- | --- |
//! | [`swing_up`] | a cart swings its pole up with a weak motor |
//! | [`reach`] | a Panda carries a payload to a point, as fast as its drives allow |
//! | [`formation`] | eight free bodies are held by one linear-quadratic regulator |
//! | [`payload`] | a Panda weighs what it holds |
//! | [`predictive`] | a Panda plans anew each millisecond |
//!
//! They stand on [`ilqr`], trajectories with limits, which asks [`bounded_quadratic`] for each step; on [`riccati`], regulators; and
//! on [`arm`], what reaching is.
//!
//! `cargo run --release --package kane-optimal`

pub mod arm;
pub mod bounded_quadratic;
pub mod formation;
pub mod ilqr;
pub mod payload;
pub mod predictive;
pub mod reach;
pub mod riccati;
pub mod swing_up;

#[path = "../../common/noise.rs"]
mod noise;

pub use noise::Noise;

macro_rules! systems {
    ($($(#[$meaning:meta])* $name:ident)+) => {$(
        $(#[$meaning])*
        #[allow(clippy::pedantic, reason = "generated: nobody wrote these lines, and nobody will polish them")]
        pub mod $name {
            include!(concat!(env!("OUT_DIR"), "/", stringify!($name), ".rs"));
        }
    )+};
}

systems! {
    /// A pole on a cart.
    cart_pole
    /// A Panda with a payload whose mass and mass centre are set at run time.
    panda
    /// The eight free bodies of the notes.
    eight_body
    /// A free body with a quaternion, and on it joints with speeds of every kind: for tests.
    tumbler
}
