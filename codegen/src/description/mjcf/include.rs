//! `include`: the elements of other files in the places where they are included.
//!
//! In: a file and a way to read others. Out: [`Files`], in which an element's children are those of the files that it
//! includes, too. Afterwards: no file is included twice, so none includes itself; elements are nested at most
//! [`DEEPEST`] deep in each file.

use std::collections::BTreeMap;

use crate::description::xml::{Document, Element, Known, Reader, shown};
use crate::description::{Include, too_large, utf8};
use crate::diagnostic::{Diagnostic, Source, Span};

/// How deep elements may be nested in a file; MuJoCo's own limit.
const DEEPEST: usize = 500;

/// Which files are included, and where.
#[derive(Debug, Default)]
pub(super) struct Included {
    /// The number of the file, by the place of the element that includes it.
    files: BTreeMap<usize, usize>,
    /// The element that includes each file, and in which file that stands; `None` for the main file.
    from: Vec<Option<(Span, usize)>>,
    /// The number of each file, by its path from the main file's folder.
    paths: BTreeMap<String, usize>,
    /// True of each file that can be read as elements.
    usable: Vec<bool>,
}

/// The files as elements; none for a file that is not XML.
#[derive(Debug)]
pub(super) struct Files<'s> {
    documents: Vec<Option<Document<'s>>>,
    /// The number of the file, by the place of the element that includes it.
    included: BTreeMap<usize, usize>,
    /// The place of each file's first byte, and its folder from the main file's.
    folders: Vec<(usize, String)>,
}

/// Reads all files that the source's file includes, and appends them to it.
pub(super) fn load(reader: &mut Reader, source: &mut Source, read: Include<'_>) -> Included {
    let mut included = Included::default();
    let (folder, name) = match source.name().rsplit_once('/') {
        Some((folder, name)) => (format!("{folder}/"), name.to_owned()),
        None => (String::new(), source.name().to_owned()),
    };
    included.paths.insert(name, 0);
    included.from.push(None);
    loop {
        let index = included.usable.len();
        let Some(file) = source.files().nth(index) else {
            return included;
        };
        let targets = match Document::parse(file.text(), file.base()) {
            Ok(document) => targets(reader, document.root()),
            Err(fault) => {
                let from = included.from.get(index).copied().flatten();
                reader.faults.push(match from {
                    Some((span, _)) => fault.at(span, "included here"),
                    None => fault,
                });
                None
            }
        };
        included.usable.push(targets.is_some());
        for (path, path_span, element) in targets.unwrap_or_default() {
            let place = normal(&path);
            if let Some(known) = included.paths.get(&place) {
                let fault = repeated(&included, *known, index, &path, path_span);
                reader.faults.push(fault);
                continue;
            }
            let number = included.from.len();
            match read(&path).and_then(utf8) {
                Ok(text) => {
                    source.append(format!("{folder}{path}"), text);
                    if let Some(fault) = too_large(source) {
                        reader.faults.push(fault.at(path_span, "included here"));
                        return Included::default();
                    }
                    included.files.insert(element.start, number);
                    included.paths.insert(place, number);
                    included.from.push(Some((element, index)));
                }
                Err(error) => {
                    let message = format!(
                        "the included file `{}` cannot be read: {error}",
                        shown(&path)
                    );
                    let fault = Diagnostic::error(message).at(path_span, "included here");
                    reader.faults.push(fault);
                }
            }
        }
    }
}

/// The path, its place and its element's place of each `include` of a file; `None` where it is nested too deep.
fn targets(reader: &mut Reader, root: Element<'_>) -> Option<Vec<(String, Span, Span)>> {
    let known = Known {
        attributes: &["file"],
        ignored_attributes: &["prefix"],
        ..Known::NONE
    };
    let mut targets = Vec::new();
    let mut open = vec![root.children()];
    while let Some(children) = open.last_mut() {
        let Some(element) = children.next() else {
            open.pop();
            continue;
        };
        if element.name() == "include" {
            reader.unknown(element, "`include`", &known);
            if let Some(file) = reader.required(element, "`include`", "file") {
                targets.push((file.value.to_owned(), file.span, element.span()));
            }
        } else if open.len() >= DEEPEST {
            let message =
                format!("elements are nested more than {DEEPEST} deep; MuJoCo reads no more");
            let fault = Diagnostic::error(message).at(element.span(), "too deep");
            reader.faults.push(fault);
            return None;
        } else {
            open.push(element.children());
        }
    }
    Some(targets)
}

/// What is wrong where file `index` includes file `known` again.
fn repeated(included: &Included, known: usize, index: usize, path: &str, span: Span) -> Diagnostic {
    let path = shown(path);
    let from = |file: usize| included.from.get(file).copied().flatten();
    let mut file = Some(index);
    while let Some(number) = file {
        if number == known {
            let message = format!("`{path}` includes itself");
            return Diagnostic::error(message).at(span, "included again");
        }
        file = from(number).map(|(_, from)| from);
    }
    let message = format!("`{path}` is included twice; a file may be included once");
    let fault = Diagnostic::error(message).at(span, "included again");
    match from(known) {
        Some((first, _)) => fault.at(first, "included first"),
        None => fault,
    }
}

/// A path in which `./` and `folder/../` make no difference.
fn normal(path: &str) -> String {
    let mut places: Vec<&str> = Vec::new();
    for part in path.split('/').filter(|part| *part != ".") {
        if part == ".." && places.last().is_some_and(|last| *last != "..") {
            places.pop();
        } else {
            places.push(part);
        }
    }
    places.join("/")
}

impl<'s> Files<'s> {
    /// The files of a source that [`load`] filled.
    pub(super) fn parse(source: &'s Source, included: Included) -> Self {
        let mut folders: Vec<(usize, String)> = source
            .files()
            .map(|file| (file.base(), String::new()))
            .collect();
        for (path, number) in &included.paths {
            if let (Some((folder, _)), Some(place)) =
                (path.rsplit_once('/'), folders.get_mut(*number))
            {
                folder.clone_into(&mut place.1);
            }
        }
        let files = source.files().zip(included.usable);
        let documents = files.map(|(file, usable)| {
            // What is wrong with the others was said as they were loaded.
            usable
                .then(|| Document::parse(file.text(), file.base()).ok())
                .flatten()
        });
        Self {
            documents: documents.collect(),
            included: included.files,
            folders,
        }
    }

    /// The folder of the file in which a place lies, from the main file's; empty for that itself.
    pub(super) fn folder(&self, place: Span) -> &str {
        let after = self
            .folders
            .partition_point(|(base, _)| *base <= place.start);
        let file = after
            .checked_sub(1)
            .and_then(|index| self.folders.get(index));
        file.map_or("", |(_, folder)| folder)
    }

    /// The root element of the main file.
    pub(super) fn root(&self) -> Option<Element<'_>> {
        self.document(0)
    }

    fn document(&self, number: usize) -> Option<Element<'_>> {
        let document = self.documents.get(number)?.as_ref()?;
        Some(document.root())
    }

    /// The elements directly inside another one, those of included files among them.
    pub(super) fn children<'d>(&'d self, element: Element<'d>) -> Vec<Element<'d>> {
        let mut children = Vec::new();
        let mut open = vec![element.children()];
        while let Some(inside) = open.last_mut() {
            match inside.next() {
                None => {
                    open.pop();
                }
                Some(child) if child.name() == "include" => {
                    let file = self.included.get(&child.span().start);
                    let root = file.and_then(|file| self.document(*file));
                    open.extend(root.map(Element::children));
                }
                Some(child) => children.push(child),
            }
        }
        children
    }
}
