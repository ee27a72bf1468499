//! Identification: a UR5 and a Panda learn their inertial parameters and their friction from measured torques.
//!
//! Torques are linear in the base parameters and in the drives' coefficients, `τ = Y_b β + Y_j κ`: `base_regressor` and
//! `joint_regressor` are `Y_b` and `Y_j`. The way from torques to parameters, a module each:
//!
//! | module | |
//! | --- | --- |
//! | [`excitation`] | chooses a periodic [`path`] by the condition number of the stacked regressors |
//! | [`measurement`] | gives noisy torques on it, lap after lap, of arms with friction and rotors |
//! | [`mod@stack`] | puts the regressors at all states one above the other, each row divided by its joint's noise |
//! | [`identifiable`] | finds what torques tell, solves the weighted least squares and says how sure the solution is |
//! | [`consistent`] | finds the physically consistent arm that fits best: ten [`physical`] parameters a body |
//! | [`experiment`] | does all this, and compares torques on a path that was not used |
//!
//! What the arms truly are, their `inertial_parameters` and the [`drive`]s of [`arms`], makes the measured torques and is compared with what is
//! found. The estimate knows the geometry, the noisy torques, and a [`prior`] that is wrong.
//!
//! Positions, speeds and accelerations are known exactly here: on a robot they come from the encoders, and from the Fourier series
//! that is fitted to them.
//!
//! `cargo run --release --package kane-identification`

pub mod arms;
pub mod consistent;
pub mod drive;
pub mod excitation;
pub mod experiment;
pub mod extremes;
pub mod identifiable;
pub mod measurement;
pub mod path;
pub mod physical;
pub mod prior;
pub mod pseudo_inertia;
pub mod report;
pub mod stack;

mod names;
#[path = "../../common/noise.rs"]
mod noise;

pub use arms::Arm;
pub use drive::Drive;
pub use experiment::run;
pub use identifiable::Identifiable;
pub use measurement::Measured;
pub use noise::Noise;
pub use path::{Path, State};
pub use physical::Physical;
pub use report::Report;
pub use stack::{stack, stack_torques};

macro_rules! robots {
    ($($(#[$meaning:meta])* $name:ident)+) => {$(
        $(#[$meaning])*
        #[allow(clippy::pedantic, reason = "generated: nobody wrote these lines, and nobody will polish them")]
        pub mod $name {
            include!(concat!(env!("OUT_DIR"), "/", stringify!($name), ".rs"));
        }
    )+};
}

robots! {
    /// The UR5.
    ur5
    /// The Panda, with its hand.
    panda
}
