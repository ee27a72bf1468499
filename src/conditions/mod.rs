//! A system under conditions: steps of [`discrete`](crate::discrete), [`integrate`](crate::integrate) and the module `simulate` take it as
//! a system, and move it under them.
//!
//! | | what is given | whose forward dynamics it has |
//! | --- | --- | --- |
//! | [`Loaded`] | loads on the bodies: a push, a contact | [`LoadedForwardDynamics`](crate::functions::LoadedForwardDynamics) |
//! | [`Driven`] | accelerations of the prescribed speeds: a conveyor, a position-controlled joint | [`HybridDynamics`](crate::functions::HybridDynamics) |
//!
//! Derivatives of steps need the derivatives of these in the module: `loaded_forward_dynamics+d(loaded_forward_dynamics)/d(q, u, tau)` for
//! `linearized`, `jvp(loaded_forward_dynamics; q, u, tau)` for `forward`, `vjp(..)` for `adjoint`; and so of `hybrid_dynamics`.
//!
//! What is given stays as it is over a step, also at the stages within it; give it anew for the next one.
//!
//! Both implement [`System`](crate::System), [`ForwardDynamics`](crate::functions::ForwardDynamics),
//! [`ForwardDynamicsAndDerivatives`](crate::functions::ForwardDynamicsAndDerivatives),
//! [`ForwardDynamicsJvp`](crate::functions::ForwardDynamicsJvp) and [`ForwardDynamicsVjp`](crate::functions::ForwardDynamicsVjp), and [`Loaded`]
//! also [`InverseDynamics`](crate::functions::InverseDynamics): each if the module has the function that it needs. For everything else take
//! the field `system`, which knows of no condition. So there are no steps by parameters and no
//! [`checked::forward_dynamics`](crate::checked::forward_dynamics) under conditions.
//! [`System::OPERATIONS`](crate::System::OPERATIONS) is empty: the system's own are the costs of other functions. All other constants are the
//! system's.
//!
//! For loads on a driven system, add their [`GeneralizedForces`](crate::functions::GeneralizedForces) at the state to `tau`. This is exact for
//! [`discrete::euler::step`](crate::discrete::euler::step), and where a control law adds them at each stage
//! ([`rk4_step_with`](crate::integrate::rk4_step_with), `simulate`). Other steps ask for forces at states within, and derivatives of steps
//! miss how these forces change with `q`.
//!
//! ```
//! # #[cfg(feature = "eight_body")] {
//! use kane::{conditions::Loaded, discrete::euler, eight_body, Load};
//!
//! let system = eight_body::Prepared::<f64>::nominal();
//! let mut loads = [Load::default(); eight_body::NB];
//! loads[0].force = [10.0, 0.0, 0.0];
//! let pushed = Loaded { system: &system, loads };
//! let (mut q, mut u) = ([0.1; eight_body::NQ], [0.0; eight_body::NU]);
//! euler::step(&pushed, &[0.0; eight_body::NU], 1e-3, &mut q, &mut u);
//! # }
//! ```

mod driven;
mod loaded;

pub use driven::Driven;
pub use loaded::Loaded;

/// What a system under conditions, in its field `system`, has of the system `S`.
macro_rules! of_system {
    () => {
        type Q = S::Q;
        type U = S::U;
        type Matrix = S::Matrix;
        type Loads = S::Loads;
        type Scalars = S::Scalars;
        type Vectors = S::Vectors;
        type Rotations = S::Rotations;

        const NAME: &'static str = S::NAME;
        const BODY_NAMES: &'static [&'static str] = S::BODY_NAMES;
        const COORDINATE_NAMES: &'static [&'static str] = S::COORDINATE_NAMES;
        const SPEED_NAMES: &'static [&'static str] = S::SPEED_NAMES;
        const LOWER_BODIES: &'static [usize] = S::LOWER_BODIES;
        const SPEED_BODIES: &'static [usize] = S::SPEED_BODIES;
        const JOINTS: &'static [$crate::Joint] = S::JOINTS;
        const FRAMES: &'static [$crate::Frame] = S::FRAMES;
        const LOWER_LIMITS: &'static [f64] = S::LOWER_LIMITS;
        const UPPER_LIMITS: &'static [f64] = S::UPPER_LIMITS;
        const VELOCITY_LIMITS: &'static [f64] = S::VELOCITY_LIMITS;
        const EFFORT_LIMITS: &'static [f64] = S::EFFORT_LIMITS;
        const FRICTION: &'static [f64] = S::FRICTION;
        const FINGERPRINT: u64 = S::FINGERPRINT;

        fn q_dot(&self, q: &Self::Q, u: &Self::U, q_dot: &mut Self::Q) {
            self.system.q_dot(q, u, q_dot);
        }

        fn normalize(&self, q: &mut Self::Q) {
            self.system.normalize(q);
        }
    };
}
use of_system;
