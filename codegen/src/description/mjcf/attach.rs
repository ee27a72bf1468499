//! `attach`: a body of another model, or all that stands in its world, with a prefix to the names.

use std::rc::Rc;

use crate::description::mjcf::around::Around;
use crate::description::mjcf::attributes::Attributes;
use crate::description::mjcf::defaults::Class;
use crate::description::mjcf::known;
use crate::description::mjcf::models::Models;
use crate::description::mjcf::unknown::unknown;
use crate::description::xml::{Element, Reader, shown};
use crate::diagnostic::{Diagnostic, Spanned};

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
    let name = required(reader, &given, "model");
    let prefix = required(reader, &given, "prefix");
    let (name, prefix) = (name?, prefix?);
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
        prefix: Rc::from(format!("{}{}", around.prefix, prefix.value)),
        suffix: Rc::clone(&around.suffix),
    };
    let body = given.text("body").filter(|body| !body.value.is_empty());
    let Some(body) = body else {
        return Some((Rc::clone(&model.world), inner));
    };
    let Some((element, class)) = model.bodies.get(body.value) else {
        let (model_name, body_name) = (shown(name.value), shown(body.value));
        let message = format!("the model `{model_name}` has no body `{body_name}`");
        unknown(reader, message, body, model.bodies.keys().copied());
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
        let fault = Diagnostic::error(message).at(given.span, format!("`{name}` is missing"));
        reader.faults.push(fault);
    }
    text
}
