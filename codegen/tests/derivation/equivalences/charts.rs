//! Other charts and speeds: quaternions or angles, their rates or angular velocities.

use kane_codegen::{
    id::CoordinateId,
    tree::{ChartCoordinates, Orientation},
};
use kane_test_support::{
    compare::larger,
    dynamics::{Model, State, quantities::DIFFERENTIATED},
    numeric::derivative,
    rotation::{quaternion_of, rate_columns},
    systems::{tree, trees::least},
};

use super::pair::{Mapped, agree, is_ball, plain, seeds, system};
use crate::evaluator::Evaluator;

/// The speeds of rates become angular velocities, and the angles whatever the other has.
fn to_angular_velocities(a: &Evaluator, b: &Evaluator, state: &State) -> Mapped {
    let mut mapped = Mapped::new(a.tree(), b.tree());
    for body in a.tree().body_ids() {
        let Orientation::AngularVelocity { chart, speeds } = b.tree().body(body).joint.orientation
        else {
            for places in plain(a.tree(), body).iter().zip(&plain(b.tree(), body)) {
                mapped.copy(&state.q, places);
            }
            continue;
        };
        let own = plain(a.tree(), body);
        let angles = [0, 1, 2].map(|i| state.q[own[i][0]]);
        let rates = [0, 1, 2].map(|i| state.u[own[i][1]]);
        let places: Vec<CoordinateId> = match chart {
            ChartCoordinates::Angles(places) => places.to_vec(),
            ChartCoordinates::EulerParameters(places) => places.to_vec(),
        };
        let values = match chart {
            ChartCoordinates::Angles(_) => angles.to_vec(),
            ChartCoordinates::EulerParameters(_) => quaternion_of(angles).to_vec(),
        };
        for (place, value) in places.into_iter().zip(values) {
            mapped.q[place.index()] = value;
        }
        let columns = |t: f64| {
            let moved = [0, 1, 2].map(|i| angles[i] + t * rates[i]);
            rate_columns(moved)
                .into_iter()
                .flatten()
                .collect::<Vec<f64>>()
        };
        let (now, change) = (columns(0.0), derivative(columns));
        for (column, places) in own.iter().take(3).enumerate() {
            for (row, speed) in speeds.into_iter().enumerate() {
                mapped.t[speed.index()][places[1]] = now[3 * column + row];
                mapped.t_dot[speed.index()][places[1]] = change[3 * column + row];
            }
        }
        for places in own[3..].iter().zip(&plain(b.tree(), body)) {
            mapped.copy(&state.q, places);
        }
    }
    mapped
}

#[test]
fn bodies_accelerate_alike_in_every_chart() {
    let mut most = 0.0;
    let mut n_compared = 0;
    for seed in seeds() {
        let system = system(seed).with_free_balls();
        let rates = system.in_chart("angles", "rates");
        let moves = tree(&rates.toml());
        for chart in ["angles", "quaternion"] {
            let other = system.in_chart(chart, "angular_velocity");
            let tree = tree(&other.toml());
            assert_eq!(tree.is_some(), moves.is_some(), "seed {seed}, {chart}");
            // Without its rotor a ball can move no mass.
            let Some(tree) = tree.filter(|tree| tree.bodies.iter().any(is_ball)) else {
                continue;
            };
            assert_eq!(tree.has_quaternions(), chart == "quaternion");
            let pair = [&rates, &other];
            most = larger(
                most,
                agree(DIFFERENTIATED, seed, pair, to_angular_velocities),
            );
            n_compared += 1;
        }
    }
    println!("largest error {most:e} of {n_compared}");
    assert!(n_compared >= least(20), "{n_compared} pairs");
}
