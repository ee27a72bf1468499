//! XML as readers of robots take it, made XML.
//!
//! In: text. Out: [`Mended`], the text where it is XML already, or else one in which spaces stand between attributes, prefixes are
//! declared, and late declarations, text outside the root element and hyphens in comments are blanked, with a warning each.
//! Afterwards: [`Mended::place`] leads back to the text as it is written. Does not: judge what is left.

use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};

use crate::diagnostic::{Diagnostic, Span};
use crate::limits::{TOLD, XML_NAMESPACES};

/// What words call several of them.
const PLURAL: &str = "places that are no valid XML and are read all the same";

/// A text that may have been mended.
#[derive(Debug)]
pub(crate) struct Mended<'t> {
    pub(super) written: &'t str,
    pub(super) text: Cow<'t, str>,
    insertions: Vec<Insertion>,
    /// What was mended.
    pub(crate) warnings: Vec<Diagnostic>,
}

/// Where something stands that the user did not write.
#[derive(Debug)]
struct Insertion {
    /// The place of its first byte in the mended text.
    start: usize,
    /// How many bytes were inserted up to its end.
    total: usize,
}

/// A change of the text, which replaces these bytes.
struct Edit {
    from: Span,
    by: String,
}

impl<'t> Mended<'t> {
    /// The text as XML has it.
    pub(crate) fn text(&self) -> &str {
        &self.text
    }

    /// Mends a text whose first byte has the place `base`.
    pub(crate) fn of(written: &'t str, base: usize) -> Self {
        let mut scan = Scan::new(written, base);
        scan.run();
        scan.declare();
        let mut mended = Self {
            written,
            text: Cow::Borrowed(written),
            insertions: Vec::new(),
            warnings: scan.warnings,
        };
        if scan.edits.is_empty() {
            return mended;
        }
        let mut edits = scan.edits;
        edits.sort_by_key(|edit| edit.from.start);
        let (mut text, mut done, mut total) = (String::new(), 0, 0);
        for Edit { from, by } in edits {
            text.push_str(&written[done..from.start]);
            if from.start == from.end {
                total += by.len();
                let start = text.len();
                mended.insertions.push(Insertion { start, total });
            }
            text.push_str(&by);
            done = from.end;
        }
        text.push_str(&written[done..]);
        mended.text = Cow::Owned(text);
        mended
    }

    /// The place in the written text of a place in the mended one.
    pub(super) fn place(&self, at: usize) -> usize {
        let before = self.insertions.partition_point(|one| one.start < at);
        match before.checked_sub(1).and_then(|last| {
            let earlier = last
                .checked_sub(1)
                .map_or(0, |one| self.insertions[one].total);
            Some((self.insertions.get(last)?, earlier))
        }) {
            None => at,
            // Inside what was inserted, its start.
            Some((last, earlier)) => (at - last.total.min(at)).max(last.start - earlier),
        }
    }
}

/// A way through a text.
struct Scan<'t> {
    text: &'t str,
    base: usize,
    at: usize,
    /// How many elements are open.
    depth: usize,
    /// Where the name of the root element ends.
    root: Option<usize>,
    declared: BTreeSet<&'t str>,
    used: BTreeMap<&'t str, Span>,
    edits: Vec<Edit>,
    warnings: Vec<Diagnostic>,
}

impl<'t> Scan<'t> {
    fn new(text: &'t str, base: usize) -> Self {
        Self {
            text,
            base,
            at: 0,
            depth: 0,
            root: None,
            declared: BTreeSet::new(),
            used: BTreeMap::new(),
            edits: Vec::new(),
            warnings: Vec::new(),
        }
    }

    fn rest(&self) -> &'t str {
        &self.text[self.at..]
    }

    fn warn(&mut self, message: String, from: usize, to: usize) {
        if self.warnings.len() < TOLD {
            let span = Span::from(self.base + from..self.base + to);
            let subject = message.clone();
            let warning = Diagnostic::warning(message).at(span, "not valid XML");
            self.warnings.push(warning.one_of(PLURAL, subject));
        }
    }

    fn blank(&mut self, from: usize, to: usize) {
        let blank = |c: char| {
            if c.is_ascii_whitespace() {
                c.to_string()
            } else {
                " ".repeat(c.len_utf8())
            }
        };
        let by = self.text[from..to].chars().map(blank).collect();
        let from = Span::from(from..to);
        self.edits.push(Edit { from, by });
    }

    /// Looks through the text, up to its end or to what cannot be mended.
    fn run(&mut self) {
        // A mark of the encoding may stand first.
        if self.text.starts_with('\u{feff}') {
            self.at = '\u{feff}'.len_utf8();
        }
        let first = self.at;
        while let Some(length) = self.rest().find('<') {
            self.outside(length);
            self.at += length;
            let rest = self.rest();
            let went_on = if rest.starts_with("<!--") {
                self.comment()
            } else if rest.starts_with("<![CDATA[") {
                self.skip("]]>").is_some()
            } else if rest.starts_with("<?") {
                self.instruction(first)
            } else if rest.starts_with("</") {
                self.depth = self.depth.saturating_sub(1);
                self.skip(">").is_some()
            } else {
                self.start_tag()
            };
            if !went_on {
                return;
            }
        }
        if self.root.is_some() && self.depth == 0 {
            self.outside(self.rest().len());
        }
    }

    /// Goes behind the next of these; gives the place where that begins.
    fn skip(&mut self, close: &str) -> Option<usize> {
        let end = self.at + self.rest().find(close)?;
        self.at = end + close.len();
        Some(end)
    }

    /// Text up to the next markup.
    fn outside(&mut self, length: usize) {
        let found = self.rest()[..length].trim();
        if self.depth == 0 && !found.is_empty() {
            let (from, to) = (self.at, self.at + length);
            let start = from + self.rest().find(found).unwrap_or(0);
            let message = "text outside the root element is left out".to_owned();
            self.warn(message, start, start + found.len());
            self.blank(from, to);
        }
    }

    fn comment(&mut self) -> bool {
        let from = self.at + "<!--".len();
        self.at = from;
        let Some(to) = self.skip("-->") else {
            return false;
        };
        let inside = &self.text[from..to];
        if inside.contains("--") || inside.ends_with('-') {
            self.warn("a comment holds `--`".to_owned(), from, to);
            let by = inside.replace('-', "_");
            let from = Span::from(from..to);
            self.edits.push(Edit { from, by });
        }
        true
    }

    fn instruction(&mut self, first: usize) -> bool {
        let from = self.at;
        let is_declaration = self.rest()["<?".len()..]
            .strip_prefix("xml")
            .is_some_and(|rest| rest.starts_with(|c: char| c.is_ascii_whitespace()));
        if self.skip("?>").is_none() {
            return false;
        }
        if is_declaration && from > first {
            let message = "the XML declaration does not stand first".to_owned();
            self.warn(message, from, self.at);
            self.blank(from, self.at);
        }
        true
    }

    /// A start tag; false where it is none.
    fn start_tag(&mut self) -> bool {
        self.at += 1;
        let is_name = |rest: &str| rest.starts_with(|c: char| c.is_alphabetic() || c == '_');
        if !is_name(self.rest()) {
            return false;
        }
        self.name();
        if self.root.is_none() {
            self.root = Some(self.at);
        }
        loop {
            let spaced = self.space();
            let rest = self.rest();
            if let Some(end) = ["/>", ">"].into_iter().find(|end| rest.starts_with(end)) {
                self.at += end.len();
                self.depth += usize::from(end == ">");
                return true;
            }
            if !is_name(rest) {
                return false;
            }
            if !spaced {
                let at = self.at;
                let message = "no space stands between two attributes".to_owned();
                self.warn(message, at, at + 1);
                self.edits.push(Edit {
                    from: Span::from(at..at),
                    by: " ".to_owned(),
                });
            }
            if !self.attribute() {
                return false;
            }
        }
    }

    /// Goes behind a name, and keeps its prefix.
    fn name(&mut self) {
        let rest = self.rest();
        let ends =
            |c: char| c.is_ascii_whitespace() || ['=', '/', '>', '<', '"', '\''].contains(&c);
        let name = &rest[..rest.find(ends).unwrap_or(rest.len())];
        if let Some((prefix, local)) = name.split_once(':') {
            if prefix == "xmlns" {
                self.declared.insert(local);
            } else if prefix != "xml" && !prefix.is_empty() {
                let span = Span::from(self.at..self.at + prefix.len());
                self.used.entry(prefix).or_insert(span);
            }
        }
        self.at += name.len();
    }

    /// Goes behind white space; true where there is any.
    fn space(&mut self) -> bool {
        let rest = self.rest();
        let length = rest.len() - rest.trim_ascii_start().len();
        self.at += length;
        length > 0
    }

    /// A name, and a value in quotation marks.
    fn attribute(&mut self) -> bool {
        self.name();
        self.space();
        if !self.rest().starts_with('=') {
            return false;
        }
        self.at += 1;
        self.space();
        let Some(quote) = ["\"", "'"].into_iter().find(|q| self.rest().starts_with(q)) else {
            return false;
        };
        self.at += 1;
        self.skip(quote).is_some()
    }

    /// Declares the prefixes that are used and nowhere declared, at the root element.
    fn declare(&mut self) {
        let Some(root) = self.root else { return };
        let used = std::mem::take(&mut self.used).into_iter();
        let is_plain = |prefix: &str| {
            prefix
                .chars()
                .all(|c| c.is_alphanumeric() || "_-.".contains(c))
        };
        let missing =
            used.filter(|(prefix, _)| !self.declared.contains(prefix) && is_plain(prefix));
        let missing: Vec<(&str, Span)> = missing.take(XML_NAMESPACES).collect();
        let declared = missing
            .iter()
            .map(|(prefix, _)| format!(" xmlns:{prefix}=\"{prefix}\""));
        let by: String = declared.collect();
        for (prefix, span) in missing {
            let message = format!("the prefix `{prefix}` is not declared");
            self.warn(message, span.start, span.end);
        }
        if !by.is_empty() {
            let from = Span::from(root..root);
            self.edits.push(Edit { from, by });
        }
    }
}
