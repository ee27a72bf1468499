//! `attach`: a body or a frame of another model, or all that stands in its world, with a prefix to the names.

use std::rc::Rc;

use crate::description::mjcf::around::{self, Around};
use crate::description::mjcf::attributes::Attributes;
use crate::description::mjcf::defaults::Class;
use crate::description::mjcf::known;
use crate::description::mjcf::models::Models;
use crate::description::mjcf::unknown::unknown;
use crate::description::xml::{Element, Reader};
use crate::diagnostic::{Diagnostic, Spanned, shown};

/// The elements that an `attach` stands for, and what is around them; `None` where it is faulty.
pub(super) fn elements<'d>(
    reader: &mut Reader,
    models: &Models<'d>,
    element: Element<'d>,
    around: &Around,
    owner: &str,
) -> Option<(Rc<[Element<'d>]>, Around)> {
    let owner = format!("an `attach` of {owner}");
    let given = Attributes::of(reader, element, &owner, &known::ATTACH);
    let prefix = required(reader, &given, "prefix");
    let name = required(reader, &given, "model");
    let (name, prefix) = (name?, prefix?);
    let whole = format!("{}{}", around.prefix, prefix.value);
    if !around::fits(reader, &whole, "prefixes", element.span()) {
        return None;
    }
    let assets = &models.list[around.model].assets;
    let Some(number) = assets.get(name.value) else {
        let message = format!("there is no model `{}` among the assets", shown(name.value));
        unknown(reader, message, name, assets.keys().copied());
        return None;
    };
    let model = &models.list[*number];
    let mut inner = Around {
        frame: around.frame,
        class: Class::MAIN,
        model: *number,
        prefix: Rc::from(whole),
        suffix: Rc::clone(&around.suffix),
    };
    let part = |kind| Some((kind, given.text(kind)?));
    let Some((kind, part)) = part("body").or_else(|| part("frame")) else {
        return Some((Rc::clone(&model.world), inner));
    };
    let parts = if kind == "body" {
        &model.bodies
    } else {
        &model.frames
    };
    let Some((element, class)) = parts.get(part.value) else {
        let (model_name, part_name) = (shown(name.value), shown(part.value));
        let message = format!("the model `{model_name}` has no {kind} `{part_name}`");
        unknown(reader, message, part, parts.keys().copied());
        return None;
    };
    // As in MuJoCo it brings its class, but not the frame in which it stands there.
    inner.class = *class;
    Some((Rc::from([*element]), inner))
}

fn required<'d>(
    reader: &mut Reader,
    given: &Attributes<'d>,
    name: &str,
) -> Option<Spanned<&'d str>> {
    let text = given.text(name);
    if text.is_none() {
        let message = format!("{} has no attribute `{name}`", given.owner);
        let mut fault = Diagnostic::error(message).at(given.span, format!("`{name}` is missing"));
        if name == "model" {
            fault = fault.help("`kane` does not attach parts of the same model");
        }
        reader.faults.push(fault);
    }
    text
}
