//! What of a model can be attached: its bodies and frames by name. What a `replicate` copies has its own name inside that alone.

use std::collections::BTreeMap;
use std::rc::Rc;

use crate::description::mjcf::files::Files;
use crate::description::mjcf::model::defaults::{Class, Defaults};
use crate::description::xml::Element;

/// A body or a frame, with the class around it.
#[derive(Clone, Copy, Debug)]
pub(in crate::description::mjcf) struct Part<'d> {
    pub(in crate::description::mjcf) element: Element<'d>,
    pub(in crate::description::mjcf) class: Class,
    /// How many elements stand before its end, and before the end of the innermost `replicate` around it.
    ends: [usize; 2],
}

/// Parts by name.
pub(in crate::description::mjcf) type Named<'d> = BTreeMap<&'d str, Vec<Part<'d>>>;

/// What of a model can be attached.
#[derive(Debug)]
pub(in crate::description::mjcf) struct Parts<'d> {
    /// What stands in the world.
    pub(in crate::description::mjcf) world: Rc<[Element<'d>]>,
    pub(in crate::description::mjcf) bodies: Named<'d>,
    pub(in crate::description::mjcf) frames: Named<'d>,
    /// How many elements stand before each `attach`, by its place.
    attaches: BTreeMap<usize, usize>,
}

/// An element that was entered but not left.
struct Open<'d> {
    element: Element<'d>,
    /// The class around it, and that of what it holds.
    classes: [Class; 2],
    children: std::vec::IntoIter<Element<'d>>,
    /// What was left in it and stands in no `replicate` that was left.
    parts: Vec<(&'d str, Part<'d>)>,
}

impl<'d> Parts<'d> {
    /// Looks through the worlds of a model.
    pub(in crate::description::mjcf) fn of(
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
        let enter = |element: Element<'d>, around: Class| {
            let class = element.attribute("childclass");
            let class = class.and_then(|name| defaults.known(name.value));
            Open {
                element,
                classes: [around, class.unwrap_or(around)],
                children: files.children(element).into_iter(),
                parts: Vec::new(),
            }
        };
        let mut count = 0;
        for world in worlds {
            let mut open = vec![enter(*world, Class::MAIN)];
            while let Some(last) = open.last_mut() {
                if let Some(child) = last.children.next() {
                    count += 1;
                    if child.name() == "attach" {
                        parts.attaches.insert(child.span().start, count);
                    } else if ["body", "frame", "replicate"].contains(&child.name()) {
                        let inner = enter(child, last.classes[1]);
                        open.push(inner);
                    }
                    continue;
                }
                let found = open.pop().map(|left| parts.leave(left, count));
                let found = found.unwrap_or_default();
                match open.last_mut() {
                    Some(around) if around.parts.is_empty() => around.parts = found,
                    Some(around) => around.parts.extend(found),
                    None => parts.extend(found),
                }
            }
        }
        parts
    }

    /// What was found in an element and the element itself, as long as they have the names that are written.
    fn leave(&mut self, left: Open<'d>, end: usize) -> Vec<(&'d str, Part<'d>)> {
        let mut found = left.parts;
        if left.element.name() == "replicate" {
            for (_, part) in &mut found {
                part.ends[1] = end;
            }
            self.extend(found);
            return Vec::new();
        }
        if let Some(name) = left.element.attribute("name") {
            let part = Part {
                element: left.element,
                class: left.classes[0],
                ends: [end, usize::MAX],
            };
            found.push((name.value, part));
        }
        found
    }

    fn extend(&mut self, found: Vec<(&'d str, Part<'d>)>) {
        for (name, part) in found {
            let named = match part.element.name() {
                "body" => &mut self.bodies,
                "frame" => &mut self.frames,
                _ => continue,
            };
            named.entry(name).or_default().push(part);
        }
    }

    /// The first of these parts that an `attach` of the same model finds: it ends before that, and stands in no `replicate` that
    /// ended.
    pub(in crate::description::mjcf) fn before(
        &self,
        parts: &[Part<'d>],
        attach: Element<'d>,
    ) -> Option<Part<'d>> {
        let place = *self.attaches.get(&attach.span().start)?;
        let mut parts = parts.iter().copied();
        parts.find(|part| part.ends[0] < place && place <= part.ends[1])
    }
}

/// The first of these parts that another model finds.
pub(in crate::description::mjcf) fn outermost<'d>(parts: &[Part<'d>]) -> Option<Part<'d>> {
    let mut parts = parts.iter().copied();
    parts.find(|part| part.ends[1] == usize::MAX)
}
