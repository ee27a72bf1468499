//! Coordinates that move bodies another way: code that uses them goes on and is wrong.
//!
//! In: two outlines. Out: for each joint its coordinates of which that holds, with their axes before and after. Bodies are the same as in
//! their `Differences`.

use super::{
    differences::Differences,
    meaning::Meaning,
    outline::{Motion, Motions, Outline},
};
use crate::geometry;

/// The cosine of half a right angle: an axis that turned by more is nearer to another one of its joint.
const HALF: f64 = std::f64::consts::FRAC_1_SQRT_2;

/// What rounding may change of a cosine: an axis that turned by just the angle has not turned by more.
const ROUNDING: f64 = 1e-9;

/// Coordinates whose axes turned by more than a right angle over the body below, or by more than half of one if their joint has others
/// of their kind. They did so in the axes of that body and in those of its joint: where one of these alone was given otherwise, no
/// motion is another.
pub fn turned(old: &Outline, new: &Outline, differences: &Differences) -> Vec<Meaning> {
    let changed = new.bodies.iter().filter_map(|body| {
        let old_name = differences.old_name(&body.name).unwrap_or(&body.name);
        let old = old.bodies.iter().find(|own| own.name == old_name)?;
        let (old, new) = (old.motions.as_ref()?, body.motions.as_ref()?);
        // Axes over another body are no others: that body is told.
        let old_base = differences.old_name(&new.base).unwrap_or(&new.base);
        (old.base == old_base).then(|| of_joint(old, new)).flatten()
    });
    changed.collect()
}

fn of_joint(old: &Motions, new: &Motions) -> Option<Meaning> {
    let mut pairs = of_kind(&old.turns, &new.turns);
    pairs.extend(of_kind(&old.slides, &new.slides));
    let names: Vec<&str> = pairs.iter().map(|[_, new]| new.name.as_str()).collect();
    let axes = |side: usize| {
        let axes = pairs.iter().map(|pair| shown(pair[side]));
        let word = if pairs.len() == 1 { "axis" } else { "axes" };
        format!("{word} {}", axes.collect::<Vec<String>>().join(", "))
    };
    (!pairs.is_empty()).then(|| Meaning {
        name: format!("direction of q, u and tau of {}", names.join(", ")),
        old: axes(0),
        new: format!("{} in the axes of {}", axes(1), new.base),
    })
}

/// Motions of one kind that go another way; none where the joint has others than it had, which their names tell.
fn of_kind<'a>(old: &'a [Motion], new: &'a [Motion]) -> Vec<[&'a Motion; 2]> {
    let is_single = old.len() == 1;
    let mut places = old.iter().zip(new);
    let are_same =
        old.len() == new.len() && places.all(|(old, new)| is_single || old.place == new.place);
    let least = if is_single { 0.0 } else { HALF } - ROUNDING;
    let pairs = old.iter().zip(new).filter(|(old, new)| {
        let mut axes = old.axis.into_iter().zip(new.axis);
        are_same && axes.all(|(old, new)| geometry::dot(old, new) < least)
    });
    pairs.map(|(old, new)| [old, new]).collect()
}

fn shown(motion: &Motion) -> String {
    let [axis, _] = motion.axis;
    let rounded = axis.map(|entry| (entry * 1000.0).round() / 1000.0 + 0.0);
    format!("{rounded:?}")
}
