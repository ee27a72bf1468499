//! The sweep against a dense matrix: the velocities of all bodies, column by column.

use std::fmt::Write as _;

use crate::description::Axis;
use crate::id::BodyId;
use crate::tree::Tree;
use crate::tree::assemble::assemble;
use crate::tree::rows::{Random, Twist, dot, project_out};
use crate::tree::sweep::{Joint, Units, inward, moved_along, own};
use crate::tree::{Changes, resolve};

/// A tree in which much is zero or aligned, so that about half of all trees have idle coordinates.
fn tree(random: &mut Random) -> Tree {
    let mut pick = |n: f64| ((random.signed() + 1.0) * 0.5 * n).floor();
    let n_bodies = 1.0 + pick(5.0);
    let mut lower = Vec::new();
    let mut text = String::new();
    for body in 0..6 {
        if f64::from(body) >= n_bodies {
            break;
        }
        lower.push(pick(f64::from(body) + 1.0));
        // Massless, a point, a rod along z, a solid body.
        let kind = pick(4.0);
        let mass = if kind == 0.0 { 0.0 } else { 2.0 };
        let [xx, zz] = [
            if kind >= 2.0 { 0.3 } else { 0.0 },
            if kind >= 3.0 { 0.2 } else { 0.0 },
        ];
        let [x, z] = [pick(2.0), pick(2.0) - 0.5];
        let q = [pick(2.0), pick(2.0) * 0.7];
        let mut joint: Vec<&str> = Axis::NAMES
            .into_iter()
            .filter(|_| pick(3.0) == 0.0)
            .collect();
        if joint.is_empty() {
            joint.push("theta3");
        }
        write!(
            text,
            "[[body]]\nname = \"b{body}\"\nmass = {mass:?}\nmass_center = [{x:?}, 0.0, {z:?}]\nattachment = [0.0, {:?}, {:?}]\n\
             inertia = {{ xx = {xx:?}, yy = {xx:?}, zz = {zz:?}, xy = 0.0, xz = 0.0, yz = 0.0 }}\njoint = {joint:?}\n",
            q[0], q[1]
        )
        .unwrap();
    }
    let lower: Vec<String> = lower.iter().map(|lower| format!("{lower:.0}")).collect();
    let text = format!(
        "name = \"s\"\nlower_bodies = [{}]\n{text}",
        lower.join(", ")
    );
    let description = crate::description::toml::parse(&crate::diagnostic::Source::new("s", text));
    let places: Vec<usize> = (0..lower.len()).collect();
    let joints = resolve::joints(&description, 0.0);
    let joints: Vec<_> = joints.into_iter().flatten().collect();
    let changes = Changes::default();
    assemble(&description, &places, &joints, &changes, &mut Vec::new()).unwrap()
}

/// For each free coordinate, body by body, the root of the mass times the velocity of everything.
fn velocities(tree: &Tree, units: &Units, joints: &[Joint]) -> Vec<((BodyId, Axis), Vec<f64>)> {
    let mut columns = Vec::new();
    for moving in tree.body_ids() {
        for (axis, unit) in joints[moving.index()]
            .axes
            .iter()
            .zip(&joints[moving.index()].columns)
        {
            let mut twists: Vec<Twist> = Vec::new();
            let mut column = Vec::new();
            for body in tree.body_ids() {
                let lower = tree
                    .lower(body)
                    .map_or([0.0; 6], |lower| twists[lower.index()]);
                let carried = joints[body.index()].carried;
                let mut twist: Twist =
                    std::array::from_fn(|row| (0..6).map(|i| carried[i][row] * lower[i]).sum());
                if body == moving {
                    twist = *unit;
                }
                column.extend(
                    own(tree, units, body)
                        .rows
                        .iter()
                        .map(|row| dot(row, &twist)),
                );
                twists.push(twist);
            }
            columns.push(((moving, *axis), column));
        }
    }
    columns
}

fn rank(mut columns: Vec<Vec<f64>>) -> usize {
    let norm = |column: &Vec<f64>| dot(column, column).sqrt();
    let mut rank = 0;
    while let Some(largest) =
        (0..columns.len()).max_by(|a, b| norm(&columns[*a]).total_cmp(&norm(&columns[*b])))
    {
        let column = columns.swap_remove(largest);
        // Entries are of order one, so this is far above rounding and far below what chance leaves.
        if norm(&column) < 1e-7 {
            break;
        }
        let unit: Vec<f64> = column.iter().map(|entry| entry / norm(&column)).collect();
        for other in &mut columns {
            project_out(other, &unit);
        }
        rank += 1;
    }
    rank
}

#[test]
fn idle_coordinates_are_what_the_dense_matrix_lacks_in_rank() {
    let mut singular = 0;
    for seed in 0..400 {
        let tree = tree(&mut Random::new(seed));
        let units = Units::of(&tree);
        let joints = inward(&tree, &units, &mut Random::new(seed));
        let columns = velocities(&tree, &units, &joints);
        let idle: usize = joints.iter().map(|joint| joint.idle.len()).sum();
        let dense = rank(columns.iter().map(|(_, column)| column.clone()).collect());
        assert_eq!(idle, columns.len() - dense, "seed {seed}");
        singular += usize::from(idle > 0);
    }
    assert!(
        (50..350).contains(&singular),
        "{singular} of 400 trees are singular, so the test says little"
    );
}

#[test]
fn named_coordinates_move_no_mass_and_none_is_superfluous() {
    for seed in 0..400 {
        let tree = tree(&mut Random::new(seed));
        let units = Units::of(&tree);
        let joints = inward(&tree, &units, &mut Random::new(seed));
        let columns = velocities(&tree, &units, &joints);
        for body in tree.body_ids() {
            for idle in 0..joints[body.index()].idle.len() {
                let motion = moved_along(&tree, &joints, body, idle);
                let of = |named: &[(BodyId, Axis)]| -> Vec<Vec<f64>> {
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
