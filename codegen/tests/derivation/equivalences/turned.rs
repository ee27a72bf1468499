//! Frames that are turned alike on both sides of a joint.

use kane_codegen::{
    id::SpeedId,
    tree::{ChartCoordinates, Orientation},
};
use kane_test_support::{
    compare::larger,
    dynamics::{Model, State, quantities::EXACT},
    rotation::{IDENTITY, Rotation, times},
    systems::{tree, trees::least},
};

use super::pair::{Mapped, agree, plain, seeds, system};
use crate::evaluator::Evaluator;

/// The same coordinates, but for orientations and translations of joints that turn in every direction, where their frames
/// are turned.
fn to_turned(
    turns: &[Option<Rotation>],
) -> impl Fn(&Evaluator, &Evaluator, &State) -> Mapped + use<'_> {
    |a, b, state| {
        let mut mapped = Mapped::new(a.tree(), b.tree());
        for body in a.tree().body_ids() {
            let [of_a, of_b] = [a, b].map(|model| plain(model.tree(), body));
            let number = a.tree().body(body).name[1..].parse::<usize>();
            let turn = turns[number.expect("b and a number")].unwrap_or(IDENTITY);
            let [joint_a, joint_b] = [a, b].map(|model| &model.tree().body(body).joint);
            let turns = [joint_a, joint_b].map(|joint| match joint.orientation {
                Orientation::AngularVelocity {
                    chart: ChartCoordinates::EulerParameters(parameters),
                    speeds,
                } => Some((parameters, speeds)),
                _ => None,
            });
            let [Some((e_a, speeds_a)), Some((e_b, speeds_b))] = turns else {
                for places in of_a.iter().zip(&of_b) {
                    mapped.copy(&state.q, places);
                }
                continue;
            };
            let [e0, e1, e2, e3] = e_a.map(|place| state.q[place.index()]);
            let [x, y, z] = times(&turn, [e1, e2, e3]);
            for (place, value) in e_b.into_iter().zip([e0, x, y, z]) {
                mapped.q[place.index()] = value;
            }
            let speeds = |speeds: [SpeedId; 3]| speeds.map(SpeedId::index).to_vec();
            mapped.turn(&turn, (&speeds(speeds_a), &speeds(speeds_b)));
            // All three translations are free, or none, or the joint is not turned.
            let mut shift = [0.0; 3];
            for (shift, [coordinate, _]) in shift.iter_mut().zip(&of_a) {
                *shift = state.q[*coordinate];
            }
            for (shift, [coordinate, _]) in times(&turn, shift).into_iter().zip(&of_b) {
                mapped.q[*coordinate] = shift;
            }
            let speeds = |of: &[[usize; 2]]| of.iter().map(|places| places[1]).collect::<Vec<_>>();
            mapped.turn(&turn, (&speeds(&of_a), &speeds(&of_b)));
        }
        mapped
    }
}

#[test]
fn frames_turned_alike_on_both_sides_change_nothing() {
    let mut most = 0.0;
    let mut n_turned = 0;
    for seed in seeds() {
        let system = system(seed)
            .with_free_balls()
            .in_chart("quaternion", "angular_velocity");
        let (turned, turns) = system.turned(seed);
        let trees = [&system, &turned].map(|system| tree(&system.toml()));
        assert_eq!(trees[0].is_some(), trees[1].is_some(), "seed {seed}");
        // Without its rotor a ball can move no mass.
        if trees[0].is_some() {
            most = larger(
                most,
                agree(EXACT, seed, [&system, &turned], to_turned(&turns)),
            );
            n_turned += turns.iter().flatten().count();
        }
    }
    println!("largest error {most:e} with {n_turned} turned joints");
    assert!(n_turned as u64 >= least(100), "{n_turned} turned joints");
}
