//! How far off each check lets a number be: faults a little smaller than told pass, a little larger ones do not.

use kane::Real;
use kane::self_test::{
    bias_follows_the_mass_matrix, forward_undoes_inverse, inverse_dynamics_is_linear,
    mass_matrix_is_positive_definite, power_is_the_rate_of_energy,
};

use super::Chosen;
use crate::common::{Faulty, Wrong};

// What the checks say of their tolerances.
const ROUNDING: f64 = 1e-10;
const LARGER: f64 = 1e-5;
const DIFFERENCE: f64 = 1e-7;
const DIFFERENCED: f64 = 1e-12;
const STEP: f64 = 1e-3;

const MASS: f64 = 0.4;
const GRAVITY: f64 = 9.81;

fn faulty(wrong: Wrong, mass: f64, part: f64) -> Faulty {
    Faulty {
        mass,
        wrong: Some(wrong),
        part,
    }
}

/// Asserts that a check passes below a fault of this part, and not above it.
#[track_caller]
fn assert_limit(part: f64, passes: impl Fn(f64) -> bool) {
    assert!(part.is_finite() && part > 0.0, "{part}");
    for sign in [1.0, -1.0] {
        assert!(passes(0.97 * sign * part), "refused below {part:e}");
        assert!(!passes(1.03 * sign * part), "passed above {part:e}");
    }
}

/// A motion of the cart and the pole in closed form.
#[derive(Clone, Copy)]
struct Motion {
    q: [f64; 2],
    u: [f64; 2],
    u_dot: [f64; 2],
}

const MOTION: Motion = Motion {
    q: [0.1, 0.7],
    u: [0.4, 1.3],
    u_dot: [-0.6, 0.9],
};

impl Motion {
    fn m(&self, mass: f64) -> [[f64; 2]; 2] {
        let off = mass * Real::sin_cos(self.q[1]).1;
        [[1.0 + mass, off], [off, mass]]
    }

    /// The force of weight along the pole's angle, and that of its motion along the cart's way.
    fn bias(&self, mass: f64) -> [f64; 2] {
        let sine = Real::sin_cos(self.q[1]).0;
        [-mass * sine * self.u[1] * self.u[1], mass * GRAVITY * sine]
    }

    /// The sum of the terms of each force, with a part of the largest.
    fn scales(&self, mass: f64) -> [f64; 2] {
        let (m, bias) = (self.m(mass), self.bias(mass));
        let [d0, d1] = self.u_dot;
        let own = [0, 1].map(|i| bias[i].abs() + (m[i][0] * d0).abs() + (m[i][1] * d1).abs());
        own.map(|scale| scale + LARGER * own[0].max(own[1]))
    }

    fn kinetic(&self) -> f64 {
        let (m, [a, b]) = (self.m(MASS), self.u);
        0.5 * (m[0][0] * a * a + 2.0 * m[0][1] * a * b + m[1][1] * b * b)
    }

    fn potential(&self) -> f64 {
        -MASS * GRAVITY * Real::sin_cos(self.q[1]).1
    }

    /// The powers of the forces that the motion needs.
    fn powers(&self) -> [f64; 2] {
        let (m, bias, [d0, d1]) = (self.m(MASS), self.bias(MASS), self.u_dot);
        [0, 1].map(|i| self.u[i] * (m[i][0] * d0 + m[i][1] * d1 + bias[i]))
    }

    fn forward_passes(&self, wrong: Wrong, part: f64) -> bool {
        let system = faulty(wrong, MASS, part);
        forward_undoes_inverse(&system, &self.q, &self.u, &self.u_dot).is_ok()
    }

    fn linear_passes(&self, part: f64) -> bool {
        let [below, at, above] = [0.3, 0.4, 0.5].map(|mass| faulty(Wrong::Linearity, mass, part));
        inverse_dynamics_is_linear([&below, &at, &above], &self.q, &self.u, &self.u_dot).is_ok()
    }
}

#[test]
fn forces_may_differ_by_rounding_of_their_terms() {
    let (m, scales) = (MOTION.m(MASS), MOTION.scales(MASS));
    let parts = [0, 1].map(|i| ROUNDING * scales[i] / (m[i][1] * MOTION.u_dot[1]).abs());
    assert_limit(parts[0].min(parts[1]), |part| {
        MOTION.forward_passes(Wrong::Accelerations, part)
    });
}

/// What is left of `part mass²` between these masses: half of 0.09 + 0.25, minus 0.16.
const BETWEEN: f64 = 0.01;

#[test]
fn forces_may_miss_the_line_by_rounding_of_their_terms() {
    let sum = MOTION.scales(0.3)[0] + MOTION.scales(0.5)[0];
    assert_limit(ROUNDING * sum / BETWEEN, |part| MOTION.linear_passes(part));
}

#[test]
fn a_force_without_terms_has_the_rounding_of_the_larger_one() {
    // A level pole that is swung: nothing pushes the cart.
    let swung = Motion {
        q: [0.0, std::f64::consts::FRAC_PI_2],
        u: [0.0; 2],
        u_dot: [0.0, 2.0],
    };
    let larger = [0.3, 0.5].map(|mass| mass * (2.0 + GRAVITY));
    let tolerance = ROUNDING * LARGER * (larger[0] + larger[1]);
    assert_limit(tolerance / BETWEEN, |part| swung.linear_passes(part));
}

#[test]
fn power_may_differ_by_truncation_of_the_difference() {
    let [p0, p1] = MOTION.powers();
    let energies = MOTION.kinetic().abs() + MOTION.potential().abs();
    let tolerance = DIFFERENCE * (p0.abs() + p1.abs()) + DIFFERENCED * energies / STEP;
    let rate = p0 + p1 - MOTION.u[1] * MOTION.bias(MASS)[1];
    assert_limit(tolerance / rate.abs(), |part| {
        let system = faulty(Wrong::Energy, MASS, part);
        power_is_the_rate_of_energy(&system, &MOTION.q, &MOTION.u, &MOTION.u_dot).is_ok()
    });
}

#[test]
fn the_power_of_bias_may_differ_by_truncation_of_the_difference() {
    let [b0, b1] = MOTION.bias(MASS);
    let [u0, u1] = MOTION.u.map(f64::abs);
    let power = u0 * b0.abs();
    // At twice, once and none of the speeds.
    let terms = 5.0 * power + 3.0 * u1 * b1.abs();
    let differenced = DIFFERENCED * MOTION.kinetic() / STEP;
    let tolerance = DIFFERENCE * power + ROUNDING * terms + differenced;
    assert_limit(tolerance / power, |part| {
        let system = faulty(Wrong::Coriolis, MASS, part);
        bias_follows_the_mass_matrix(&system, &MOTION.q, &MOTION.u).is_ok()
    });
}

#[test]
fn a_rate_of_zero_may_differ_by_rounding_of_what_is_differenced() {
    let u = [1e3, 0.0];
    let energy = 0.5 * (1.0 + MASS) * u[0] * u[0];
    let per_part = 0.5 * u[0] * u[0] * u[0];
    assert_limit(DIFFERENCED * energy / STEP / per_part, |part| {
        bias_follows_the_mass_matrix(&faulty(Wrong::Mass, MASS, part), &[0.0, 0.7], &u).is_ok()
    });
}

#[test]
fn a_pivot_without_digits_may_be_off_by_its_rounding() {
    let epsilon = f64::EPSILON;
    // The middle pivot is `1 - a²`, minus two roundings for each that `a` is above one; three are allowed.
    let with = |a: f64, b: f64| {
        let m = [[1.0, b, 0.0], [b, 1.0, a], [0.0, a, 1.0]];
        mass_matrix_is_positive_definite(&Chosen(m), &[0.0; 3]).is_ok()
    };
    assert!(with(1.0 + epsilon, 0.0) && !with(1.0 + 2.0 * epsilon, 0.0));
    // What else it moves: the square of an entry is at most four times the rounding.
    let entry = (12.0 * epsilon).sqrt();
    assert!(with(1.0, 0.99 * entry) && !with(1.0, 1.01 * entry));
}
