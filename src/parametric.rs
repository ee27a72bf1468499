//! [`Parametric`]: the values set at run time as an array, for code that estimates or varies them.

use crate::{Array, Real, System};

/// A [`System`] with values set at run time.
///
/// ```
/// use kane::{Array, functions::{InverseDynamics, InverseDynamicsByParameters}};
///
/// /// The values after a step of gradient descent to measured forces.
/// fn improved<S: InverseDynamicsByParameters<f64> + InverseDynamics<f64>>(
///     values: &S::Values,
///     (q, u, u_dot, measured): (&S::Q, &S::U, &S::U, &S::U),
///     rate: f64,
/// ) -> S::Values {
///     let system = S::with_values(values);
///     let (mut values, mut tau) = (*values, S::U::filled(0.0));
///     let mut by_values = S::ByParameters::filled(S::Values::filled(0.0));
///     system.inverse_dynamics(q, u, u_dot, &mut tau);
///     system.d_inverse_dynamics_d_parameters(q, u, u_dot, &mut by_values);
///     for speed in 0..S::U::LEN {
///         let error = tau[speed] - measured[speed];
///         for value in 0..S::Values::LEN {
///             values[value] -= rate * error * by_values[speed][value];
///         }
///     }
///     values
/// }
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` sets no value at run time; write `{{ runtime = 1.2 }}` for one in its model and generate again"
)]
pub trait Parametric<R: Real>: System<R> {
    /// `[R; PARAMETERS_LEN]`: one number for each value set at run time, each in the model's unit.
    type Values: Array<R>;
    /// `[[R; PARAMETERS_LEN]; NU]`: one row per speed, one column per value.
    type ByParameters: Array<Self::Values>;
    /// The names of the values.
    const PARAMETER_NAMES: &'static [&'static str];

    /// The model's own values.
    fn nominal_values() -> Self::Values;

    /// The system with these values, prepared for calls.
    fn with_values(values: &Self::Values) -> Self
    where
        Self: Sized;
}
