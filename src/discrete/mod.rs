//! Steps of a digital controller with their derivatives, for linear-quadratic regulators, trajectory optimization and estimation.
//!
//! A step advances a state in place, under forces `tau` held constant over the step time `dt`, s. Coordinates move by
//! [`q_plus`](crate::manifold::q_plus), so quaternions keep length one. For angles and for quaternions, a change of a state is therefore
//! `2 NU` numbers: the change of `q` along the axes of `u`, then the change of `u`. There are two kinds of steps, with the same functions:
//!
//! | | [`euler`]: semi-implicit | [`rk4`]: Runge-Kutta |
//! | --- | --- | --- |
//! | error of a step | of order `dt²` | of order `dt⁵` |
//! | evaluations of forward dynamics | 1 | 4 |
//! | longest stable `dt` with a damper `d` at a joint where forces meet an inertia `I` | `2 I / d` | `2.7 I / d` |
//!
//! | function | what it computes | functions that the module must have |
//! | --- | --- | --- |
//! | `step` | the step | `forward_dynamics` |
//! | `linearized` | the step and its derivatives `A`, `B` | `forward_dynamics+d(forward_dynamics)/d(q, u, tau)` |
//! | `by_parameters` | derivatives by values set at run time | `d(forward_dynamics)/d(parameters)`; `euler` also needs `forward_dynamics`, `rk4` what `linearized` needs |
//! | `linearized_and_by_parameters` | both, without the evaluation of the dynamics that `by_parameters` needs alone | what both need; `euler` without `forward_dynamics` |
//! | `forward` | the step, and `A` and `B` times one change | `forward_dynamics`, `jvp(forward_dynamics; q, u, tau)` |
//! | `adjoint` | one multiplier times `A` and `B`, backward over the step | `forward_dynamics`, `vjp(forward_dynamics; q, u, tau)` |
//! | `forward_with_parameters`, `adjoint_with_parameters` | the same, also by values set at run time | `forward_dynamics`, and `jvp(..)` or `vjp(forward_dynamics; q, u, tau, parameters)` |
//!
//! `step`, `linearized`, `linearized_and_by_parameters` and the two `forward` functions move `q` and `u`; the others leave them.
//!
//! Under loads, or with joints that something drives, [`conditions`](crate::conditions) takes the system's place.
//!
//! The derivatives are those of the computed step, up to rounding, not those of the exact motion. `forward` and `adjoint` build no matrix,
//! so the gradient of a long motion costs a few times as much as the motion. The functions check and allocate nothing. Matrices are on the
//! stack: `linearized` needs eleven matrices of `NU` by `NU` in `rk4`, and in `euler` none but those that it writes. `by_parameters` in `rk4`
//! needs three of these, and five with `NU` rows and one column for each value; in `euler` none. `linearized_and_by_parameters` needs what both need.
//!
//! ```
//! # #[cfg(feature = "cart_pole")] {
//! use kane::cart_pole::Prepared;
//! use kane::discrete::euler;
//!
//! let system = Prepared::<f64>::nominal();
//! let (mut q, mut u) = ([0.0, 0.1], [0.0, 0.0]);
//! euler::step(&system, &[1.0, 0.0], 0.01, &mut q, &mut u);
//! // The new speed moves the cart.
//! assert_eq!(q[0], 0.01 * u[0]);
//! # }
//! ```

mod derivatives;
pub mod euler;
mod products;
mod reached;
pub mod rk4;

pub use derivatives::{Change, StepByParameters, StepDerivatives};
