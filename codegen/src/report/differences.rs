//! What differs between two systems.
//!
//! In: two outlines. Out: [`Differences`]. Bodies are the same where they have the same name. Where the tree is the same but for names, what has
//! another name at its old place was renamed; else one that was given another name is one that went and one that came.

use std::collections::BTreeMap;

use super::outline::{AXIS, Body, LOWER, Layout, Outline, Values};
use crate::geometry::{self, Vector};

/// How much unit vectors of one direction may differ, by rounding.
const SAME_DIRECTION: f64 = 1e-15;

/// What differs; nothing where all lists are empty.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Differences {
    /// Arrays whose places or their names changed.
    pub layouts: Vec<LayoutChange>,
    /// Bodies of the new system alone, in its order.
    pub added: Vec<Body>,
    /// Bodies of the old system alone, in its order.
    pub removed: Vec<Body>,
    /// Bodies with another name at their old places in the tree: the old and the new name.
    pub renamed: Vec<[String; 2]>,
    /// What is said otherwise: of the system, then body by body.
    pub values: Vec<ValueChange>,
}

/// An array whose places or their names changed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LayoutChange {
    /// The array.
    pub layout: Layout,
    /// What has a place now and had none, with its place, from 0.
    pub added: Vec<(String, usize)>,
    /// What had a place and has none now, with the one it had.
    pub removed: Vec<(String, usize)>,
    /// What has another place now: the old and the new one.
    pub moved: Vec<(String, [usize; 2])>,
    /// What has another name and its old place: the old and the new name, and the place.
    pub renamed: Vec<([String; 2], usize)>,
}

impl LayoutChange {
    /// True where code that indexes the array by number means something else now, and not only names changed.
    pub fn has_other_places(&self) -> bool {
        !(self.added.is_empty() && self.removed.is_empty() && self.moved.is_empty())
    }
}

/// A value that changed, came or went.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ValueChange {
    /// The body of which it is said; `None` for the system.
    pub body: Option<String>,
    /// What it is: `mass`, `inertia.xx`.
    pub key: String,
    /// What was said; `None` where nothing was.
    pub old: Option<String>,
    /// What is said now.
    pub new: Option<String>,
}

impl Differences {
    /// True where an array's places changed, or their names, by which code may find them.
    pub fn is_breaking(&self) -> bool {
        !self.layouts.is_empty()
    }

    /// True where no body came or went, and arrays are laid out as they were.
    pub fn has_same_bodies(&self) -> bool {
        self.added.is_empty() && self.removed.is_empty() && self.layouts.is_empty()
    }

    /// What a body of the new system was called in the old one, where that was something else.
    pub fn old_name(&self, body: &str) -> Option<&str> {
        let mut renamed = self.renamed.iter();
        let [old, _] = renamed.find(|[_, new]| new == body)?;
        Some(old)
    }
}

impl ValueChange {
    /// True for what makes the tree, and is no number.
    pub fn is_of_the_tree(&self) -> bool {
        let keys = [
            "lower_body",
            "joint",
            "joint_name",
            "axis",
            "chart",
            "speeds",
        ];
        self.body.is_some() && keys.contains(&self.key.as_str())
    }
}

/// Compares two systems.
pub fn differences(old: &Outline, new: &Outline) -> Differences {
    let named = with_names_of(old, new);
    let renamed_bodies = match &named {
        Some(_) => names_that_differ(old, new),
        None => Vec::new(),
    };
    let old = named.as_ref().unwrap_or(old);
    let without = |bodies: &[Body], others: &[Body]| -> Vec<Body> {
        let is_there = |body: &&Body| others.iter().any(|other| other.name == body.name);
        let bodies = bodies.iter().filter(|body| !is_there(body));
        bodies.cloned().collect()
    };
    let mut values = value_changes(None, &old.values, &new.values);
    for body in &new.bodies {
        let mut olds = old.bodies.iter();
        if let Some(old) = olds.find(|old| old.name == body.name) {
            values.extend(value_changes(Some(&body.name), &old.values, &body.values));
        }
    }
    let added = without(&new.bodies, &old.bodies);
    let removed = without(&old.bodies, &new.bodies);
    let mut values_of_the_tree = values.iter().filter(|change| change.is_of_the_tree());
    let names =
        |bodies: &[Body]| -> Vec<String> { bodies.iter().map(|body| body.name.clone()).collect() };
    let is_same_tree = names(&old.bodies) == names(&new.bodies)
        && values_of_the_tree.all(|change| change.key == "joint_name");
    let layouts = old.layouts.iter().zip(&new.layouts);
    let layouts = layouts.filter_map(|((layout, old), (_, new))| {
        let change = layout_change(*layout, old, new)?;
        // Of parameters another one may stand there.
        Some(if is_same_tree && *layout != Layout::Parameters {
            renamed(change)
        } else {
            change
        })
    });
    Differences {
        layouts: layouts.collect(),
        added,
        removed,
        renamed: renamed_bodies,
        values,
    }
}

/// The old and the new names of bodies, place by place.
fn names_that_differ(old: &Outline, new: &Outline) -> Vec<[String; 2]> {
    let pairs = old.bodies.iter().zip(&new.bodies);
    let pairs = pairs.filter(|(old, new)| old.name != new.name);
    pairs
        .map(|(old, new)| [old.name.clone(), new.name.clone()])
        .collect()
}

/// The old system with bodies called as in the new one, if the trees are the same but for names of bodies. Layouts keep the old names.
fn with_names_of(old: &Outline, new: &Outline) -> Option<Outline> {
    let pairs = old.bodies.iter().zip(&new.bodies);
    let pairs = pairs.filter(|(old, new)| old.name != new.name);
    let renamed: BTreeMap<&str, &str> = pairs.map(|(old, new)| (&*old.name, &*new.name)).collect();
    let is_known = |body: &Body| renamed.contains_key(&*body.name);
    if renamed.is_empty() || old.bodies.len() != new.bodies.len() || new.bodies.iter().any(is_known)
    {
        return None;
    }
    let mut named = old.clone();
    let new_name = |name: &mut String| {
        if let Some(new) = renamed.get(&**name) {
            (*new).clone_into(name);
        }
    };
    for body in &mut named.bodies {
        new_name(&mut body.name);
        if let Some(lower) = body.values.get_mut(LOWER) {
            new_name(lower);
        }
    }
    let of_frames = named.values.iter_mut();
    for (_, body) in of_frames.filter(|(key, _)| key.ends_with(": body")) {
        new_name(body);
    }
    let mut bodies = named.bodies.iter().zip(&new.bodies);
    let is_same = bodies.all(|(old, new)| {
        let changes = value_changes(Some(&new.name), &old.values, &new.values);
        let mut of_the_tree = changes.iter().filter(|change| change.is_of_the_tree());
        of_the_tree.all(|change| change.key == "joint_name")
    });
    is_same.then_some(named)
}

fn layout_change(layout: Layout, old: &[String], new: &[String]) -> Option<LayoutChange> {
    if old == new {
        return None;
    }
    let places =
        |names: &[String]| -> BTreeMap<String, usize> { names.iter().cloned().zip(0..).collect() };
    let (old_places, new_places) = (places(old), places(new));
    let alone = |names: &[String], others: &BTreeMap<String, usize>| -> Vec<(String, usize)> {
        let names = names.iter().cloned().zip(0..);
        names
            .filter(|(name, _)| !others.contains_key(name))
            .collect()
    };
    let moved = new.iter().filter_map(|name| {
        let places = [*old_places.get(name)?, new_places[name]];
        (places[0] != places[1]).then(|| (name.clone(), places))
    });
    Some(LayoutChange {
        layout,
        added: alone(new, &old_places),
        removed: alone(old, &new_places),
        moved: moved.collect(),
        renamed: Vec::new(),
    })
}

/// With what came where something went as one thing that was renamed.
fn renamed(change: LayoutChange) -> LayoutChange {
    let LayoutChange {
        added,
        mut removed,
        mut renamed,
        ..
    } = change;
    let mut left = Vec::new();
    for (name, place) in added {
        match removed.iter().position(|(_, own)| *own == place) {
            Some(old) => renamed.push(([removed.remove(old).0, name], place)),
            None => left.push((name, place)),
        }
    }
    LayoutChange {
        added: left,
        removed,
        renamed,
        ..change
    }
}

fn value_changes(body: Option<&str>, old: &Values, new: &Values) -> Vec<ValueChange> {
    let mut keys: Vec<&String> = old.keys().chain(new.keys()).collect();
    keys.sort();
    keys.dedup();
    let change = |key: &String| {
        let (old, new) = (old.get(key), new.get(key));
        let is_same = old == new || key == AXIS && have_one_direction(old, new);
        (!is_same).then(|| ValueChange {
            body: body.map(str::to_owned),
            key: key.clone(),
            old: old.cloned(),
            new: new.cloned(),
        })
    };
    keys.into_iter().filter_map(change).collect()
}

/// True for axes that differ in length alone.
fn have_one_direction(old: Option<&String>, new: Option<&String>) -> bool {
    let direction = |text: Option<&String>| -> Option<Vector> {
        let text = text?.strip_prefix('[')?.strip_suffix(']')?;
        let entries = text.split(',').map(|entry| entry.trim().parse().ok());
        let axis: Vec<f64> = entries.collect::<Option<_>>()?;
        let axis: Vector = axis.try_into().ok()?;
        Some(geometry::scaled(axis, 1.0 / geometry::length(axis)))
    };
    let (Some(old), Some(new)) = (direction(old), direction(new)) else {
        return false;
    };
    geometry::length(geometry::difference(old, new)) < SAME_DIRECTION
}
