//! Fixed-step integration for control loops: the classic fourth-order Runge-Kutta step.
//!
//! A step advances a state in place. It does not allocate, estimate an error or check anything: a singular state gives
//! whatever [`ForwardDynamics`] gives. Time is not an argument. If your control law depends on it, let the closure count or hold
//! the time. The module `simulate` integrates to a tolerance instead of with a fixed step;
//! [`discrete`](crate::discrete) has steps with derivatives, exactly on the manifold of quaternions.
//!
//! The step is explicit. A damper `d` at a joint where forces meet an inertia `I` slows the joint by a factor e in `I / d` seconds. Steps must be
//! shorter than 2.7 times this, or speeds grow from step to step.

use crate::functions::ForwardDynamics;
use crate::vector::add_scaled;
use crate::{Array, Real};

/// Advances `q` and `u` by `dt` (s) under generalized forces `tau` held constant over the step (zero-order hold).
///
/// Evaluates the forward dynamics four times; the error of a step is of order `dt⁵`. Quaternions among the coordinates
/// have length one after the step, to rounding where they have before it and bodies turn by much less than a radian in it;
/// [`scale_quaternions`](crate::manifold::scale_quaternions) gives them that length.
///
/// ```
/// # #[cfg(feature = "eight_body")] {
/// use kane::eight_body::{NQ, NU, Prepared};
/// use kane::integrate::rk4_step;
///
/// let system = Prepared::<f64>::nominal();
/// let (mut q, mut u) = ([0.0; NQ], [0.0; NU]);
/// u[24] = 0.5; // the hub's speed along the inertial x axis
/// let tau = [0.0; NU];
/// for _ in 0..100 {
///     rk4_step(&system, &tau, 0.01, &mut q, &mut u);
/// }
/// // Nothing acts on the system: all its bodies move on together.
/// assert!((q[24] - 0.5).abs() < 1e-12);
/// # }
/// ```
pub fn rk4_step<R: Real, S: ForwardDynamics<R>>(
    system: &S,
    tau: &S::U,
    dt: R,
    q: &mut S::Q,
    u: &mut S::U,
) {
    rk4_step_with(system, dt, q, u, |_, _, held| *held = *tau);
}

/// Like [`rk4_step`], with `tau` a function of the state: `control(q, u, tau)` overwrites `tau`, which is zero on entry.
///
/// `control` is called four times per step, at the states of the four stages. Use it for forces that act continuously (springs,
/// dampers, a fast inner loop); a discontinuous law lowers the order.
///
/// Its quaternions do not have length one exactly: those of the second and third stage miss it by about the square of the angle turned in the
/// step, over 32. A law that needs length one takes a copy of `q` and calls [`scale_quaternions`](crate::manifold::scale_quaternions) on it.
pub fn rk4_step_with<R: Real, S: ForwardDynamics<R>>(
    system: &S,
    dt: R,
    q: &mut S::Q,
    u: &mut S::U,
    mut control: impl FnMut(&S::Q, &S::U, &mut S::U),
) {
    let zero = R::from_f64(0.0);
    let mut derivative = |q: &S::Q, u: &S::U| {
        let mut q_dot = S::Q::filled(zero);
        let mut u_dot = S::U::filled(zero);
        let mut tau = S::U::filled(zero);
        control(q, u, &mut tau);
        system.q_dot(q, u, &mut q_dot);
        system.forward_dynamics(q, u, &tau, &mut u_dot);
        (q_dot, u_dot)
    };
    let half = dt * R::from_f64(0.5);
    let sixth = dt * R::from_f64(1.0 / 6.0);
    let third = dt * R::from_f64(1.0 / 3.0);
    let (q_0, u_0) = (*q, *u);

    // The weighted sum of the four rates grows in `q` and `u`, so that one rate at a time is alive.
    let (mut q_dot, mut u_dot) = derivative(&q_0, &u_0);
    for (weight, to_next_stage) in [(sixth, half), (third, half), (third, dt)] {
        add_scaled(q, weight, &q_dot);
        add_scaled(u, weight, &u_dot);
        let (mut q_stage, mut u_stage) = (q_0, u_0);
        add_scaled(&mut q_stage, to_next_stage, &q_dot);
        add_scaled(&mut u_stage, to_next_stage, &u_dot);
        (q_dot, u_dot) = derivative(&q_stage, &u_stage);
    }
    add_scaled(q, sixth, &q_dot);
    add_scaled(u, sixth, &u_dot);
    system.normalize(q);
}
