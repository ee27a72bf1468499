//! The motions that are found, against mass matrices, on random trees.

use kane_codegen::description::CoordinateName;
use kane_codegen::id::BodyId;
use kane_codegen::tree::{Tree, idle_motions};
use kane_test_support::random::Random;

use super::mass_matrix::MassMatrices;
use super::trees::{Style, drawn, tree};

/// All that move no mass.
fn idle(tree: &Tree) -> Vec<Vec<(BodyId, CoordinateName)>> {
    idle_motions(tree, usize::MAX)
}

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
        let idle = idle(&tree).len();
        let rank = MassMatrices::of(&tree, seed).rank();
        assert_eq!(idle, tree.n_speeds - rank, "seed {seed}");
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
        let motions = idle(&tree);
        if motions.is_empty() {
            continue;
        }
        let matrices = MassMatrices::of(&tree, seed);
        for motion in motions {
            let speeds: Vec<usize> = motion
                .iter()
                .map(|coordinate| speed(&tree, *coordinate))
                .collect();
            assert_eq!(
                matrices.rank_of(&speeds),
                motion.len() - 1,
                "seed {seed}: {motion:?}"
            );
            for place in 0..motion.len() {
                let mut fewer = speeds.clone();
                fewer.remove(place);
                assert_eq!(
                    matrices.rank_of(&fewer),
                    fewer.len(),
                    "seed {seed}: {motion:?} without {:?}",
                    motion[place]
                );
            }
        }
    }
}

/// The place of the speed of a coordinate.
fn speed(tree: &Tree, (body, coordinate): (BodyId, CoordinateName)) -> usize {
    let mut speeds = tree.body(body).joint.speeds().into_iter();
    let own = speeds.find(|(motion, _)| CoordinateName::ALL[*motion] == coordinate);
    own.unwrap().1.index()
}

#[test]
fn idle_motions_with_followers_are_what_the_mass_matrix_lacks_in_rank() {
    let mut singular = 0;
    for seed in 0..1000 {
        let tree = tree(&mut Random::new(seed), Style::Following);
        let idle = idle(&tree).len();
        let rank = MassMatrices::of(&tree, seed).rank();
        assert_eq!(idle, tree.n_speeds - rank, "seed {seed}");
        singular += usize::from(idle > 0);
    }
    assert!((100..900).contains(&singular), "{singular} of 1000");
}

/// Where one follows another anywhere, all velocities are written down at once.
#[test]
fn idle_coordinates_are_counted_alike_with_and_without_followers() {
    for seed in 0..400 {
        let style = [Style::Plain, Style::Framed][usize::from(seed >= 200)];
        let [without, with] = [
            drawn(&mut Random::new(seed), style).tree(),
            drawn(&mut Random::new(seed), style).with_followers().tree(),
        ];
        assert!(with.has_followers() && !without.has_followers());
        assert_eq!(idle(&with).len(), idle(&without).len(), "seed {seed}");
    }
}
