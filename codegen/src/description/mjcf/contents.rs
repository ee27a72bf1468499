//! What stands in a body, be it inside frames, or in files that are included.

use crate::description::mjcf::attributes::Attributes;
use crate::description::mjcf::defaults::Class;
use crate::description::mjcf::known;
use crate::description::mjcf::model::Model;
use crate::description::mjcf::orientation::placement;
use crate::description::mjcf::placement::Placement;
use crate::description::xml::{Element, Reader};
use crate::diagnostic::Diagnostic;

/// An element of a body, and the frame and class around it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Inside<'d> {
    pub(super) element: Element<'d>,
    pub(super) frame: Placement,
    pub(super) class: Class,
}

/// The elements of a body, in the order of the file.
#[derive(Debug, Default)]
pub(super) struct Contents<'d> {
    pub(super) inertials: Vec<Inside<'d>>,
    pub(super) joints: Vec<Inside<'d>>,
    pub(super) geoms: Vec<Inside<'d>>,
    pub(super) sites: Vec<Inside<'d>>,
    pub(super) bodies: Vec<Inside<'d>>,
}

/// Gathers what stands in a body; `class` is that around the body's elements.
pub(super) fn gather<'d>(
    reader: &mut Reader,
    model: &Model<'d>,
    body: Element<'d>,
    owner: &str,
    class: Class,
) -> Contents<'d> {
    let mut contents = Contents::default();
    let mut open = vec![(
        model.files.children(body).into_iter(),
        Placement::SAME,
        class,
    )];
    while let Some((children, frame, class)) = open.last_mut() {
        let (frame, class) = (*frame, *class);
        let Some(element) = children.next() else {
            open.pop();
            continue;
        };
        let inside = Inside {
            element,
            frame,
            class,
        };
        match element.name() {
            "inertial" => contents.inertials.push(inside),
            "joint" | "freejoint" => contents.joints.push(inside),
            "geom" => contents.geoms.push(inside),
            "site" => contents.sites.push(inside),
            "body" => contents.bodies.push(inside),
            "frame" => {
                let given = Attributes::of(
                    reader,
                    element,
                    &format!("a frame of {owner}"),
                    &known::FRAME,
                );
                let inner = placement(reader, &given, &model.settings);
                let class = child_class(reader, model, &given, class);
                let children = model.files.children(element).into_iter();
                open.push((children, frame.then(&inner), class));
            }
            name if known::IGNORED_IN_BODY.contains(&name) => {}
            name if known::UNSUPPORTED_IN_BODY.contains(&name) => {
                let message = format!("`{name}` of {owner} is not supported");
                let fault = Diagnostic::error(message).at(element.span(), "not supported");
                reader.faults.push(if name == "plugin" {
                    fault
                } else {
                    fault.help("let MuJoCo save the model: it writes out what this stands for")
                });
            }
            _ => reader.unknown_child(element, owner, &known::IN_BODY),
        }
    }
    contents
}

/// The class around the elements inside: the one that is named, or else that from outside.
pub(super) fn child_class(
    reader: &mut Reader,
    model: &Model<'_>,
    given: &Attributes<'_>,
    around: Class,
) -> Class {
    let name = given.text("childclass");
    let class = name.and_then(|name| model.defaults.class(reader, name));
    class.unwrap_or(around)
}
