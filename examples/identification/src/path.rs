//! Paths that repeat themselves: a Fourier series for each joint.

use std::f64::consts::TAU;

use kane::{Array, Real};

use crate::{Arm, Noise, extremes::largest};

/// The harmonics of a series.
const HARMONICS: usize = 5;
/// The times at which the greatest angles and speeds are looked for.
const LOOKS: usize = 200;
/// The part of the joints' greatest speeds that is used.
const SPEED: f64 = 0.8;

/// How an arm moves at one time.
#[derive(Debug)]
pub struct State<A: Arm> {
    /// `q`, rad.
    pub q: A::Q,
    /// `u`, rad/s.
    pub u: A::U,
    /// `u̇`, rad/s².
    pub u_dot: A::U,
}

/// A joint's factors of sines and cosines, rad.
type Series = [[f64; 2]; HARMONICS];

/// `q = c + Σ a_k sin(k ω t) + b_k cos(k ω t)`.
#[derive(Clone, Debug)]
pub struct Path {
    /// `2π / ω`, s.
    pub period: f64,
    joints: Vec<Series>,
}

impl Path {
    /// Takes the factors by chance, and the largest motion within reach and speed.
    pub fn random<A: Arm>(period: f64, chance: &mut Noise) -> Self {
        let still = Self {
            period,
            joints: vec![Series::default(); A::CENTER.len()],
        };
        still.varied::<A>(1.0, chance)
    }

    /// Changes each factor by chance, by a part of the joint's reach, and takes the largest motion within reach and speed.
    #[must_use]
    pub fn varied<A: Arm>(&self, part: f64, chance: &mut Noise) -> Self {
        let mut path = self.clone();
        for (joint, reach) in path.joints.iter_mut().zip(A::REACH) {
            for factor in joint.as_flattened_mut() {
                *factor += part * reach * chance.normal();
            }
        }
        path.fit::<A>();
        path
    }

    fn fit<A: Arm>(&mut self) {
        let mut used = vec![0.0_f64; self.joints.len()];
        for look in 0..LOOKS {
            let state = self.state::<A>(self.period * look as f64 / LOOKS as f64);
            for (i, used) in used.iter_mut().enumerate() {
                let of_reach = (state.q[i] - A::CENTER[i]) / A::REACH[i];
                let of_speed = state.u[i] / (SPEED * A::VELOCITY_LIMITS[i]);
                *used = largest([*used, of_reach, of_speed]);
            }
        }
        for (joint, used) in self.joints.iter_mut().zip(used) {
            for factor in joint.as_flattened_mut() {
                *factor /= used;
            }
        }
    }

    /// Where the arm is after so long, s.
    pub fn state<A: Arm>(&self, t: f64) -> State<A> {
        let omega = TAU / self.period;
        let mut state: State<A> = State {
            q: A::Q::from_fn(|i| A::CENTER[i]),
            u: A::U::filled(0.0),
            u_dot: A::U::filled(0.0),
        };
        for harmonic in 0..HARMONICS {
            let omega = omega * (harmonic + 1) as f64;
            let (sine, cosine) = Real::sin_cos(omega * t);
            for (i, joint) in self.joints.iter().enumerate() {
                let [a, b] = joint[harmonic];
                state.q[i] += a * sine + b * cosine;
                state.u[i] += omega * (a * cosine - b * sine);
                state.u_dot[i] -= omega * omega * (a * sine + b * cosine);
            }
        }
        state
    }

    /// Where it is at so many times, evenly in one period.
    pub fn states<A: Arm>(&self, number: usize) -> Vec<State<A>> {
        (0..number)
            .map(|k| self.state(self.period * k as f64 / number as f64))
            .collect()
    }
}
