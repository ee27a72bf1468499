//! The sweep against a dense matrix: the velocities of all bodies, column by column.

use std::fmt::Write as _;

use crate::description::Axis;
use crate::expr::Input;
use crate::functions::{Formulation, Function};
use crate::id::BodyId;
use crate::random::Random;
use crate::tree::Tree;
use crate::tree::assembly::{Settled, assemble};
use crate::tree::joints;
use crate::tree::mobility::following;
use crate::tree::mobility::masses::own;
use crate::tree::mobility::response::moved_along;
use crate::tree::mobility::rows::{Twist, dot, project_out};
use crate::tree::mobility::sweep::{SweptJoint, inward};
use crate::tree::mobility::units::Units;
use crate::tree::numbering::outward;
use crate::tree::rotations::exact;

/// What joints a tree has.
#[derive(Clone, Copy, PartialEq)]
enum Style {
    /// Lists of free coordinates between the bodies' own frames.
    Plain,
    /// Between turned frames, along axes and anyhow, with rotors; some bodies fixed.
    Framed,
    /// As `Framed`, and some follow others.
    Following,
}

/// A tree in which much is zero or aligned, so that about half of all trees have idle coordinates.
fn tree(random: &mut Random, style: Style) -> Tree {
    let mut pick = |n: f64| ((random.signed() + 1.0) * 0.5 * n).floor();
    let n_bodies = 1.0 + pick(5.0);
    let mut lower = Vec::new();
    let mut text = String::new();
    let mut singles: Vec<u8> = Vec::new();
    for body in 0..6_u8 {
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
             inertia = {{ xx = {xx:?}, yy = {xx:?}, zz = {zz:?}, xy = 0.0, xz = 0.0, yz = 0.0 }}\n",
            q[0], q[1]
        )
        .unwrap();
        if style == Style::Plain {
            writeln!(text, "joint = {joint:?}").unwrap();
            continue;
        }
        let (named, is_single) = framed(&mut pick, body == 0, &joint);
        text += &named;
        if style == Style::Following && is_single {
            let leader = singles.get(index(pick(2.0 * singles.len() as f64)));
            if let Some(leader) = leader {
                let multiplier = [1.0, -1.0, 0.5][index(pick(3.0))];
                writeln!(
                    text,
                    "mimic = {{ joint = \"b{leader}\", multiplier = {multiplier:?} }}"
                )
                .unwrap();
            }
            singles.push(body);
        }
    }
    let lower: Vec<String> = lower.iter().map(|lower| format!("{lower:.0}")).collect();
    let text = format!(
        "name = \"s\"\nlower_bodies = [{}]\n{text}",
        lower.join(", ")
    );
    built(&text)
}

fn index(whole: f64) -> usize {
    let mut places = 0..100_u8;
    places.position(|place| f64::from(place) == whole).unwrap()
}

/// The keys of a joint, and whether it has a single coordinate; the first one moves.
fn framed(pick: &mut dyn FnMut(f64) -> f64, is_first: bool, list: &[&str]) -> (String, bool) {
    const TURNS: [&str; 4] = [
        "[[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]]",
        "[[0.0, 0.0, -1.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]]",
        "[[0.6, 0.8, 0.0], [-0.8, 0.6, 0.0], [0.0, 0.0, 1.0]]",
        "[[0.48, 0.6, -0.64], [-0.8, 0.6, 0.0], [0.384, 0.512, 0.768]]",
    ];
    let kinds = [
        "\"fixed\"",
        "\"revolute\"",
        "\"revolute\"",
        "\"prismatic\"",
        "\"cylindrical\"",
        "\"planar\"",
        "\"spherical\"",
        "\"free\"",
        &format!("{list:?}"),
    ];
    let place = index(if is_first { 1.0 + pick(8.0) } else { pick(9.0) });
    let mut text = format!("joint = {}\n", kinds[place]);
    if (1..6).contains(&place) {
        let axis = ["[0.0, 0.0, 1.0]", "[0.0, -1.0, 0.0]", "[1.0, 2.0, 2.0]"];
        writeln!(text, "axis = {}", axis[index(pick(3.0))]).unwrap();
    }
    if (6..8).contains(&place) {
        text += [
            "",
            "chart = \"quaternion\"\n",
            "speeds = \"angular_velocity\"\n",
        ][index(pick(3.0))];
    }
    for key in ["attachment_rotation", "body_rotation"] {
        if let Some(turn) = TURNS.get(index(pick(8.0))) {
            writeln!(text, "{key} = {turn}").unwrap();
        }
    }
    if pick(3.0) == 0.0 {
        text += "body_attachment = [0.0, 0.5, 0.0]\n";
    }
    if pick(5.0) == 0.0 {
        text += "armature = 0.1\n";
    }
    let is_single = (1..4).contains(&place) || (place == 8 && list.len() == 1);
    (text, is_single)
}

/// The tree of a description, whatever moves no mass.
fn built(text: &str) -> Tree {
    let description = crate::description::toml::parse(&crate::diagnostic::Source::new("s", text));
    let mut findings = Vec::new();
    let outward = outward(&description, &mut findings).unwrap();
    let (rotations, _) = exact(&description, 0.0);
    let joints = joints::joints(&description, &rotations);
    let mut joints: Vec<_> = joints.into_iter().flatten().collect();
    joints::follow(&description, &mut joints, &mut findings);
    let settled = Settled {
        description: &description,
        outward: &outward,
        joints: &joints,
        rotations: &rotations,
        snap: 1e-9,
    };
    assemble(settled, &mut findings).unwrap()
}

/// The most that the mass matrix has in rank in a few states.
fn rank_of_mass_matrix(tree: &Tree, seed: u64) -> usize {
    let function = Function::find("mass_matrix").unwrap();
    let derived = function.derive(
        tree,
        Formulation::Recursive,
        &crate::recursive::Plan::full(tree),
    );
    let of_state = |seed| {
        let mut random = Random::new(seed);
        let mut q: Vec<f64> = (0..tree.n_coordinates).map(|_| random.signed()).collect();
        for body in &tree.bodies {
            let all = body.joint.coordinates();
            let e: Vec<usize> = all
                .iter()
                .filter(|(kind, _)| kind.starts_with('e'))
                .map(|(_, at)| at.index())
                .collect();
            let length = e.iter().map(|&at| q[at] * q[at]).sum::<f64>().sqrt();
            for at in e {
                q[at] /= length;
            }
        }
        let m = derived.graph.evaluate(&derived.roots, |input| match input {
            Input::Q(at) => q[at.index()],
            other => unreachable!("{other:?} in a mass matrix of numbers"),
        });
        rank_of_energies(m.chunks(tree.n_speeds).map(<[f64]>::to_vec).collect())
    };
    (seed..seed + 3).map(of_state).max().unwrap()
}

/// The rank of a symmetric matrix that is not negative: Cholesky's pivots, the largest first.
fn rank_of_energies(mut m: Vec<Vec<f64>>) -> usize {
    let mut left: Vec<usize> = (0..m.len()).collect();
    let mut rank = 0;
    while let Some(at) =
        (0..left.len()).max_by(|&a, &b| m[left[a]][left[a]].total_cmp(&m[left[b]][left[b]]))
    {
        let pivot = left.remove(at);
        // Energies are of order one, so this is far above rounding and below what chance leaves.
        if m[pivot][pivot] < 1e-10 {
            break;
        }
        for &row in &left {
            let factor = m[row][pivot] / m[pivot][pivot];
            for &column in &left {
                m[row][column] -= factor * m[pivot][column];
            }
        }
        rank += 1;
    }
    rank
}

/// For each free coordinate, body by body, the root of the mass times the velocity of everything.
fn velocities(
    tree: &Tree,
    units: &Units,
    joints: &[SweptJoint],
) -> Vec<((BodyId, Axis), Vec<f64>)> {
    let mut columns = Vec::new();
    for moving in tree.body_ids() {
        for (axis, unit) in joints[moving.index()]
            .free
            .axes
            .iter()
            .zip(&joints[moving.index()].free.columns)
        {
            let mut twists: Vec<Twist> = Vec::new();
            let mut column = Vec::new();
            for body in tree.body_ids() {
                let lower = tree
                    .lower(body)
                    .map_or([0.0; 6], |lower| twists[lower.index()]);
                let carried = joints[body.index()].free.carried;
                let mut twist: Twist =
                    std::array::from_fn(|row| (0..6).map(|i| carried[i][row] * lower[i]).sum());
                if body == moving {
                    twist = *unit;
                }
                // Rotors move with their own speeds alone.
                for (other, rotor) in joints[body.index()]
                    .free
                    .axes
                    .iter()
                    .zip(&joints[body.index()].free.rotors)
                {
                    let is_own = body == moving && other == axis;
                    column.push(if is_own { *rotor } else { 0.0 });
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

/// How many motions of a tree with followers move no mass.
fn n_coupled_idle(text: &str) -> usize {
    let tree = built(text);
    let idle = |seed| following::idle(&tree, &Units::of(&tree), &mut Random::new(seed)).len();
    (1..4).map(idle).min().unwrap()
}

/// A body without mass, or a ball of it.
fn weight(name: &str, mass: f64, joint: &str) -> String {
    format!(
        "[[body]]\nname = \"{name}\"\nmass = {mass:?}\nmass_center = [0.0, 0.0, 0.0]\nattachment = [0.0, 0.0, 0.3]\n\
         inertia = {{ xx = {mass:?}, yy = {mass:?}, zz = {mass:?}, xy = 0.0, xz = 0.0, yz = 0.0 }}\n{joint}\n"
    )
}

#[test]
fn the_rotor_of_what_follows_moves_with_what_it_follows() {
    let idle = |rotor: &str| {
        let follower = format!("joint = [\"theta1\"]\nmimic = {{ joint = \"a\" }}\n{rotor}");
        let bodies = weight("a", 0.0, "joint = [\"theta1\"]") + &weight("b", 0.0, &follower);
        n_coupled_idle(&format!("name = \"s\"\nlower_bodies = [0, 0]\n{bodies}"))
    };
    assert_eq!((idle(""), idle("armature = 0.1")), (1, 0));
}

#[test]
fn mass_beyond_what_follows_moves_with_what_it_follows() {
    let bodies = [
        weight("a", 0.0, "joint = [\"s1\"]"),
        weight("b", 0.0, "joint = [\"s1\"]\nmimic = { joint = \"a\" }"),
        weight("tip", 1.0, "joint = [\"theta2\"]"),
    ];
    let text = format!(
        "name = \"s\"\nlower_bodies = [0, 0, 2]\n{}",
        bodies.concat()
    );
    assert_eq!(n_coupled_idle(&text), 0);
}

#[test]
fn motions_that_cancel_one_another_move_no_mass() {
    let idle = |multiplier: f64| {
        let follows =
            format!("joint = [\"s1\"]\nmimic = {{ joint = \"a\", multiplier = {multiplier:?} }}");
        let bodies = weight("a", 0.0, "joint = [\"s1\"]") + &weight("b", 1.0, &follows);
        n_coupled_idle(&format!("name = \"s\"\nlower_bodies = [0, 1]\n{bodies}"))
    };
    assert_eq!((idle(-1.0), idle(-0.5)), (1, 0));
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
