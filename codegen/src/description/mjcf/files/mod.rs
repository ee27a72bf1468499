//! A model's files as elements: those that are included stand where they are included.

pub(in crate::description::mjcf) mod include;
pub(in crate::description::mjcf) mod paths;

use std::collections::BTreeMap;

use crate::description::mjcf::files::include::Included;
use crate::description::xml::{Document, Element, Mended};
use crate::diagnostic::{Source, Span};

/// The files as elements; none for a file that is not XML.
#[derive(Debug)]
pub(in crate::description::mjcf) struct Files<'s> {
    documents: Vec<Option<Document<'s>>>,
    /// The number of the file, by the place of the element that names it: an `include`, or a `model` among the assets.
    named: BTreeMap<usize, usize>,
    /// The place of each file's first byte, and its folder from the main file's.
    folders: Vec<(usize, String)>,
}

impl<'s> Files<'s> {
    /// The files of a source that [`include::load`](include::load) filled.
    pub(in crate::description::mjcf) fn parse(
        source: &Source,
        texts: &'s [Mended<'s>],
        included: Included,
    ) -> Self {
        let folders = source.files().zip(&included.folders);
        let folders = folders.map(|(file, folder)| {
            let folder = folder.strip_suffix('/').unwrap_or(folder);
            (file.base(), folder.to_owned())
        });
        let folders = folders.collect();
        let files = source.files().zip(texts).zip(included.usable);
        let documents = files.map(|((file, text), usable)| {
            // What is wrong with the others was said as they were loaded.
            usable
                .then(|| Document::parse(text, file.base()).ok())
                .flatten()
        });
        Self {
            documents: documents.collect(),
            named: included.named,
            folders,
        }
    }

    /// The folder of the file in which a place lies, from the main file's; empty for that itself.
    pub(in crate::description::mjcf) fn folder(&self, place: Span) -> &str {
        let after = self
            .folders
            .partition_point(|(base, _)| *base <= place.start);
        let file = after
            .checked_sub(1)
            .and_then(|index| self.folders.get(index));
        file.map_or("", |(_, folder)| folder)
    }

    /// The root element of the main file.
    pub(in crate::description::mjcf) fn root(&self) -> Option<Element<'_>> {
        self.document(0)
    }

    /// The number of the file that an element names, and its root element.
    pub(in crate::description::mjcf) fn named(
        &self,
        element: Element<'_>,
    ) -> Option<(usize, Element<'_>)> {
        let number = *self.named.get(&element.span().start)?;
        Some((number, self.document(number)?))
    }

    fn document(&self, number: usize) -> Option<Element<'_>> {
        let document = self.documents.get(number)?.as_ref()?;
        Some(document.root())
    }

    /// The elements directly inside another one, those of included files among them.
    pub(in crate::description::mjcf) fn children<'d>(
        &'d self,
        element: Element<'d>,
    ) -> Vec<Element<'d>> {
        let mut children = Vec::new();
        let mut open = vec![element.children()];
        while let Some(inside) = open.last_mut() {
            match inside.next() {
                None => {
                    open.pop();
                }
                Some(child) if child.name() == "include" => {
                    let named = self.named(child);
                    open.extend(named.map(|(_, root)| root.children()));
                }
                Some(child) => children.push(child),
            }
        }
        children
    }
}
