//! `attach`: a body or a frame of a model, or all that stands in the world of another one, with a prefix to the names.

use std::rc::Rc;

use crate::description::mjcf::contents::around::{self, Around};
use crate::description::mjcf::known;
use crate::description::mjcf::model::Model;
use crate::description::mjcf::model::attributes::Attributes;
use crate::description::mjcf::model::defaults::Class;
use crate::description::mjcf::model::models::Models;
use crate::description::mjcf::model::parts::{self, Named};
use crate::description::mjcf::unknown::unknown;
use crate::description::xml::{Element, Reader};
use crate::diagnostic::{Diagnostic, Spanned, shown};

/// The elements that an `attach` stands for, and what is around them; `None` where it is faulty.
pub(in crate::description::mjcf) fn elements<'d>(
    reader: &mut Reader,
    models: &Models<'d>,
    element: Element<'d>,
    around: &Around,
    owner: &str,
) -> Option<(Rc<[Element<'d>]>, Around)> {
    let owner = format!("an `attach` of {owner}");
    let given = Attributes::of(reader, element, &owner, &known::ATTACH);
    let whole = prefix(reader, &given, around)?;
    let other = given.text("model");
    let number = match other {
        Some(name) => asset(reader, &models.list[around.model], name)?,
        None => around.model,
    };
    let model = &models.list[number];
    let mut inner = Around {
        frame: around.frame,
        class: Class::MAIN,
        model: number,
        prefix: Rc::from(whole),
        suffix: Rc::clone(&around.suffix),
    };
    let part = |kind| Some((kind, given.text(kind)?));
    let Some((kind, name)) = part("body").or_else(|| part("frame")) else {
        if other.is_none() {
            let message = format!("{owner} has none of `model`, `body` and `frame`");
            let fault = Diagnostic::error(message).at(given.span, "does not say what to attach");
            reader.faults.push(fault);
            return None;
        }
        return Some((Rc::clone(&model.parts.world), inner));
    };
    let parts = match kind {
        "body" => &model.parts.bodies,
        _ => &model.parts.frames,
    };
    let named = parts.get(name.value).map_or(&[][..], Vec::as_slice);
    let found = match other {
        Some(_) => parts::outermost(named),
        None => model.parts.before(named, element),
    };
    let Some(part) = found else {
        absent(reader, other, (&owner, kind, name), parts);
        return None;
    };
    // As in MuJoCo it brings its class, but not the frame in which it stands there.
    inner.class = part.class;
    Some((Rc::from([part.element]), inner))
}

/// Tells that there is no such part, or none yet.
fn absent(
    reader: &mut Reader,
    other: Option<Spanned<&str>>,
    (owner, kind, name): (&str, &str, Spanned<&str>),
    parts: &Named<'_>,
) {
    let part = shown(name.value);
    let own = parts
        .iter()
        .filter(|(_, named)| parts::outermost(named).is_some());
    let own: Vec<&str> = own.map(|(name, _)| *name).collect();
    let whose = match other {
        Some(model) => format!("the model `{}`", shown(model.value)),
        None if own.contains(&name.value) => {
            let message = format!("{owner} asks for {kind} `{part}`, which does not end before it");
            let fault = Diagnostic::error(message);
            let fault = fault.at(name.span, "expected one that ends before the `attach`");
            reader.faults.push(fault);
            return;
        }
        None => "this model".to_owned(),
    };
    let message = format!("{whose} has no {kind} `{part}` (those in copies cannot be named)");
    unknown(reader, message, name, own.into_iter());
}

/// What stands before the names of what is attached.
fn prefix(reader: &mut Reader, given: &Attributes<'_>, around: &Around) -> Option<String> {
    let Some(prefix) = given.text("prefix") else {
        let message = format!("{} has no attribute `prefix`", given.owner);
        let fault = Diagnostic::error(message).at(given.span, "`prefix` is missing");
        reader.faults.push(fault);
        return None;
    };
    let whole = format!("{}{}", around.prefix, prefix.value);
    around::fits(reader, &whole, "prefixes", given.span).then_some(whole)
}

/// The number of a model among the assets.
fn asset(reader: &mut Reader, model: &Model<'_>, name: Spanned<&str>) -> Option<usize> {
    let asset = model.assets.get(name.value);
    if asset.is_none() {
        let message = format!("there is no model `{}` among the assets", shown(name.value));
        unknown(reader, message, name, model.assets.keys().copied());
    }
    asset.map(|asset| asset.number)
}
