//! The regressors at many states, one above the other.

use kane::{
    Array,
    functions::{BaseRegressor, JointRegressor},
};
use nalgebra::{DMatrix, DVector};

use crate::{Arm, State, drive::COEFFICIENTS};

/// The number of base parameters.
pub fn base_parameters<A: Arm>() -> usize {
    <<A as BaseRegressor<f64>>::Row as Array<f64>>::LEN
}

/// The number of columns: base parameters, then of each joint the coefficients of its drive.
pub fn columns<A: Arm>() -> usize {
    base_parameters::<A>() + COEFFICIENTS * A::SPEED_NAMES.len()
}

/// `W`, a row for each state and joint, divided by the joint's `scale`, N m: torques in units of that are `W` times base parameters
/// and coefficients.
pub fn stack<A: Arm>(arm: &A, states: &[State<A>], scale: &A::U) -> DMatrix<f64> {
    let (joints, base) = (A::SPEED_NAMES.len(), base_parameters::<A>());
    let mut w = DMatrix::zeros(joints * states.len(), columns::<A>());
    let mut of_bodies =
        <A as BaseRegressor<f64>>::Rows::filled(<A as BaseRegressor<f64>>::Row::filled(0.0));
    let mut of_drives = <A as JointRegressor<f64>>::Terms::filled([0.0; COEFFICIENTS]);
    for (k, State { q, u, u_dot }) in states.iter().enumerate() {
        arm.base_regressor(q, u, u_dot, &mut of_bodies);
        arm.joint_regressor(q, u, u_dot, &mut of_drives);
        for i in 0..joints {
            let mut row = w.row_mut(joints * k + i);
            for (j, entry) in of_bodies[i].as_ref().iter().enumerate() {
                row[j] = entry / scale[i];
            }
            for (j, entry) in of_drives[i].iter().enumerate() {
                row[base + COEFFICIENTS * i + j] = entry / scale[i];
            }
        }
    }
    w
}

/// Torques, one above the other, divided by the joints' `scale`.
pub fn stack_torques<A: Arm>(torques: &[A::U], scale: &A::U) -> DVector<f64> {
    let joints = A::SPEED_NAMES.len();
    DVector::from_fn(joints * torques.len(), |row, _| {
        torques[row / joints][row % joints] / scale[row % joints]
    })
}
