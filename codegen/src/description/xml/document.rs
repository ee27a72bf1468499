//! XML elements with their places.

use roxmltree::{Node, ParsingOptions};

use crate::description::lfs;
use crate::description::xml::malformed::malformed;
use crate::description::xml::markup;
use crate::description::xml::mend::Mended;
use crate::diagnostic::{Diagnostic, Span, Spanned};
use crate::limits::XML_NODES;

/// A file as elements.
#[derive(Debug)]
pub(crate) struct Document<'t> {
    tree: roxmltree::Document<'t>,
    mended: &'t Mended<'t>,
    /// Added to every place.
    base: usize,
}

/// An element of a [`Document`].
#[derive(Clone, Copy, Debug)]
pub(crate) struct Element<'d> {
    node: Node<'d, 'd>,
    mended: &'d Mended<'d>,
    base: usize,
}

impl<'t> Document<'t> {
    /// Reads a file whose first byte has the place `base`.
    pub(crate) fn parse(mended: &'t Mended<'t>, base: usize) -> Result<Self, Diagnostic> {
        if let Some(fault) = lfs::pointer(mended.written, base) {
            return Err(fault);
        }
        markup::check(mended.written).map_err(|fault| fault.moved(base))?;
        let text = &*mended.text;
        let options = ParsingOptions {
            nodes_limit: XML_NODES,
            ..ParsingOptions::default()
        };
        match roxmltree::Document::parse_with_options(text, options) {
            Ok(tree) => Ok(Self { tree, mended, base }),
            Err(error) => Err(malformed(mended, base, &error)),
        }
    }

    /// The root element.
    pub(crate) fn root(&self) -> Element<'_> {
        Element {
            node: self.tree.root_element(),
            mended: self.mended,
            base: self.base,
        }
    }
}

impl<'d> Element<'d> {
    fn text(self) -> &'d str {
        self.node.document().input_text()
    }

    fn place(self, start: usize, end: usize) -> Span {
        let [start, end] = [start, end].map(|at| self.base + self.mended.place(at));
        Span::from(start..end)
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

    /// The first text directly inside that is not blank: comments may stand around it.
    pub(crate) fn content(self) -> Option<&'d str> {
        let mut texts = self.node.children().filter(Node::is_text);
        texts.find_map(|node| node.text().filter(|text| !text.trim_ascii().is_empty()))
    }

    /// The elements directly inside, in the order of the file.
    pub(crate) fn children(self) -> impl Iterator<Item = Self> + use<'d> {
        let (mended, base) = (self.mended, self.base);
        let nodes = self.node.children().filter(Node::is_element);
        nodes.map(move |node| Self { node, mended, base })
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
