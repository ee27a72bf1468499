//! Seeded random trees of which about half have coordinates that move no mass.

use std::fmt::Write as _;

use crate::description::{CoordinateName, toml};
use crate::diagnostic::Source;
use crate::random::Random;
use crate::tree::Tree;
use crate::tree::assembly::{Settled, assemble};
use crate::tree::joints;
use crate::tree::numbering::outward;
use crate::tree::rotations::exact;

/// What joints a tree has.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Style {
    /// Lists of free coordinates between the bodies' own frames.
    Plain,
    /// Between turned frames, along axes and anyhow, with rotors; some bodies fixed.
    Framed,
    /// As `Framed`, and some follow others.
    Following,
}

/// A tree in which much is zero or aligned, so that about half of all trees have idle coordinates.
pub(super) fn tree(random: &mut Random, style: Style) -> Tree {
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
        let mut joint: Vec<&str> = CoordinateName::NAMES
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
pub(super) fn built(text: &str) -> Tree {
    let description = toml::parse(&Source::new("s", text));
    let mut findings = Vec::new();
    let outward = outward(&description, &mut findings).unwrap();
    let (rotations, _) = exact(&description, 0.0);
    let joints = joints::joints(&description, &rotations);
    let joints = joints.into_iter().flatten().collect();
    let joints = joints::follow(&description, joints, &mut findings);
    let settled = Settled {
        description: &description,
        outward: &outward,
        joints: &joints,
        rotations: &rotations,
        snap: 1e-9,
    };
    assemble(settled, &mut findings).unwrap()
}
