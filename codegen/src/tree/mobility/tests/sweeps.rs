//! The sweeps against dense matrices, on random trees.

use crate::description::CoordinateName;
use crate::id::BodyId;
use crate::random::Random;
use crate::tree::mobility::following;
use crate::tree::mobility::response::moved_along;
use crate::tree::mobility::sweep::inward;
use crate::tree::mobility::tests::dense::{rank, rank_of_mass_matrix, velocities};
use crate::tree::mobility::tests::trees::{Style, tree};
use crate::tree::mobility::units::Units;

#[test]
fn idle_coordinates_are_what_the_dense_matrix_lacks_in_rank() {
    for style in [Style::Plain, Style::Framed] {
        idle_coordinates_are_counted(style);
    }
}

fn idle_coordinates_are_counted(style: Style) {
    let mut singular = 0;
    for seed in 0..400 {
        let tree = tree(&mut Random::new(seed), style);
        let units = Units::of(&tree);
        let joints = inward(&tree, &units, &mut Random::new(seed));
        let columns = velocities(&tree, &units, &joints);
        let idle: usize = joints.iter().map(|joint| joint.idle.len()).sum();
        let dense = rank(columns.iter().map(|(_, column)| column.clone()).collect());
        assert_eq!(idle, columns.len() - dense, "seed {seed}");
        let rank = rank_of_mass_matrix(&tree, seed);
        assert_eq!(dense, rank, "seed {seed}: the mass matrix");
        singular += usize::from(idle > 0);
    }
    assert!(
        (50..350).contains(&singular),
        "{singular} of 400 trees are singular, so the test says little"
    );
}

#[test]
fn named_coordinates_move_no_mass_and_none_is_superfluous() {
    for seed in 0..800 {
        let style = [Style::Plain, Style::Framed][usize::from(seed >= 400)];
        let tree = tree(&mut Random::new(seed), style);
        let units = Units::of(&tree);
        let joints = inward(&tree, &units, &mut Random::new(seed));
        let columns = velocities(&tree, &units, &joints);
        for body in tree.body_ids() {
            for idle in 0..joints[body.index()].idle.len() {
                let motion = moved_along(&tree, &joints, body, idle);
                let of = |named: &[(BodyId, CoordinateName)]| -> Vec<Vec<f64>> {
                    columns
                        .iter()
                        .filter(|(coordinate, _)| named.contains(coordinate))
                        .map(|(_, column)| column.clone())
                        .collect()
                };
                assert_eq!(
                    rank(of(&motion)),
                    motion.len() - 1,
                    "seed {seed}: {motion:?}"
                );
                for place in 0..motion.len() {
                    let mut fewer = motion.clone();
                    fewer.remove(place);
                    assert_eq!(
                        rank(of(&fewer)),
                        fewer.len(),
                        "seed {seed}: {motion:?} without {:?}",
                        motion[place]
                    );
                }
            }
        }
    }
}

#[test]
fn idle_motions_with_followers_are_what_the_mass_matrix_lacks_in_rank() {
    let mut singular = 0;
    for seed in 0..1000 {
        let tree = tree(&mut Random::new(seed), Style::Following);
        let units = Units::of(&tree);
        let idle = |seed| following::idle(&tree, &units, &mut Random::new(seed)).len();
        let idle = (1..4).map(idle).min().unwrap();
        let lacking = tree.n_speeds - rank_of_mass_matrix(&tree, seed);
        assert_eq!(idle, lacking, "seed {seed}");
        singular += usize::from(idle > 0);
    }
    assert!((100..900).contains(&singular), "{singular} of 1000");
}

#[test]
fn idle_coordinates_are_counted_alike_with_and_without_followers() {
    for seed in 0..400 {
        let style = [Style::Plain, Style::Framed][usize::from(seed >= 200)];
        let tree = tree(&mut Random::new(seed), style);
        let units = Units::of(&tree);
        let swept = |seed| {
            let joints = inward(&tree, &units, &mut Random::new(seed));
            joints.iter().map(|joint| joint.idle.len()).sum::<usize>()
        };
        let dense = |seed| following::idle(&tree, &units, &mut Random::new(seed)).len();
        let least = |count: &dyn Fn(u64) -> usize| (seed..seed + 3).map(count).min();
        assert_eq!(least(&dense), least(&swept), "seed {seed}");
    }
}
