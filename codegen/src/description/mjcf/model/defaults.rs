//! `default`: classes of attributes.
//!
//! A class begins with what its outer class has when the class is opened, as in MuJoCo: what a later `default` adds to
//! the outer class is not inherited.

use std::collections::BTreeMap;

use crate::description::mjcf::files::Files;
use crate::description::mjcf::known;
use crate::description::mjcf::model::attributes::Attributes;
use crate::description::mjcf::unknown::unknown;
use crate::description::too_many;
use crate::description::xml::{Element, Known, Reader};
use crate::diagnostic::{Diagnostic, Span, Spanned, shown};

/// Kinds of elements whose defaults matter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::description::mjcf) enum ElementKind {
    Joint,
    Geom,
    Site,
    Mesh,
    Tendon,
    Equality,
    /// All of them share one default, under whichever name it is written.
    Actuator,
}

/// A default class.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::description::mjcf) struct Class(usize);

/// All default classes.
#[derive(Debug)]
pub(in crate::description::mjcf) struct Defaults<'d> {
    names: BTreeMap<&'d str, (Class, Span)>,
    /// For each class and kind what is given, with what is inherited.
    classes: Vec<[Attributes<'d>; 7]>,
}

impl Class {
    /// The class of all that name no other.
    pub(in crate::description::mjcf) const MAIN: Self = Self(0);
}

impl ElementKind {
    /// The kind of the elements of this name in a `default`.
    fn named(name: &str) -> Option<Self> {
        match name {
            "joint" => Some(Self::Joint),
            "geom" => Some(Self::Geom),
            "site" => Some(Self::Site),
            "mesh" => Some(Self::Mesh),
            "tendon" => Some(Self::Tendon),
            "equality" => Some(Self::Equality),
            name if known::ACTUATORS.contains(&name) => Some(Self::Actuator),
            _ => None,
        }
    }

    fn known(self) -> &'static Known<'static> {
        match self {
            Self::Joint => &known::JOINT,
            Self::Geom => &known::GEOM,
            Self::Site => &known::SITE,
            Self::Mesh => &known::MESH,
            Self::Tendon => &known::TENDON,
            Self::Equality => &known::EQUALITY,
            Self::Actuator => &known::ACTUATOR,
        }
    }
}

/// Reads the `default` elements directly below the root.
pub(in crate::description::mjcf) fn read<'d>(
    reader: &mut Reader,
    files: &'d Files<'_>,
    sections: &[Element<'d>],
) -> Defaults<'d> {
    let nothing = [(); 7].map(|()| Attributes::none());
    let mut defaults = Defaults {
        names: BTreeMap::new(),
        classes: vec![nothing],
    };
    for section in sections {
        if let Some(name) = section.attribute("class")
            && name.value != "main"
        {
            let message = format!(
                "the outermost default class is called `{}`; expected `main`, or no name",
                shown(name.value)
            );
            let fault = Diagnostic::error(message).at(name.span, "expected `main`");
            reader.faults.push(fault);
        }
        let mut open = vec![(*section, Class::MAIN)];
        while let Some((element, class)) = open.pop() {
            let inside = defaults.fill(reader, files, element, class);
            let inside: Vec<_> = inside
                .into_iter()
                .filter_map(|inner| Some((inner, defaults.opened(reader, inner, class)?)))
                .collect();
            open.extend(inside.into_iter().rev());
        }
    }
    defaults
}

impl<'d> Defaults<'d> {
    /// Takes over what an element says of its class; gives the classes inside.
    fn fill(
        &mut self,
        reader: &mut Reader,
        files: &'d Files<'_>,
        element: Element<'d>,
        class: Class,
    ) -> Vec<Element<'d>> {
        let class_name = match element.attribute("class") {
            Some(name) if class != Class::MAIN => format!("default class `{}`", shown(name.value)),
            _ => "the main default class".to_owned(),
        };
        reader.unknown_attributes(element, &class_name, &known::DEFAULT);
        let mut inside = Vec::new();
        for child in files.children(element) {
            if child.name() == "default" {
                inside.push(child);
            } else if let Some(kind) = ElementKind::named(child.name()) {
                let owner = format!("`{}` of {class_name}", child.name());
                let mut given = Attributes::of(reader, child, &owner, kind.known());
                given.forget("name");
                given.forget("class");
                let place = &mut self.classes[class.0][kind as usize];
                given.inherit(place);
                *place = given;
            } else if !known::DEFAULT.ignored_children.contains(&child.name()) {
                reader.unknown_child(child, &class_name, known::DEFAULT.children);
            }
        }
        inside
    }

    /// Opens the class of an element inside another class.
    fn opened(&mut self, reader: &mut Reader, element: Element<'d>, outer: Class) -> Option<Class> {
        let name = reader.required(element, "an inner default class", "class")?;
        if let Some((_, first)) = self.names.get(name.value) {
            let message = format!("default class `{}` is given twice", shown(name.value));
            let fault = Diagnostic::error(message)
                .at(name.span, "the second one")
                .at(*first, "the first one");
            reader.faults.push(fault);
            return None;
        }
        let class = Class(self.classes.len());
        if let Some(fault) = too_many("the number of default classes is", class.0 + 1) {
            reader.faults.push(fault.at(name.span, "one too many"));
            return None;
        }
        self.classes.push(self.classes[outer.0].clone());
        self.names.insert(name.value, (class, name.span));
        Some(class)
    }

    /// The class of this name, if there is one.
    pub(in crate::description::mjcf) fn known(&self, name: &str) -> Option<Class> {
        if name == "main" {
            return Some(Class::MAIN);
        }
        self.names.get(name).map(|(class, _)| *class)
    }

    /// The class of this name, which is a fault where there is none.
    pub(in crate::description::mjcf) fn class(
        &self,
        reader: &mut Reader,
        name: Spanned<&str>,
    ) -> Option<Class> {
        let class = self.known(name.value);
        if class.is_none() {
            let message = format!("there is no default class `{}`", shown(name.value));
            unknown(reader, message, name, self.names.keys().copied());
        }
        class
    }

    /// An element's attributes, with those of its own class, or else of the class around it.
    pub(in crate::description::mjcf) fn attributes(
        &self,
        reader: &mut Reader,
        element: Element<'d>,
        owner: &str,
        kind: ElementKind,
        around: Class,
    ) -> Attributes<'d> {
        let mut attributes = Attributes::of(reader, element, owner, kind.known());
        let class = attributes.text("class");
        let class = class.and_then(|name| self.class(reader, name));
        let class = class.unwrap_or(around);
        attributes.inherit(&self.classes[class.0][kind as usize]);
        attributes
    }
}
