//! Swing-up: a cart throws its pole up, catches it at the top and balances it there.
//!
//! Both laws ask for an acceleration `a` of the cart. To swing, `a = k (E - E_d) M₂₁ θ̇`: the pole's energy changes by
//! `Ė = -M₂₁ a θ̇`, so it approaches `E_d`. At the top, `a = k₁ s + k₂ ṡ + k₃ θ + k₄ θ̇`, which puts the four poles of
//! `s̈ = a`, `θ̈ = ω² θ - c a` at `-p`. The force follows from `M u̇ + b = (τ, 0)` with `s̈ = a`.

use std::{f64::consts::PI, fmt};

use kane::{
    Real,
    cart_pole::{self, NQ, NU, Parameters, Prepared},
    integrate::rk4_step,
};

use crate::{CallTimes, PERIOD, in_double, in_scalar, periods, raise};

/// What the controller computes in.
pub type Scalar = f32;

/// `p`, 1/s.
const BANDWIDTH: Scalar = 4.0;
/// `k`, m/s² per J kg m rad/s.
const PUMPING: Scalar = 8.0;
/// `E_d` lies above the energy at the top, from the bottom, by this factor: the top is reached with a pole that is not quite
/// as believed.
const MARGIN: Scalar = 1.1;
/// While it swings, the cart is pulled home, 1/s², and damped, 1/s.
const HOMING: [Scalar; 2] = [1.5, 1.5];
/// The greatest acceleration asked for while it swings, m/s².
const GREATEST: Scalar = 8.0;
/// It is caught where it is nearer to the top than this, rad,
const CATCH_ANGLE: Scalar = 0.6;
/// and so is `θ + θ̇ / ω`, the part of the motion that grows when left alone, rad.
const CATCH_GROWING: Scalar = 0.3;

/// The two laws, and what they know of the system.
#[derive(Debug)]
pub struct Controller {
    system: Prepared<Scalar>,
    /// `ω`, rad/s.
    omega: Scalar,
    /// `E_d`, J.
    energy: Scalar,
    /// `k₁` to `k₄`.
    gains: [Scalar; NQ + NU],
}

impl Controller {
    /// Believes that the pole has this mass, kg; gains and energies follow from the model.
    pub fn new(pole_mass: Scalar) -> Self {
        let system = Prepared::new(&Parameters { pole_mass });
        let [top, bottom] = [0.0, PI].map(|theta| weight_energy(&system, Scalar::from_f64(theta)));
        let mut m = [[0.0; NU]; NU];
        cart_pole::mass_matrix(&system, &[0.0; NQ], &mut m);

        let (omega_2, c) = ((top - bottom) / (2.0 * m[1][1]), m[1][0] / m[1][1]);
        let p = BANDWIDTH;
        let (k_1, k_2) = (p.powi(4) / omega_2, 4.0 * p.powi(3) / omega_2);
        let (k_3, k_4) = ((6.0 * p.powi(2) + omega_2 + k_1) / c, (4.0 * p + k_2) / c);
        Self {
            system,
            omega: omega_2.sqrt(),
            energy: bottom + MARGIN * (top - bottom),
            gains: [k_1, k_2, k_3, k_4],
        }
    }

    /// `τ`: a force on the cart, and no torque on the pole.
    pub fn torque(&self, q: &[Scalar; NQ], u: &[Scalar; NU]) -> [Scalar; NU] {
        let (mut m, mut b) = ([[0.0; NU]; NU], [0.0; NU]);
        cart_pole::mass_matrix(&self.system, q, &mut m);
        cart_pole::bias(&self.system, q, u, &mut b);

        let ([s, theta], [s_dot, theta_dot]) = ([q[0], from_upright(q[1])], *u);
        let growing = theta + theta_dot / self.omega;
        let a = if theta.abs() < CATCH_ANGLE && growing.abs() < CATCH_GROWING {
            let [k_1, k_2, k_3, k_4] = self.gains;
            k_1 * s + k_2 * s_dot + k_3 * theta + k_4 * theta_dot
        } else {
            let energy = weight_energy(&self.system, theta) + 0.5 * m[1][1] * theta_dot.powi(2);
            let pumping = PUMPING * (energy - self.energy) * m[1][0] * theta_dot;
            (pumping - HOMING[0] * s - HOMING[1] * s_dot).clamp(-GREATEST, GREATEST)
        };
        let theta_ddot = -(m[1][0] * a + b[1]) / m[1][1];
        [m[0][0] * a + m[0][1] * theta_ddot + b[0], 0.0]
    }
}

/// The energy of the pole's weight, J.
fn weight_energy(system: &Prepared<Scalar>, theta: Scalar) -> Scalar {
    let mut energy = 0.0;
    cart_pole::potential_energy(system, &[0.0, theta], &mut energy);
    energy
}

/// The angle from upright, whole turns taken off, -π to π.
fn from_upright(theta: Scalar) -> Scalar {
    let turn = Scalar::from_f64(2.0 * PI);
    theta - turn * (theta / turn).round()
}

/// How long it is watched, and for how long of that at the end it is to stand, s.
const DURATION: f64 = 12.0;
const STANDING: f64 = 2.0;

/// What came of it.
#[derive(Clone, Copy, Debug, Default)]
pub struct Report {
    /// From when on the pole is within 0.1 rad of upright, s.
    pub upright_from: f64,
    /// How far it is from upright, at most, while it is to stand, rad.
    pub angle: f64,
    /// How far the cart is from home, at most, while the pole is to stand, m.
    pub position: f64,
    /// How far the cart goes, m.
    pub travel: f64,
    /// The greatest force, N.
    pub force: f64,
}

/// Begins with a pole that hangs, a hundredth of a radian aside, and has another mass than the controller believes, kg.
pub fn run(pole_mass: f64, believed: Scalar, calls: &mut CallTimes) -> Report {
    let controller = Controller::new(believed);
    let plant = Prepared::new(&Parameters { pole_mass });
    let (mut q, mut u) = ([0.0, PI - 0.01], [0.0; NU]);
    let mut report = Report::default();
    for period in 0..periods(DURATION) {
        let (q_m, u_m) = (in_scalar(&q), in_scalar(&u));
        let tau = in_double(calls.time(|| controller.torque(&q_m, &u_m)));
        rk4_step(&plant, &tau, PERIOD, &mut q, &mut u);

        let [angle] = in_double([from_upright(Scalar::from_f64(q[1]))]);
        if angle.abs() > 0.1 {
            report.upright_from = (period + 1) as f64 * PERIOD;
        }
        if period >= periods(DURATION - STANDING) {
            raise(&mut report.angle, [angle]);
            raise(&mut report.position, [q[0]]);
        }
        raise(&mut report.travel, [q[0]]);
        raise(&mut report.force, [tau[0]]);
    }
    report
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "upright from {:.2} s on, at last within {:.1e} rad, the cart within {:.1e} m of home; it goes {:.2} m, with up to {:.0} N",
            self.upright_from, self.angle, self.position, self.travel, self.force,
        )
    }
}
