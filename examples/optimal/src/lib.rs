//! Optimal control and estimation by generated derivatives.

pub mod arm;
pub mod formation;
pub mod ilqr;
pub mod limits;
pub mod payload;
pub mod predictive;
pub mod reach;
pub mod riccati;
pub mod swing_up;

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
