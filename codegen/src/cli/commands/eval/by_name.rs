//! Arguments that are given by names: `{"q": {"elbow": 0.3}}`. What is not named is zero, and quaternions are no rotation.

use kane_codegen::{
    description::CoordinateName,
    diagnostic::Escaped,
    functions::{Argument, Dimension},
    tree::{Changes, Joint, Tree},
};

/// What the places of an argument's outer list are called.
pub(super) struct Places {
    /// For each its name, and perhaps others: that of its rate, that of its joint as the model has it.
    names: Vec<Vec<String>>,
    /// For each the number that it has where it is not named.
    pub(super) otherwise: Vec<f64>,
    /// What they are, in words.
    pub(super) kind: &'static str,
}

impl Places {
    /// Those of an argument over coordinates, speeds or bodies; `None` for another one.
    pub(super) fn of(tree: &Tree, argument: Argument) -> Option<Self> {
        let (names, kind) = match argument.shape().dimensions.first()? {
            Dimension::Coordinates => {
                let own = alone(tree.coordinate_names());
                (with_joints(tree, own, coordinates), "coordinates")
            }
            Dimension::Speeds => {
                let plain = tree.along_speeds("", "").into_iter();
                let both = plain.zip(tree.speed_names());
                let own = both.map(|(own, rate)| vec![own, rate]).collect();
                (with_joints(tree, own, speeds), "speeds")
            }
            Dimension::Bodies => {
                let bodies = tree.bodies.iter().map(|body| body.name.clone());
                (alone(bodies.collect()), "bodies")
            }
            Dimension::Values => {
                let parameters = tree.parameters.iter();
                let names = parameters.map(|parameter| parameter.name.clone());
                (alone(names.collect()), "values set at run time")
            }
            _ => return None,
        };
        let otherwise = if argument == Argument::Q {
            tree.neutral()
        } else {
            vec![0.0; names.len()]
        };
        Some(Self {
            names,
            otherwise,
            kind,
        })
    }

    /// The place with this name.
    pub(super) fn place(&self, name: &str) -> Option<usize> {
        let called = |nth: usize| {
            let mut names = self.names.iter();
            names.position(|own| own.get(nth).is_some_and(|own| own == name))
        };
        (0..3).find_map(called)
    }

    /// The first name of each.
    pub(super) fn names(&self) -> Vec<&str> {
        self.names.iter().map(|names| names[0].as_str()).collect()
    }
}

fn alone(names: Vec<String>) -> Vec<Vec<String>> {
    names.into_iter().map(|name| vec![name]).collect()
}

/// The names, and those of joints that have a single place: the joint's own, or its body's.
fn with_joints(
    tree: &Tree,
    mut names: Vec<Vec<String>>,
    places: fn(&Joint) -> Vec<usize>,
) -> Vec<Vec<String>> {
    for body in &tree.bodies {
        if let [place] = places(&body.joint)[..] {
            names[place].push(body.joint.name.clone());
        }
    }
    names
}

fn coordinates(joint: &Joint) -> Vec<usize> {
    let all = joint.coordinates().into_iter();
    all.map(|(_, own)| own.index()).collect()
}

fn speeds(joint: &Joint) -> Vec<usize> {
    let all = joint.speeds().into_iter();
    all.map(|(_, own)| own.index()).collect()
}

/// What holds a coordinate or a joint of this name, which has no place in the argument.
pub(super) fn held(changes: &Changes, argument: Argument, name: &str) -> Option<String> {
    let mut locked = changes.lock.iter();
    let value = locked.find(|(own, _)| is_one_joint(own, name));
    let is_removed = || {
        let mut removed = changes.remove.iter();
        removed.any(|own| is_one_joint(own, name))
    };
    let held = match value {
        Some((_, value)) => format!("`{}` holds it at {value:?}", Changes::LOCK),
        None if is_removed() => format!("`{}` fixes it at zero", Changes::REMOVE),
        None => return None,
    };
    Some(if argument == Argument::Q {
        held
    } else {
        format!("{held}, so that it has no speed")
    })
}

/// True of the name of a joint or coordinate twice, and of that of a joint with that of one of its coordinates.
fn is_one_joint(one: &str, other: &str) -> bool {
    let is_coordinate_of = |long: &str, short: &str| {
        let rest = long.strip_prefix(short);
        let coordinate = rest.and_then(|rest| rest.strip_prefix('_'));
        coordinate.and_then(CoordinateName::named).is_some()
    };
    one == other || is_coordinate_of(one, other) || is_coordinate_of(other, one)
}

/// Where something moves or is that has no place of its own: a joint that follows another, a link that is fixed to a body.
pub(super) fn elsewhere(tree: &Tree, argument: Argument, name: &str) -> Option<String> {
    if *argument.shape().dimensions.first()? == Dimension::Bodies {
        let mut fixed = tree.frames.iter().filter(|frame| frame.name == name);
        let body = tree.body(fixed.next()?.body?);
        return Some(format!(
            "it is fixed to `{}`; name that",
            body.name.escaped()
        ));
    }
    let mut bodies = tree.bodies.iter();
    let following = bodies.find(|body| body.joint.name == name)?;
    let motion = following.joint.motions().into_iter().flatten().next()?;
    let leader = tree.speed_bodies()[motion.speed.index()];
    let leader = &tree.body(leader).joint.name;
    (leader != name).then(|| format!("it follows `{}`", leader.escaped()))
}
