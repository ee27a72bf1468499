//! What acts in joints: springs, dampers, rotors and friction.

use kane_codegen::tree::{Joint, Mechanics, Tree};
use serde_json::{Map, Value};

/// What acts along a motion.
struct Kind {
    /// Its key, for programs.
    key: &'static str,
    /// Its name with units, of angles and of translations.
    title: &'static str,
    of: fn(&Tree, &Mechanics) -> f64,
}

/// What equations have of it.
const IN_EQUATIONS: [Kind; 4] = [
    Kind {
        key: "stiffness",
        title: "stiffness, N m/rad or N/m",
        of: |tree, own| tree.nominal(own.stiffness),
    },
    Kind {
        key: "rest",
        title: "rest, rad or m",
        of: |tree, own| tree.nominal(own.rest),
    },
    Kind {
        key: "damping",
        title: "damping, N m s/rad or N s/m",
        of: |tree, own| tree.nominal(own.damping),
    },
    Kind {
        key: "armature",
        title: "armature, kg m^2 or kg",
        of: |tree, own| tree.nominal(own.armature),
    },
];
const FRICTION: Kind = Kind {
    key: "friction",
    title: "friction (not in the equations), N m or N",
    of: |_, own| own.friction,
};

/// For people: each kind with its values, as `elbow 0.1`, or `0.1 for all` if all are one.
pub(super) fn told(tree: &Tree) -> Vec<(&'static str, Vec<String>)> {
    let joints = tree.bodies.iter().map(|body| &body.joint);
    let all: Vec<_> = joints.flat_map(motions).collect();
    let kinds = IN_EQUATIONS.into_iter().chain([FRICTION]);
    let told = kinds.filter_map(|Kind { title, of, .. }| {
        let values = all.iter().map(|(name, own)| (name, of(tree, own)));
        let values: Vec<_> = values.collect();
        let (_, first) = values.first()?;
        if values.iter().all(|(_, own)| *own == 0.0) {
            return None;
        }
        let are_one = values
            .iter()
            .all(|(_, own)| own.to_bits() == first.to_bits());
        if are_one && values.len() > 1 {
            return Some((title, vec![format!("{first:?} for all")]));
        }
        let values = values.into_iter().filter(|(_, own)| *own != 0.0);
        let values = values.map(|(name, own)| format!("{name} {own:?}"));
        Some((title, values.collect()))
    });
    told.collect()
}

/// For programs: each kind that equations have, with its values by motions.
pub(super) fn of_joint(tree: &Tree, joint: &Joint) -> Vec<(&'static str, Map<String, Value>)> {
    let kinds = IN_EQUATIONS.into_iter().map(|Kind { key, of, .. }| {
        let values = moving(joint).map(|(name, own)| (name.to_owned(), of(tree, own)));
        let values = values.filter(|(_, own)| *own != 0.0);
        (key, values.map(|(name, own)| (name, own.into())).collect())
    });
    kinds
        .filter(|(_, values): &(_, Map<_, _>)| !values.is_empty())
        .collect()
}

/// What moves in a joint, under its full name.
fn motions(joint: &Joint) -> Vec<(String, &Mechanics)> {
    let is_only = moving(joint).count() == 1;
    let named = moving(joint).map(|(name, own)| (joint.name_of(name, is_only), own));
    named.collect()
}

/// What moves in a joint, that which follows others too.
fn moving(joint: &Joint) -> impl Iterator<Item = (&'static str, &Mechanics)> {
    let names = joint.motion_names().into_iter().zip(joint.motions());
    let all = names.zip(&joint.mechanics);
    all.filter_map(|((name, motion), own)| motion.map(|_| (name, own)))
}
