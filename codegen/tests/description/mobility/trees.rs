//! Seeded random trees of which about half have coordinates that move no mass.

use std::fmt::Write as _;

use kane_codegen::description::CoordinateName;
use kane_codegen::tree::{Tree, Value};
use kane_test_support::{
    models::{body, build},
    random::Random,
};

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

/// The text of a tree of solid bodies, and what becomes of these.
pub(super) struct Drawn {
    lower: Vec<f64>,
    bodies: String,
    /// Names of parameters, and their values.
    changed: Vec<(String, f64)>,
}

/// A tree in which much is zero or aligned, so that about half of all trees have idle coordinates.
pub(super) fn tree(random: &mut Random, style: Style) -> Tree {
    drawn(random, style).tree()
}

/// As [`tree`], before it is built.
pub(super) fn drawn(random: &mut Random, style: Style) -> Drawn {
    let mut pick = |n: f64| ((random.symmetric() + 1.0) * 0.5 * n).floor();
    let n_bodies = 1.0 + pick(5.0);
    let mut lower = Vec::new();
    let mut text = String::new();
    let mut changed = Vec::new();
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
            "[[body]]\nname = \"b{body}\"\nmass = {{ runtime = 2.0 }}\nmass_center = [{x:?}, 0.0, {z:?}]\nattachment = [0.0, {:?}, {:?}]\n\
             inertia = {{ xx = {{ runtime = 0.3 }}, yy = {{ runtime = 0.3 }}, zz = {{ runtime = 0.2 }}, xy = 0.0, xz = 0.0, yz = 0.0 }}\n",
            q[0], q[1]
        )
        .unwrap();
        changed.extend(
            [
                ("mass", mass),
                ("inertia_xx", xx),
                ("inertia_yy", xx),
                ("inertia_zz", zz),
            ]
            .map(|(quantity, value)| (format!("b{body}_{quantity}"), value)),
        );
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
    Drawn {
        lower,
        bodies: text,
        changed,
    }
}

impl Drawn {
    /// With two solid bodies on the inertial frame, of which one follows the other.
    pub(super) fn with_followers(mut self) -> Self {
        self.lower.extend([0.0; 2]);
        self.bodies += &body("leader", "[\"s1\"]");
        self.bodies += &body("follower", "[\"s1\"]\nmimic = { joint = \"leader\" }");
        self
    }

    /// The tree, whatever moves no mass.
    pub(super) fn tree(&self) -> Tree {
        let lower = self.lower.iter().map(|lower| format!("{lower:.0}"));
        let text = format!(
            "name = \"s\"\nlower_bodies = [{}]\n{}",
            lower.collect::<Vec<_>>().join(", "),
            self.bodies
        );
        let checked = build(&text).unwrap_or_else(|faults| panic!("{faults}\n{text}"));
        let mut tree = checked.tree;
        for (name, value) in &self.changed {
            let mut parameters = tree.parameters.iter_mut();
            let parameter = parameters.find(|parameter| parameter.name == *name);
            parameter.unwrap().nominal = *value;
        }
        let parameters = std::mem::take(&mut tree.parameters);
        let bake = |value: &mut Value| *value = Value::Baked(value.nominal(&parameters));
        for part in tree.bodies.iter_mut().flat_map(|body| &mut body.parts) {
            let of = &mut part.inertia;
            [&mut part.mass, &mut of.xx, &mut of.yy, &mut of.zz]
                .into_iter()
                .for_each(bake);
        }
        tree
    }
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
        "[[0.48, 0.64, -0.6], [-0.8, 0.6, 0.0], [0.36, 0.48, 0.8]]",
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
    // What is fixed has no rotor.
    if pick(5.0) == 0.0 && place > 0 {
        text += "armature = 0.1\n";
    }
    let is_single = (1..4).contains(&place) || (place == 8 && list.len() == 1);
    (text, is_single)
}
