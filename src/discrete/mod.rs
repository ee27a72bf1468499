//! Steps of a digital controller with their derivatives: for linear-quadratic regulators, trajectory optimisation,
//! estimation.
//!
//! In: a state, forces `tau` that are held over the step, the time `dt`, s. Out: the state after it, in place. The state stays on its
//! manifold: coordinates move by [`q_plus`](crate::manifold::q_plus), so changes of a state are `2 NU` numbers in every chart,
//! of `q` along the axes of `u`, then of `u`. Two kinds of steps, with the same functions:
//!
//! | | [`euler`]: semi-implicit | [`rk4`]: Runge and Kutta |
//! | --- | --- | --- |
//! | error of a step | of order `dt²` | of order `dt⁵` |
//! | evaluations of forward dynamics | 1 | 4 |
//!
//! | function | | asks for |
//! | --- | --- | --- |
//! | `step` | the step | `forward_dynamics` |
//! | `linearized` | and its derivatives `A`, `B` | `forward_dynamics+d(forward_dynamics)/d(q, u, tau)` |
//! | `by_parameters` | derivatives by values set at run time | `d(forward_dynamics)/d(parameters)`, and in `euler` `forward_dynamics`, in `rk4` what `linearized` asks for |
//! | `forward` | what becomes of one change, `A` and `B` times it | `forward_dynamics`, `jvp(forward_dynamics; q, u, tau)` |
//! | `adjoint` | what a multiplier becomes, back over the step, times `A` and `B` | `forward_dynamics`, `vjp(forward_dynamics; q, u, tau)` |
//!
//! The derivatives are those of the step that is computed, to rounding, not of the motion. `forward` and `adjoint` form no matrix:
//! the gradient of a long motion costs a few times as much as the motion. Nothing is checked or allocated. Matrices
//! stand on the stack: for `linearized` twelve of `NU` by `NU` in `rk4` and three in `euler`; `by_parameters` adds of `NU` by as many
//! as there are values four in `rk4`, and has one alone in `euler`.
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
mod reached;
pub mod rk4;

pub use derivatives::{Change, StepByParameters, StepDerivatives};
