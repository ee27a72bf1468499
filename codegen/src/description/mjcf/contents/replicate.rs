//! `replicate`: copies of elements, each moved further, with numbers behind their names.

use std::rc::Rc;

use crate::description::mjcf::contents::around::{self, Around};
use crate::description::mjcf::known;
use crate::description::mjcf::model::angles::euler;
use crate::description::mjcf::model::attributes::Attributes;
use crate::description::mjcf::model::models::Models;
use crate::description::mjcf::placement::Placement;
use crate::description::too_many;
use crate::description::xml::{Element, Reader};
use crate::diagnostic::{Diagnostic, Spanned, shown};
use crate::geometry::Vector;
use crate::limits::BODIES;

/// What is around each copy of the elements in a `replicate`.
pub(in crate::description::mjcf) fn copies<'d>(
    reader: &mut Reader,
    models: &Models<'d>,
    element: Element<'d>,
    around: &Around,
    owner: &str,
) -> Vec<Around> {
    let owner = format!("a `replicate` of {owner}");
    let given = Attributes::of(reader, element, &owner, &known::REPLICATE);
    let model = &models.list[around.model];
    for child in model.files.children(element) {
        if ["joint", "freejoint", "inertial"].contains(&child.name()) {
            let message = format!("{owner} has a `{}`; expected it in a body", child.name());
            reader
                .faults
                .push(Diagnostic::error(message).at(child.span(), "in no body"));
        }
    }
    let Some(count) = count(reader, &given) else {
        return Vec::new();
    };
    let offset = given.vector(reader, "offset").unwrap_or_default();
    let angles: Vector = given.vector(reader, "euler").unwrap_or_default();
    let settings = &model.settings;
    let class = model.child_class(reader, &given, around.class);
    let separator = given.text("sep").map_or("", |separator| separator.value);
    // As in MuJoCo as many digits as their number needs, not the last one.
    let digits = count.to_string().len();
    let longest = format!("{separator}{count}{}", around.suffix);
    if !around::fits(reader, &longest, "`sep` and numbers", element.span()) {
        return Vec::new();
    }
    let mut copies = Vec::new();
    let mut moved = Placement::SAME;
    for number in 0..count {
        // Empty ones count too: there may be many in one another.
        if !models.copies.count(reader, element.span()) {
            break;
        }
        let suffix = format!("{separator}{number:0digits$}{}", around.suffix);
        copies.push(Around {
            frame: around.frame.then(&moved),
            class,
            suffix: Rc::from(suffix),
            ..around.clone()
        });
        // MuJoCo adds up the angles, not the rotations, and moves along the axes of the copy before.
        moved.position = moved.point(offset);
        let times = (number + 1) as f64;
        let turned = angles.map(|angle| settings.angle.sine_cosine(times * angle));
        moved.rotation = euler(&settings.euler, turned);
    }
    copies
}

/// How many copies there are; `None` where that is faulty.
fn count(reader: &mut Reader, given: &Attributes<'_>) -> Option<usize> {
    let Some(text) = given.text("count") else {
        let message = format!("{} has no attribute `count`", given.owner);
        let fault = Diagnostic::error(message).at(given.span, "`count` is missing");
        reader.faults.push(fault);
        return None;
    };
    let Spanned { value, span } = text;
    let fault = match value.trim().parse::<usize>() {
        Ok(count) if count <= BODIES => return Some(count),
        Ok(count) => {
            too_many(&format!("{} is", given.what("count")), count)?.at(span, "expected fewer")
        }
        _ => {
            let (what, found) = (given.what("count"), shown(value));
            let message = format!("{what} is `{found}`; expected a whole number from 0 on");
            Diagnostic::error(message).at(span, "expected zero or more")
        }
    };
    reader.faults.push(fault);
    None
}
