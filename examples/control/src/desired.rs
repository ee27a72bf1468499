//! Where to be, and how to get there.

use std::array::from_fn;

use kane::Real;

/// Where `N` coordinates ought to be at one time, and how they ought to move.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Desired<R, const N: usize> {
    /// `q_d`, rad, m.
    pub q: [R; N],
    /// `u_d`, rad/s, m/s.
    pub u: [R; N],
    /// `u̇_d`, rad/s², m/s².
    pub u_dot: [R; N],
}

impl<R: Real, const N: usize> Desired<R, N> {
    /// `u̇_d + 2 ω (u_d - u) + ω² (q_d - q)`: the acceleration that leads back to where to be, without overshoot; `omega`, rad/s,
    /// is how fast.
    pub(crate) fn acceleration(&self, omega: R, q: &[R; N], u: &[R; N]) -> [R; N] {
        from_fn(|i| {
            let (error, rate) = (self.q[i] - q[i], self.u[i] - u[i]);
            self.u_dot[i] + omega * (rate + rate + omega * error)
        })
    }
}

impl<const N: usize> Desired<f64, N> {
    /// On the straight way from rest to rest, `t` after its beginning, s.
    pub(crate) fn between(from: &[f64; N], to: &[f64; N], t: f64, duration: f64) -> Self {
        let progress = progress(t, duration);
        let along = |factor: f64| from_fn(|i| factor * (to[i] - from[i]));
        let way = along(progress.s);
        Self {
            q: from_fn(|i| from[i] + way[i]),
            u: along(progress.s_dot),
            u_dot: along(progress.s_ddot),
        }
    }

    /// The same in the controller's scalar.
    pub(crate) fn in_scalar<R: Real>(&self) -> Desired<R, N> {
        Desired {
            q: self.q.map(R::from_f64),
            u: self.u.map(R::from_f64),
            u_dot: self.u_dot.map(R::from_f64),
        }
    }
}

/// How far a motion is, and how fast.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Progress {
    /// From 0 to 1.
    pub(crate) s: f64,
    /// 1/s.
    pub(crate) s_dot: f64,
    /// 1/s².
    pub(crate) s_ddot: f64,
}

/// The progress at time `t` of a motion that takes `duration`, s: `s = 10 x³ - 15 x⁴ + 6 x⁵` with `x = t / duration`, the
/// shortest polynomial that begins and ends at rest and without acceleration.
pub(crate) fn progress(t: f64, duration: f64) -> Progress {
    let x = (t / duration).clamp(0.0, 1.0);
    Progress {
        s: x * x * x * (10.0 + x * (-15.0 + x * 6.0)),
        s_dot: 30.0 * (x * (1.0 - x)).powi(2) / duration,
        s_ddot: 60.0 * x * (1.0 - x) * (1.0 - 2.0 * x) / (duration * duration),
    }
}
