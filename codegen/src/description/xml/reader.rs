//! The reading of elements and attributes, and of their names.

use crate::description::xml::document::Element;
use crate::diagnostic::{
    Diagnostic, Faults, NearNames, Severity, Spanned, backquoted, nearest, shown,
};

/// The names that an element's reader knows; it says something about all others.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Known<'k> {
    /// Attributes that are read.
    pub(crate) attributes: &'k [&'k str],
    /// Child elements that are read.
    pub(crate) children: &'k [&'k str],
    /// Attributes without influence on the dynamics.
    pub(crate) ignored_attributes: &'k [&'k str],
    /// Child elements without influence on the dynamics.
    pub(crate) ignored_children: &'k [&'k str],
}

impl<'k> Known<'k> {
    /// No name at all.
    pub(crate) const NONE: Self = Self {
        attributes: &[],
        children: &[],
        ignored_attributes: &[],
        ignored_children: &[],
    };

    /// These attributes, of which the second say nothing about the dynamics, and no child element.
    pub(crate) const fn attributes(read: &'k [&'k str], ignored: &'k [&'k str]) -> Self {
        Self {
            attributes: read,
            ignored_attributes: ignored,
            ..Self::NONE
        }
    }
}

/// Reads values and keeps what is wrong with them.
#[derive(Debug, Default)]
pub(crate) struct Reader {
    pub(crate) faults: Faults,
    /// Of names that nothing has, those that were meant.
    pub(crate) near: NearNames,
}

impl Reader {
    /// Warns of every attribute and child element that is not known; `owner` is the words for the element, such as
    /// "link `hub`".
    pub(crate) fn unknown(&mut self, element: Element<'_>, owner: &str, known: &Known<'_>) {
        self.unknown_attributes(element, owner, known);
        for child in element.children() {
            if !known.ignored_children.contains(&child.name()) {
                self.unknown_child(child, owner, known.children);
            }
        }
    }

    /// Warns of every attribute that is not known.
    pub(crate) fn unknown_attributes(
        &mut self,
        element: Element<'_>,
        owner: &str,
        known: &Known<'_>,
    ) {
        for (name, _) in element.attributes() {
            if !known.attributes.contains(&name.value)
                && !known.ignored_attributes.contains(&name.value)
            {
                self.unknown_name(name, owner, "attribute", known.attributes);
            }
        }
    }

    /// Warns of a child element if it is not known.
    pub(crate) fn unknown_child(&mut self, child: Element<'_>, owner: &str, known: &[&str]) {
        if !known.contains(&child.name()) {
            let name = Spanned::new(child.name(), child.span());
            self.unknown_name(name, owner, "element", known);
        }
    }

    fn unknown_name(&mut self, name: Spanned<&str>, owner: &str, what: &str, known: &[&str]) {
        if self.faults.is_full(Severity::Warning) {
            return;
        }
        let message = format!("unknown {what} `{}` of {owner}", shown(name.value));
        let mut warning = Diagnostic::warning(message)
            .at(name.span, "ignored")
            .one_of(
                format!("unknown {what}s are ignored"),
                format!("`{}` of {owner}", shown(name.value)),
            );
        if let Some(near) = nearest(name.value, known) {
            warning = warning.help(format!("did you mean `{near}`?"));
        } else if let [only] = known {
            warning = warning.help(format!("the only {what} that is read here is `{only}`"));
        } else if !known.is_empty() {
            warning = warning.help(format!(
                "the {what}s that are read here are {}",
                backquoted(known)
            ));
        }
        self.faults.push(warning);
    }

    /// The child element of this name; a warning where there are several, of which the first counts.
    pub(crate) fn child<'d>(
        &mut self,
        element: Element<'d>,
        owner: &str,
        name: &str,
    ) -> Option<Element<'d>> {
        let mut found = element.children_named(name);
        let first = found.next()?;
        for other in found {
            let message = format!("`{name}` of {owner} is given again; the first one counts");
            self.faults.push(
                Diagnostic::warning(message)
                    .at(other.span(), "ignored")
                    .at(first.span(), "the first one")
                    .one_of(
                        "elements are given again; the first one counts",
                        format!("`{name}` of {owner}"),
                    ),
            );
        }
        Some(first)
    }

    /// The child element of this name, which must be there.
    pub(crate) fn required_child<'d>(
        &mut self,
        element: Element<'d>,
        owner: &str,
        name: &str,
    ) -> Option<Element<'d>> {
        let child = self.child(element, owner, name);
        if child.is_none() {
            let fault = Diagnostic::error(format!("{owner} has no `{name}`"));
            self.faults
                .push(fault.at(element.span(), format!("`{name}` is missing")));
        }
        child
    }

    /// The value of an attribute that must be there.
    pub(crate) fn required<'d>(
        &mut self,
        element: Element<'d>,
        owner: &str,
        name: &str,
    ) -> Option<Spanned<&'d str>> {
        let value = element.attribute(name);
        if value.is_none() {
            let fault = Diagnostic::error(format!("{owner} has no attribute `{name}`"));
            self.faults
                .push(fault.at(element.span(), format!("`{name}` is missing")));
        }
        value
    }

    /// One of several words, and what it stands for.
    pub(crate) fn keyword<T: Clone>(
        &mut self,
        value: Spanned<&str>,
        what: &str,
        words: &[(&str, T)],
    ) -> Option<Spanned<T>> {
        let found = words.iter().find(|(word, _)| *word == value.value);
        if let Some((_, meaning)) = found {
            return Some(Spanned::new(meaning.clone(), value.span));
        }
        let names: Vec<&str> = words.iter().map(|(word, _)| *word).collect();
        let fault = format!(
            "{what} is `{}`; expected one of {}",
            shown(value.value),
            backquoted(&names)
        );
        let mut fault = Diagnostic::error(fault).at(value.span, "unknown");
        if let Some(near) = nearest(value.value, &names) {
            fault = fault.help(format!("did you mean `{near}`?"));
        }
        self.faults.push(fault);
        None
    }
}
