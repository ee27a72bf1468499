//! XML elements with their places, and the reading of their attributes.
//!
//! In: the text of a file. Out: a [`Document`] of [`Element`]s; checked values, `None` where there is none; the
//! faults gather in the [`Reader`]. Afterwards: numbers are finite, and every place is a span of the text, moved by
//! the document's base, so that several files can share one line of offsets. Does not: know what an element means.
//!
//! Document type declarations are refused, and with them every entity but those of XML itself.

use roxmltree::{Error, Node, ParsingOptions};

use crate::description::toml_reader::list;
use crate::description::xml::markup;
use crate::diagnostic::{Diagnostic, Faults, Severity, Span, Spanned, nearest};
use crate::limits::XML_NODES;

/// Characters of a value shown in a message.
const MOST_SHOWN: usize = 40;

/// A file as elements.
#[derive(Debug)]
pub(crate) struct Document<'t> {
    tree: roxmltree::Document<'t>,
    /// Added to every place.
    base: usize,
}

/// An element of a [`Document`].
#[derive(Clone, Copy, Debug)]
pub(crate) struct Element<'d> {
    node: Node<'d, 'd>,
    base: usize,
}

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

/// Reads values and keeps what is wrong with them.
#[derive(Debug, Default)]
pub(crate) struct Reader {
    pub(crate) faults: Faults,
}

/// The name of the root element, as far as it can be told without reading the file.
pub(crate) fn root_name(text: &str) -> Option<&str> {
    let rest = text.get(prolog_end(text)..)?.strip_prefix('<')?;
    let name = rest.split([' ', '\t', '\r', '\n', '/', '>']).next()?;
    (!name.is_empty()).then_some(name)
}

/// Where the declaration, comments and processing instructions before the root element end.
fn prolog_end(text: &str) -> usize {
    let mut rest = text;
    loop {
        rest = rest.trim_start();
        let close = if rest.starts_with("<!--") {
            "-->"
        } else if rest.starts_with("<?") {
            "?>"
        } else {
            return text.len() - rest.len();
        };
        rest = rest.split_once(close).map_or("", |(_, after)| after);
    }
}

impl<'t> Document<'t> {
    /// Reads a file whose first byte has the place `base`.
    pub(crate) fn parse(text: &'t str, base: usize) -> Result<Self, Diagnostic> {
        markup::check(text).map_err(|fault| fault.moved(base))?;
        let options = ParsingOptions {
            nodes_limit: XML_NODES,
            ..ParsingOptions::default()
        };
        match roxmltree::Document::parse_with_options(text, options) {
            Ok(tree) => Ok(Self { tree, base }),
            Err(error) => Err(malformed(text, base, &error)),
        }
    }

    /// The root element.
    pub(crate) fn root(&self) -> Element<'_> {
        Element {
            node: self.tree.root_element(),
            base: self.base,
        }
    }
}

fn malformed(text: &str, base: usize, error: &Error) -> Diagnostic {
    let position = error.pos();
    let at = match error {
        Error::NoRootNode | Error::UnclosedRootNode | Error::UnexpectedEndOfStream => {
            text.trim_end().len()
        }
        Error::DtdDetected => prolog_end(text),
        _ => offset(text, position.row as usize, position.col as usize),
    };
    let found = text.get(at..).and_then(|rest| rest.chars().next());
    let found_shown = found.map_or(String::from("the end of the file"), |found| {
        format!("`{}`", found.escape_debug())
    });
    let mut length = found.map_or(0, char::len_utf8);
    let mut help = None;
    let message = match error {
        Error::NoRootNode => "it has no element".to_owned(),
        Error::NodesLimitReached => {
            format!("it has more than {XML_NODES} elements, comments and texts")
        }
        Error::UnclosedRootNode => "the file ends before its root element is closed".to_owned(),
        Error::UnexpectedEndOfStream => "the file ends too early".to_owned(),
        Error::DtdDetected => {
            length = "<!DOCTYPE".len();
            "a document type declaration is not accepted".to_owned()
        }
        Error::UnexpectedCloseTag(expected, actual, _) => {
            length = actual.len() + "</>".len();
            format!("expected `</{expected}>`, found `</{actual}>`")
        }
        Error::DuplicatedAttribute(name, _) => {
            length = name.len();
            format!("the attribute `{name}` is given twice")
        }
        Error::UnknownNamespace(prefix, _) => {
            length = prefix.len();
            help = Some(format!(
                "declare the prefix at the root element: `xmlns:{prefix}=\"...\"`"
            ));
            format!("the prefix `{prefix}` is not declared")
        }
        Error::MalformedEntityReference(_) => {
            help = Some("write `&amp;` for `&`".to_owned());
            "`&` begins no entity reference".to_owned()
        }
        Error::InvalidChar(expected, _, _) => {
            format!("expected `{}`, found {found_shown}", char::from(*expected))
        }
        Error::InvalidChar2(expected, _, _) => format!("expected {expected}, found {found_shown}"),
        Error::InvalidString(expected, _) => format!("expected `{expected}`, found {found_shown}"),
        Error::InvalidName(_) => format!("expected a name, found {found_shown}"),
        Error::NonXmlChar(..) => format!("{found_shown} must not stand in XML"),
        // The place is shown already.
        other => other.to_string().replace(&format!(" at {position}"), ""),
    };
    let start = base + at;
    let fault = Diagnostic::error(format!("not valid XML: {message}"))
        .at(Span::from(start..start + length), "here");
    match help {
        Some(help) => fault.help(help),
        None => fault,
    }
}

/// The byte at a line and a column, both from 1, the column in characters.
fn offset(text: &str, row: usize, column: usize) -> usize {
    let mut start = 0;
    for line in text.split_inclusive('\n').take(row.saturating_sub(1)) {
        start += line.len();
    }
    let line = text.get(start..).unwrap_or_default();
    line.char_indices()
        .nth(column.saturating_sub(1))
        .map_or(text.len(), |(at, _)| start + at)
}

impl<'d> Element<'d> {
    fn text(self) -> &'d str {
        self.node.document().input_text()
    }

    fn place(self, start: usize, end: usize) -> Span {
        Span::from(self.base + start..self.base + end)
    }

    /// The name as it is written, with its prefix.
    pub(crate) fn name(self) -> &'d str {
        let rest = self.text().get(self.node.range().start + 1..);
        let end = [' ', '\t', '\r', '\n', '/', '>'];
        rest.and_then(|rest| rest.split(end).next())
            .unwrap_or_default()
    }

    /// The place of the start tag, or of its name alone where it takes more than one line.
    pub(crate) fn span(self) -> Span {
        let start = self.node.range().start;
        let name = start + 1 + self.name().len();
        let last = self.node.attributes().map(|a| a.range().end).next_back();
        let from = last.unwrap_or(name);
        let rest = self.text().get(from..).unwrap_or_default();
        let end = from + rest.find('>').map_or(0, |at| at + 1);
        let tag = self.text().get(start..end).unwrap_or_default();
        self.place(start, if tag.contains('\n') { name } else { end })
    }

    /// The elements directly inside, in the order of the file.
    pub(crate) fn children(self) -> impl Iterator<Item = Self> + use<'d> {
        let base = self.base;
        let nodes = self.node.children().filter(Node::is_element);
        nodes.map(move |node| Self { node, base })
    }

    /// The elements directly inside that have this name.
    pub(crate) fn children_named(self, name: &str) -> impl Iterator<Item = Self> {
        self.children().filter(move |child| child.name() == name)
    }

    /// Names, as they are written, and values of the attributes, in the order of the file; of prefixes nothing is said.
    pub(crate) fn attributes(
        self,
    ) -> impl Iterator<Item = (Spanned<&'d str>, Spanned<&'d str>)> + use<'d> {
        self.node.attributes().map(move |attribute| {
            let range = attribute.range();
            let written = self.text().get(range.clone()).unwrap_or_default();
            let name = written.split(['=', ' ', '\t', '\r', '\n']).next();
            let name = name.unwrap_or_default();
            // A name holds no quotation mark: the first one opens the value.
            let quote = written.find(['"', '\'']).unwrap_or_default();
            let value = self.place(range.start + quote + 1, range.end - 1);
            (
                Spanned::new(name, self.place(range.start, range.start + name.len())),
                Spanned::new(attribute.value(), value),
            )
        })
    }

    /// The value of an attribute, and its place between the quotation marks.
    pub(crate) fn attribute(self, name: &str) -> Option<Spanned<&'d str>> {
        self.attributes()
            .find(|(found, _)| found.value == name)
            .map(|(_, value)| value)
    }
}

impl Known<'_> {
    /// No name at all.
    pub(crate) const NONE: Self = Self {
        attributes: &[],
        children: &[],
        ignored_attributes: &[],
        ignored_children: &[],
    };
}

/// Text for a message: escaped, and cut where it is long.
pub(crate) fn shown(text: &str) -> String {
    match text.char_indices().nth(MOST_SHOWN) {
        Some((end, _)) => format!("{}...", text[..end].escape_debug()),
        None => text.escape_debug().to_string(),
    }
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
        let mut warning = Diagnostic::warning(message).at(name.span, "ignored");
        if let Some(near) = nearest(name.value, known) {
            warning = warning.help(format!("did you mean `{near}`?"));
        } else if let [only] = known {
            warning = warning.help(format!("the only {what} here is `{only}`"));
        } else if !known.is_empty() {
            warning = warning.help(format!("the {what}s here are {}", list(known)));
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
                    .at(first.span(), "the first one"),
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

    /// A finite number, of an attribute that may be absent.
    pub(crate) fn optional_number(
        &mut self,
        element: Element<'_>,
        owner: &str,
        name: &str,
    ) -> Option<Spanned<f64>> {
        let value = element.attribute(name)?;
        self.number(value, &format!("`{name}` of {owner}"))
    }

    /// A finite number; `what` is the words for it, such as "`value` of `mass` of link `hub`".
    pub(crate) fn number(&mut self, value: Spanned<&str>, what: &str) -> Option<Spanned<f64>> {
        self.numbers(value, what).map(|[number]| number)
    }

    /// As many finite numbers as asked for, with space between them; minus zero becomes zero.
    pub(crate) fn numbers<const N: usize>(
        &mut self,
        value: Spanned<&str>,
        what: &str,
    ) -> Option<[Spanned<f64>; N]> {
        self.some_numbers(value, what, N, N)?.try_into().ok()
    }

    /// At least `least` and at most `most` finite numbers, with space between them; minus zero becomes zero.
    pub(crate) fn some_numbers(
        &mut self,
        value: Spanned<&str>,
        what: &str,
        least: usize,
        most: usize,
    ) -> Option<Vec<Spanned<f64>>> {
        let words: Vec<&str> = value.value.split_ascii_whitespace().collect();
        if words.len() < least || words.len() > most {
            let expected = match (least, most) {
                (1, 1) => "a number".to_owned(),
                (least, most) if least == most => format!("{least} numbers"),
                (least, most) => format!("{least} to {most} numbers"),
            };
            let found = match words.len() {
                0 => "is empty".to_owned(),
                1 => "has 1 entry".to_owned(),
                n => format!("has {n} entries"),
            };
            let fault = Diagnostic::error(format!("{what} {found}; expected {expected}"));
            self.faults
                .push(fault.at(value.span, format!("expected {expected}")));
            return None;
        }
        let several = words.len() > 1;
        let numbers: Vec<Option<Spanned<f64>>> = words
            .iter()
            .enumerate()
            .map(|(index, word)| {
                let word = Spanned::new(*word, word_span(value, word));
                if several {
                    self.word(word, &format!("entry {} of {what}", index + 1))
                } else {
                    self.word(word, what)
                }
            })
            .collect();
        numbers.into_iter().collect()
    }

    fn word(&mut self, word: Spanned<&str>, what: &str) -> Option<Spanned<f64>> {
        let found = shown(word.value);
        let (message, label) = match word.value.parse::<f64>() {
            // So that `-0.0` and `0` are the same description.
            Ok(number) if number.is_finite() => return Some(Spanned::new(number + 0.0, word.span)),
            Ok(_) if word.value.contains(|c: char| c.is_ascii_digit()) => (
                format!("{what} is {found}, which does not fit a 64-bit float"),
                "too large",
            ),
            Ok(_) => (
                format!("{what} is `{found}`; expected a finite number"),
                "not finite",
            ),
            Err(_) => (
                format!("{what} is `{found}`; expected a number"),
                "no number",
            ),
        };
        let mut fault = Diagnostic::error(message).at(word.span, label);
        if word.value.contains(',') {
            fault = fault.help("numbers stand with spaces between them, without commas");
        }
        self.faults.push(fault);
        None
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
            list(&names)
        );
        let mut fault = Diagnostic::error(fault).at(value.span, "unknown");
        if let Some(near) = nearest(value.value, &names) {
            fault = fault.help(format!("did you mean `{near}`?"));
        }
        self.faults.push(fault);
        None
    }
}

/// The place of a word of a value; that of the whole value where entities or line ends of two bytes move its words.
fn word_span(value: Spanned<&str>, word: &str) -> Span {
    let at = word.as_ptr() as usize - value.value.as_ptr() as usize;
    if value.span.end - value.span.start == value.value.len() {
        Span::from(value.span.start + at..value.span.start + at + word.len())
    } else {
        value.span
    }
}
