//! A Panda weighs what it carries: mass and mass centre of a payload from the torques of two seconds.
//!
//! Torques change with the payload's mass and mass centre as `d(inverse_dynamics)/d(parameters)` says. All measured torques
//! together make a least-squares problem; as the weight has the product of both, it is solved by Newton's steps as Gauss took them. A joint's
//! torque counts by its noise, so the inverse of the normal matrix says how sure the result is.

use kane::functions::{InverseDynamics, InverseDynamicsByParameters};
use nalgebra::{Matrix4, Vector4};

use crate::arm::READY;
use crate::noise::Noise;
use crate::panda::{NU, PARAMETERS_LEN, Parameters, Prepared};

/// The payload: mass, kg, and mass centre from the hand's tip along the hand's axes, m.
pub const TRUE: [f64; PARAMETERS_LEN] = [1.35, 0.03, -0.02, 0.06];

/// The noise of a measured torque, N m, standard deviation.
pub const NOISE: f64 = 0.2;

/// How many states are measured, over two seconds.
const N_STATES: usize = 400;

/// What is found.
#[derive(Clone, Copy, Debug)]
pub struct Estimate {
    /// As [`TRUE`].
    pub found: [f64; PARAMETERS_LEN],
    /// Standard deviations of these.
    pub sure: [f64; PARAMETERS_LEN],
}

/// A state: angles, speeds, accelerations.
type State = [[f64; NU]; 3];

/// Each joint swings about the ready position, at a frequency of its own.
fn state(time: f64) -> State {
    let wave = |joint: usize| {
        let w = std::f64::consts::TAU * (0.4 + 0.13 * joint as f64);
        let (sine, cosine) = kane::Real::sin_cos(w * time);
        [0.3 * sine, 0.3 * w * cosine, -0.3 * w * w * sine]
    };
    let mut state: State = [0, 1, 2].map(|order| std::array::from_fn(|joint| wave(joint)[order]));
    for (angle, ready) in state[0].iter_mut().zip(READY) {
        *angle += ready;
    }
    state
}

fn arm(values: [f64; PARAMETERS_LEN]) -> Prepared<f64> {
    Prepared::new(&Parameters::from_array(values))
}

fn torques(arm: &Prepared<f64>, [q, u, u_dot]: &State) -> [f64; NU] {
    let mut tau = [0.0; NU];
    arm.inverse_dynamics(q, u, u_dot, &mut tau);
    tau
}

/// Measures with noise of this seed, and estimates; `None` where the states do not tell what is asked for.
pub fn run(seed: u64) -> Option<Estimate> {
    let (actual, mut noise) = (arm(TRUE), Noise::new(seed));
    let measured: Vec<(State, [f64; NU])> = (0..N_STATES)
        .map(|place| {
            let state = state(2.0 * place as f64 / N_STATES as f64);
            let tau = torques(&actual, &state).map(|tau| tau + NOISE * noise.normal());
            (state, tau)
        })
        .collect();

    // A kilogram at the tip: with no mass at all its centre would not count.
    let mut estimate = Vector4::new(1.0, 0.0, 0.0, 0.0);
    for _ in 0..20 {
        let model = arm(estimate.into());
        let (mut normal, mut right) = (Matrix4::zeros(), Vector4::zeros());
        for (state, measured) in &measured {
            let [q, u, u_dot] = state;
            let mut rows = [[0.0; PARAMETERS_LEN]; NU];
            model.d_inverse_dynamics_d_parameters(q, u, u_dot, &mut rows);
            let modelled = torques(&model, state);
            for ((row, measured), modelled) in rows.into_iter().zip(measured).zip(modelled) {
                let row = Vector4::from(row) / NOISE;
                normal += row * row.transpose();
                right += row * ((measured - modelled) / NOISE);
            }
        }
        let covariance = normal.try_inverse()?;
        let step = covariance * right;
        estimate += step;
        let sure = covariance.diagonal().map(f64::sqrt);
        // A millionth of what the noise leaves unsure.
        if step.component_div(&sure).norm() < 1e-6 {
            return Some(Estimate {
                found: estimate.into(),
                sure: sure.into(),
            });
        }
    }
    None
}
