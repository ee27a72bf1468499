//! Bodies that are fixed merged by hand, and joints that follow others projected out by hand.

use kane_codegen::functions::Formulation;
use kane_test_support::{
    compare::{assert_within, larger},
    dynamics::{Model, State, agreement::disagreement, quantities::EXACT},
    systems::{tree, trees::least},
};

use super::pair::{Mapped, agree, is_ball, plain, seeds, system};
use crate::evaluator::Evaluator;

#[test]
fn what_is_fixed_is_as_if_merged_by_hand() {
    let mut most = 0.0;
    let (mut n_compared, mut n_runtime) = (0, 0);
    for seed in seeds() {
        // One body has one share of its weight lifted, but what is fixed to it may have another.
        let system = system(seed).unlifted();
        if !system.has_fixed() {
            continue;
        }
        let given = Evaluator::new(&system, Formulation::Recursive);
        let merged = Evaluator::new(&system.merged(), Formulation::Recursive);
        assert!(merged.tree().frames.len() < given.tree().frames.len());
        let state = State::random(given.tree(), seed);
        let (error, function) = disagreement(&given, &merged, |_| true, &state);
        assert_within(format!("seed {seed}, {function}"), error, EXACT);
        most = larger(most, error);
        n_compared += 1;
        n_runtime += u64::from(!given.tree().parameters.is_empty());
    }
    println!("largest error {most:e} of {n_compared}, {n_runtime} with runtime values");
    assert!(
        n_compared >= least(15) && n_runtime >= least(5),
        "{n_compared}, {n_runtime}"
    );
}

/// A joint that follows another has a coordinate of its own in the other description.
fn to_freed(a: &Evaluator, b: &Evaluator, state: &State) -> Mapped {
    let mut mapped = Mapped::new(a.tree(), b.tree());
    for body in a.tree().body_ids() {
        for places in plain(a.tree(), body).iter().zip(&plain(b.tree(), body)) {
            mapped.copy(&state.q, places);
        }
        let [of_a, of_b] = [a, b].map(|model| &model.tree().body(body).joint);
        if is_ball(a.tree().body(body)) {
            let coordinates = of_a.coordinates().into_iter().zip(of_b.coordinates());
            for ((_, coordinate), (_, coordinate_b)) in coordinates {
                mapped.q[coordinate_b.index()] = state.q[coordinate.index()];
            }
            for ((_, speed), (_, speed_b)) in of_a.speeds().into_iter().zip(of_b.speeds()) {
                mapped.t[speed_b.index()][speed.index()] = 1.0;
            }
        }
    }
    for (place, body) in a.composition().followers() {
        let link = a.composition().link(place);
        let [coordinate, speed] = plain(b.tree(), body)[0];
        mapped.q[coordinate] = link.value(&state.q);
        let [_, leader] = link.places.expect("what moves follows what moves");
        mapped.t[speed][leader] = link.multiplier;
    }
    mapped
}

#[test]
fn what_follows_is_as_if_projected_by_hand() {
    let mut most = 0.0;
    let mut n_compared = 0;
    for seed in seeds() {
        let system = system(seed).with_moving_followers();
        let freed = system.without_followers();
        let trees = [&system, &freed].map(|system| tree(&system.toml()));
        let [Some(given), Some(free)] = trees else {
            // Without followers a massless body can be left to itself.
            continue;
        };
        if given.n_speeds == free.n_speeds {
            continue;
        }
        most = larger(most, agree(EXACT, seed, [&system, &freed], to_freed));
        n_compared += 1;
    }
    println!("largest error {most:e} of {n_compared}");
    assert!(n_compared >= least(12), "{n_compared}");
}
