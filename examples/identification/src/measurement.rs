//! What the arm's sensors say on a path, lap after lap.

use kane::Array;

use crate::{Arm, Noise, State};

/// The standard deviation of a measured torque, as a part of the joint's greatest.
pub const TORQUE_NOISE: f64 = 0.01;

/// Torques of the motors at the same states in each lap, N m.
#[derive(Debug)]
pub struct Measured<A: Arm> {
    /// How the arm moves, which is known.
    pub states: Vec<State<A>>,
    /// As they are measured, lap after lap.
    pub laps: Vec<Vec<A::U>>,
    /// As they are, which nobody knows.
    pub truth: Vec<A::U>,
}

impl<A: Arm> Measured<A> {
    /// Measures so many laps.
    pub fn new(arm: &A, states: Vec<State<A>>, laps: usize, noise: &mut Noise) -> Self {
        let truth: Vec<A::U> = states.iter().map(|state| torque(arm, state)).collect();
        let mut noisy = |torque: &A::U| {
            A::U::from_fn(|i| torque[i] + TORQUE_NOISE * A::EFFORT_LIMITS[i] * noise.normal())
        };
        let laps = (0..laps).map(|_| truth.iter().map(&mut noisy).collect());
        Self {
            laps: laps.collect(),
            states,
            truth,
        }
    }

    /// Means over the laps, which have less noise.
    pub fn mean(&self) -> Vec<A::U> {
        let number = self.laps.len() as f64;
        let mean = |k: usize| {
            A::U::from_fn(|i| self.laps.iter().map(|lap| lap[k][i]).sum::<f64>() / number)
        };
        (0..self.states.len()).map(mean).collect()
    }

    /// The standard deviations of the means, by what the laps, two or more, differ from these, N m.
    pub fn deviations(&self) -> A::U {
        let mean = self.mean();
        let mut squares = A::U::filled(0.0);
        for lap in &self.laps {
            for (torque, mean) in lap.iter().zip(&mean) {
                squares = A::U::from_fn(|i| squares[i] + (torque[i] - mean[i]).powi(2));
            }
        }
        // At each state the mean takes one of the laps' differences away.
        let (laps, states) = (self.laps.len(), self.states.len());
        let free = (states * (laps - 1)) as f64;
        A::U::from_fn(|i| (squares[i] / free / laps as f64).sqrt())
    }
}

/// What the motors truly give.
fn torque<A: Arm>(arm: &A, state: &State<A>) -> A::U {
    let mut tau = A::U::filled(0.0);
    arm.inverse_dynamics(&state.q, &state.u, &state.u_dot, &mut tau);
    A::U::from_fn(|i| tau[i] + A::DRIVES[i].torque(state.u[i], state.u_dot[i]))
}
