//! Attributes of an element, with those that it inherits from a default class.

use std::collections::{BTreeMap, btree_map::Entry};
use std::rc::Rc;

use crate::description::xml::{Element, Known, Reader};
use crate::diagnostic::{Span, Spanned};

/// The ways to write an orientation, of which an element has one.
pub(in crate::description::mjcf) const ORIENTATION: [&str; 5] =
    ["quat", "axisangle", "xyaxes", "zaxis", "euler"];

/// Lists of which an element may give the first entries alone: the others are those of its default.
const LISTS: [&str; 4] = ["damping", "polycoef", "size", "stiffness"];

/// The attributes of an element that are read.
#[derive(Clone, Debug)]
pub(in crate::description::mjcf) struct Attributes<'d> {
    /// The words for the element, such as "joint `hip`".
    pub(in crate::description::mjcf) owner: Rc<str>,
    /// The element's place.
    pub(in crate::description::mjcf) span: Span,
    values: BTreeMap<&'static str, Written<'d>>,
}

/// A value, with the words for the element at which it is written: a default's may be another one's.
#[derive(Clone, Debug)]
struct Written<'d> {
    value: Spanned<&'d str>,
    owner: Rc<str>,
    /// What the default has, of a list.
    below: Option<Rc<Written<'d>>>,
}

impl<'d> Attributes<'d> {
    /// No attribute, for an element that is not there.
    pub(in crate::description::mjcf) fn none() -> Self {
        Self {
            owner: Rc::from(""),
            span: Span { start: 0, end: 0 },
            values: BTreeMap::new(),
        }
    }

    /// The attributes of the element itself, with a warning of those that are not known.
    pub(in crate::description::mjcf) fn of(
        reader: &mut Reader,
        element: Element<'d>,
        owner: &str,
        known: &Known<'static>,
    ) -> Self {
        reader.unknown_attributes(element, owner, known);
        let owner: Rc<str> = Rc::from(owner);
        let mut values = BTreeMap::new();
        for (found, value) in element.attributes() {
            if let Some(name) = known.attributes.iter().find(|name| **name == found.value) {
                let owner = Rc::clone(&owner);
                let below = None;
                values.insert(
                    *name,
                    Written {
                        value,
                        owner,
                        below,
                    },
                );
            }
        }
        Self {
            owner,
            span: element.span(),
            values,
        }
    }

    /// Takes from a default what the element does not say itself.
    pub(in crate::description::mjcf) fn inherit(&mut self, default: &Self) {
        let oriented = ORIENTATION.iter().any(|name| self.has(name));
        for (name, written) in &default.values {
            if oriented && ORIENTATION.contains(name) {
                continue;
            }
            match self.values.entry(name) {
                Entry::Vacant(place) => {
                    place.insert(written.clone());
                }
                Entry::Occupied(mut own) if LISTS.contains(name) => {
                    own.get_mut().below = Some(Rc::new(written.clone()));
                }
                Entry::Occupied(_) => {}
            }
        }
    }

    /// Drops an attribute that is not for heirs.
    pub(in crate::description::mjcf) fn forget(&mut self, name: &str) {
        self.values.remove(name);
    }

    /// True where the attribute is given, be it well or not.
    pub(in crate::description::mjcf) fn has(&self, name: &str) -> bool {
        self.values.contains_key(name)
    }

    /// The words for an attribute: "`range` of joint `hip`".
    pub(in crate::description::mjcf) fn what(&self, name: &str) -> String {
        let owner = self.values.get(name).map_or(&self.owner, |w| &w.owner);
        format!("`{name}` of {owner}")
    }

    /// The place of an attribute's value, or of the element that has it not.
    pub(in crate::description::mjcf) fn place(&self, name: &str) -> Span {
        self.values.get(name).map_or(self.span, |w| w.value.span)
    }

    /// The value as it is written.
    pub(in crate::description::mjcf) fn text(&self, name: &str) -> Option<Spanned<&'d str>> {
        self.values.get(name).map(|written| written.value)
    }

    /// One of several words.
    pub(in crate::description::mjcf) fn keyword<T: Clone>(
        &self,
        reader: &mut Reader,
        name: &str,
        words: &[(&str, T)],
    ) -> Option<Spanned<T>> {
        let value = self.text(name)?;
        reader.keyword(value, &self.what(name), words)
    }

    /// A finite number.
    pub(in crate::description::mjcf) fn number(
        &self,
        reader: &mut Reader,
        name: &str,
    ) -> Option<Spanned<f64>> {
        let value = self.text(name)?;
        reader.number(value, &self.what(name))
    }

    /// So many finite numbers.
    pub(in crate::description::mjcf) fn numbers<const N: usize>(
        &self,
        reader: &mut Reader,
        name: &str,
    ) -> Option<[Spanned<f64>; N]> {
        let value = self.text(name)?;
        reader.numbers(value, &self.what(name))
    }

    /// So many finite numbers, without their places.
    pub(in crate::description::mjcf) fn vector<const N: usize>(
        &self,
        reader: &mut Reader,
        name: &str,
    ) -> Option<[f64; N]> {
        let numbers = self.numbers(reader, name)?;
        Some(numbers.map(|number| number.value))
    }

    /// From one to `most` finite numbers; of a list with those of its default behind.
    pub(in crate::description::mjcf) fn up_to(
        &self,
        reader: &mut Reader,
        name: &str,
        most: usize,
    ) -> Option<Vec<Spanned<f64>>> {
        let mut written = self.values.get(name)?;
        let what = self.what(name);
        let mut numbers = reader.some_numbers(written.value, &what, 1, most)?;
        while let Some(below) = &written.below {
            written = below;
            let others = reader.some_numbers(written.value, &what, 1, most)?;
            numbers.extend(others.into_iter().skip(numbers.len()));
        }
        Some(numbers)
    }
}
