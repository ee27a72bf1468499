//! What stands in a body, be it inside frames, or in files that are included.

pub(in crate::description::mjcf) mod around;
pub(in crate::description::mjcf) mod attach;
pub(in crate::description::mjcf) mod replicate;

use std::rc::Rc;

use crate::description::mjcf::contents::around::Around;
use crate::description::mjcf::known;
use crate::description::mjcf::model::attributes::Attributes;
use crate::description::mjcf::model::models::Models;
use crate::description::mjcf::orientation::placement;
use crate::description::xml::{Element, Reader};
use crate::diagnostic::{Diagnostic, Spanned, shown};

/// An element of a body, and what is around it.
#[derive(Clone, Debug)]
pub(in crate::description::mjcf) struct Inside<'d> {
    pub(in crate::description::mjcf) element: Element<'d>,
    pub(in crate::description::mjcf) around: Around,
}

impl Inside<'_> {
    /// The element's name, if it has one.
    pub(in crate::description::mjcf) fn name(&self) -> Option<Spanned<String>> {
        let name = self.element.attribute("name");
        let name = name.filter(|name| !name.value.is_empty())?;
        Some(Spanned::new(self.around.name(name.value), name.span))
    }

    /// The words for an element of a body.
    pub(in crate::description::mjcf) fn owner(&self, what: &str, body: &str) -> String {
        match self.name() {
            Some(name) => format!("{what} `{}`", shown(&name.value)),
            None => format!("a {what} of {body}"),
        }
    }
}

/// The elements of a body, in the order of the file.
#[derive(Debug, Default)]
pub(in crate::description::mjcf) struct Contents<'d> {
    pub(in crate::description::mjcf) inertials: Vec<Inside<'d>>,
    pub(in crate::description::mjcf) joints: Vec<Inside<'d>>,
    pub(in crate::description::mjcf) geoms: Vec<Inside<'d>>,
    pub(in crate::description::mjcf) sites: Vec<Inside<'d>>,
    pub(in crate::description::mjcf) bodies: Vec<Inside<'d>>,
    /// What is around each copy of elements, and each model that is attached here.
    pub(in crate::description::mjcf) copies: Vec<Around>,
}

/// Gathers what stands in a body; `around` is what is around the body's elements.
pub(in crate::description::mjcf) fn gather<'d>(
    reader: &mut Reader,
    models: &Models<'d>,
    body: Element<'d>,
    owner: &str,
    around: Around,
) -> Contents<'d> {
    let mut contents = Contents::default();
    let own = around.clone();
    // Copies share their elements.
    let files = models.main().files;
    let children = |element: Element<'d>| Rc::<[Element<'d>]>::from(files.children(element));
    let mut open = vec![(children(body), 0, around)];
    while let Some((elements, next, around)) = open.last_mut() {
        let Some(element) = elements.get(*next).copied() else {
            open.pop();
            continue;
        };
        *next += 1;
        let around = around.clone();
        let model = &models.list[around.model];
        if around.is_copy() && !models.copies.count(reader, element.span()) {
            break;
        }
        let inside = Inside { element, around };
        match element.name() {
            "inertial" if !inside.around.is_same_copy(&own) => {
                reader.faults.push(copied_inertial(element, owner));
            }
            "inertial" => contents.inertials.push(inside),
            "joint" | "freejoint" => contents.joints.push(inside),
            "geom" => contents.geoms.push(inside),
            "site" => contents.sites.push(inside),
            "body" => contents.bodies.push(inside),
            "frame" => {
                let owner = format!("a frame of {owner}");
                let given = Attributes::of(reader, element, &owner, &known::FRAME);
                let inner = placement(reader, &given, &model.settings);
                let around = inside.around;
                let around = Around {
                    frame: around.frame.then(&inner),
                    class: model.child_class(reader, &given, around.class),
                    ..around
                };
                open.push((children(element), 0, around));
            }
            "replicate" => {
                let copies = replicate::copies(reader, models, element, &inside.around, owner);
                let elements = children(element);
                contents.copies.extend(copies.iter().cloned());
                let copies = copies.into_iter().rev();
                open.extend(copies.map(|copy| (Rc::clone(&elements), 0, copy)));
            }
            "attach" => {
                // What it attaches may be nothing.
                if !models.copies.count(reader, element.span()) {
                    break;
                }
                let found = attach::elements(reader, models, element, &inside.around, owner);
                if let Some((elements, around)) = found {
                    contents.copies.push(around.clone());
                    open.push((elements, 0, around));
                }
            }
            name if known::IGNORED_IN_BODY.contains(&name) => {}
            name if known::UNSUPPORTED_IN_BODY.contains(&name) => {
                reader.faults.push(unsupported(element, owner));
            }
            _ => reader.unknown_child(element, owner, &known::IN_BODY),
        }
    }
    contents
}

fn copied_inertial(element: Element<'_>, owner: &str) -> Diagnostic {
    let message =
        format!("an `inertial` of {owner} stands in what is copied; MuJoCo does not copy it");
    Diagnostic::warning(message).at(element.span(), "left out")
}

fn unsupported(element: Element<'_>, owner: &str) -> Diagnostic {
    let name = element.name();
    let message = format!("`{name}` of {owner} is not supported");
    let fault = Diagnostic::error(message).at(element.span(), "not supported");
    if name == "plugin" {
        return fault;
    }
    fault.help("let MuJoCo save the model: it writes out what this stands for")
}
