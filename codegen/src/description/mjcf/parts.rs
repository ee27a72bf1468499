//! What of a model can be attached: its bodies and frames by name, but for what stands in copies.

use std::collections::BTreeMap;
use std::rc::Rc;

use crate::description::mjcf::defaults::{Class, Defaults};
use crate::description::mjcf::files::Files;
use crate::description::xml::Element;

/// A body or a frame, with the class around it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Part<'d> {
    pub(super) element: Element<'d>,
    pub(super) class: Class,
    /// How many elements stand before its end.
    end: usize,
}

/// What of a model can be attached.
#[derive(Debug)]
pub(super) struct Parts<'d> {
    /// What stands in the world.
    pub(super) world: Rc<[Element<'d>]>,
    pub(super) bodies: BTreeMap<&'d str, Part<'d>>,
    pub(super) frames: BTreeMap<&'d str, Part<'d>>,
    /// How many elements stand before each `attach`, by its place.
    attaches: BTreeMap<usize, usize>,
}

/// An element that was entered but not left.
struct Open<'d> {
    element: Element<'d>,
    /// The class around it, and that of what it holds.
    classes: [Class; 2],
    /// What it holds stands in copies.
    is_copied: bool,
    children: std::vec::IntoIter<Element<'d>>,
}

impl<'d> Parts<'d> {
    /// Looks through the worlds of a model.
    pub(super) fn of(
        files: &'d Files<'d>,
        defaults: &Defaults<'d>,
        worlds: &[Element<'d>],
    ) -> Self {
        let inside = worlds.iter().flat_map(|world| files.children(*world));
        let mut parts = Self {
            world: inside.collect(),
            bodies: BTreeMap::new(),
            frames: BTreeMap::new(),
            attaches: BTreeMap::new(),
        };
        let enter = |element: Element<'d>, around: Class, is_copied: bool| {
            let class = element.attribute("childclass");
            let class = class.and_then(|name| defaults.known(name.value));
            Open {
                element,
                classes: [around, class.unwrap_or(around)],
                is_copied: is_copied || element.name() == "replicate",
                children: files.children(element).into_iter(),
            }
        };
        let mut count = 0;
        for world in worlds {
            let mut open = vec![enter(*world, Class::MAIN, false)];
            while let Some(last) = open.last_mut() {
                match last.children.next() {
                    Some(child) => {
                        count += 1;
                        if child.name() == "attach" {
                            parts.attaches.insert(child.span().start, count);
                        } else if ["body", "frame", "replicate"].contains(&child.name()) {
                            let inner = enter(child, last.classes[1], last.is_copied);
                            open.push(inner);
                        }
                    }
                    None => {
                        let left = open.pop();
                        parts.extend(left, count);
                    }
                }
            }
        }
        parts
    }

    /// Adds what was left, if it has a name of its own.
    fn extend(&mut self, left: Option<Open<'d>>, end: usize) {
        let Some(left) = left.filter(|left| !left.is_copied) else {
            return;
        };
        let named = match left.element.name() {
            "body" => &mut self.bodies,
            "frame" => &mut self.frames,
            _ => return,
        };
        if let Some(name) = left.element.attribute("name") {
            named.entry(name.value).or_insert(Part {
                element: left.element,
                class: left.classes[0],
                end,
            });
        }
    }

    /// True for a part that ends before this `attach` of the same model.
    pub(super) fn is_before(&self, part: Part<'d>, attach: Element<'d>) -> bool {
        let place = self.attaches.get(&attach.span().start);
        place.is_some_and(|place| part.end < *place)
    }
}
