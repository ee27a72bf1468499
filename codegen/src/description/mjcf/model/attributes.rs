//! Attributes of an element, with those that it inherits from a default class.

use std::collections::{BTreeMap, btree_map};
use std::rc::Rc;

use crate::description::xml::{Element, Known, Reader, words};
use crate::diagnostic::{Span, Spanned};

/// The ways to write an orientation, of which an element has one.
pub(in crate::description::mjcf) const ORIENTATION: [&str; 5] =
    ["quat", "axisangle", "xyaxes", "zaxis", "euler"];

/// Lists of which an element may give the first entries alone: the others are those of its default.
const LISTS: [&str; 4] = ["damping", "polycoef", "size", "stiffness"];
/// The most entries that one of these has.
const LONGEST: usize = 5;

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
    /// Of a list, what the default has behind the entries that are written here.
    rest: Vec<Entry<'d>>,
}

/// An entry of a list, with the words for the element at which it is written.
#[derive(Clone, Debug)]
struct Entry<'d> {
    word: Spanned<&'d str>,
    owner: Rc<str>,
}

impl<'d> Written<'d> {
    fn new(value: Spanned<&'d str>, owner: Rc<str>) -> Self {
        Self {
            value,
            owner,
            rest: Vec::new(),
        }
    }

    /// How many entries stand where it is written.
    fn n_own(&self) -> usize {
        words(self.value).count()
    }

    /// Takes from what a default has the entries behind those that are there.
    fn complete(&mut self, default: &Self) {
        let n_there = self.n_own() + self.rest.len();
        let words = words(default.value).map(|word| Entry {
            word,
            owner: Rc::clone(&default.owner),
        });
        let entries = words.chain(default.rest.iter().cloned());
        self.rest.extend(entries.take(LONGEST).skip(n_there));
    }
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
                values.insert(*name, Written::new(value, owner));
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
                btree_map::Entry::Vacant(place) => {
                    place.insert(written.clone());
                }
                btree_map::Entry::Occupied(mut own) => {
                    if LISTS.contains(name) {
                        own.get_mut().complete(written);
                    }
                }
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

    /// The words for an entry of a list: an entry may be that of a default.
    pub(in crate::description::mjcf) fn what_of_entry(&self, name: &str, place: usize) -> String {
        let written = self.values.get(name);
        let entry =
            written.and_then(|written| written.rest.get(place.checked_sub(written.n_own())?));
        match entry {
            Some(entry) => format!("`{name}` of {}", entry.owner),
            None => self.what(name),
        }
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
        let written = self.values.get(name)?;
        let mut numbers = reader.some_numbers(written.value, &self.what(name), 1, most)?;
        for entry in &written.rest {
            if numbers.len() < most {
                let what = self.what_of_entry(name, numbers.len());
                numbers.push(reader.number(entry.word, &what)?);
            }
        }
        Some(numbers)
    }
}
