//! Control loops that work, each a module to read from top to bottom.
//!
//! Each has a `Controller`, called every millisecond with what it measures, and a function `run`, which lets it act on a
//! simulated plant and reports what came of it. The plant is in `f64`; the controller computes in `Scalar`, chosen at the
//! top of its module: in `f32` where the processor has nothing else. Nothing allocates once `run` has begun, but the solver
//! that `balance` calls.
//!
//! `cargo run --release --package kane-examples --example swing_up`

pub mod balance;
pub mod collision;
pub mod computed_torque;
pub mod gravity_compensation;
pub mod identification;
pub mod impedance;
pub mod linkage;
pub mod reorientation;
pub mod swing_up;

mod calls;
mod desired;
#[path = "../../common/noise.rs"]
mod noise;

pub use calls::CallTimes;
pub use desired::Desired;
pub use noise::Noise;

use kane::Real;

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
    /// The UR5, with a payload.
    ur5
    /// The Panda, with a payload.
    panda
    /// The Solo 12, with a free base.
    solo12
    /// A four-bar linkage, cut open.
    four_bar
}

/// The control period, and the step with which plants are integrated, s.
const PERIOD: f64 = 1e-3;

/// The number of control periods in a time, s.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "times are positive, and far below 2^64 periods"
)]
fn periods(time: f64) -> usize {
    (time / PERIOD).round() as usize
}

/// Measured values, in the controller's scalar.
fn in_scalar<R: Real, const N: usize>(values: &[f64; N]) -> [R; N] {
    values.map(R::from_f64)
}

/// What the controller commands, as the plant takes it.
fn in_double<R: Into<f64>, const N: usize>(values: [R; N]) -> [f64; N] {
    values.map(Into::into)
}

/// Raises `peak` to the greatest magnitude of `values`, if that is greater; what is not a number is not passed over.
fn raise(peak: &mut f64, values: impl IntoIterator<Item = f64>) {
    for value in values {
        // What is not a number stays.
        let below = peak.is_nan() || value.abs() <= *peak;
        *peak = if below { *peak } else { value.abs() };
    }
}
