//! `include`: the elements of other files in the places where they are included.
//!
//! In: a file and a way to read others. Out: [`Files`], in which an element's children are those of the files that it
//! includes, too. Afterwards: no file is included twice, so none includes itself; elements are nested at most
//! [`DEEPEST`] deep in each file.

use std::collections::BTreeMap;
use std::io;

use crate::description::xml::{Document, Element, Known, Mended, Reader, shown};
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
    /// The folder of each file, from the main file's, with a stroke behind it.
    folders: Vec<String>,
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
    included.folders.push(String::new());
    loop {
        let index = included.usable.len();
        let Some(file) = source.files().nth(index) else {
            return included;
        };
        let mut mended = Mended::of(file.text(), file.base());
        for warning in mended.warnings.drain(..) {
            reader.faults.push(warning);
        }
        let targets = match Document::parse(&mended, file.base()) {
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
        for (written, path_span, element) in targets.unwrap_or_default() {
            // Beside the main file, or else beside the one that includes it.
            let beside = included.beside(index, &written);
            let mut path = written.clone();
            let mut found = included
                .find(&path)
                .map_or_else(|| Found::of(read(&path).and_then(utf8)), Found::Known);
            if let (Found::Missing(_), Some(other)) = (&found, beside) {
                let there = included.find(&other);
                let there =
                    there.map_or_else(|| Found::of(read(&other).and_then(utf8)), Found::Known);
                if !matches!(there, Found::Missing(_)) {
                    (path, found) = (other, there);
                }
            }
            let number = included.from.len();
            let fault = match found {
                Found::Known(known) => repeated(&included, known, index, &written, path_span),
                Found::Text(text) => {
                    source.append(format!("{folder}{path}"), text);
                    if let Some(fault) = too_large(source) {
                        reader.faults.push(fault.at(path_span, "included here"));
                        return Included::default();
                    }
                    included.files.insert(element.start, number);
                    included.paths.insert(normal(&path), number);
                    included.folders.push(folder_of(&path));
                    included.from.push(Some((element, index)));
                    continue;
                }
                Found::Missing(error) => {
                    let written = shown(&written);
                    let message = format!("the included file `{written}` cannot be read: {error}");
                    Diagnostic::error(message).at(path_span, "included here")
                }
            };
            reader.faults.push(fault);
        }
    }
}

/// What stands at a path.
enum Found {
    /// A file with this number, which is read already.
    Known(usize),
    Text(String),
    Missing(io::Error),
}

impl Found {
    fn of(text: io::Result<String>) -> Self {
        text.map_or_else(Self::Missing, Self::Text)
    }
}

impl Included {
    fn find(&self, path: &str) -> Option<usize> {
        self.paths.get(&normal(path)).copied()
    }

    /// The path from the main file's folder of what stands beside a file, unless that is the same folder.
    fn beside(&self, file: usize, path: &str) -> Option<String> {
        let folder = self.folders.get(file)?;
        (!folder.is_empty() && !path.starts_with('/')).then(|| format!("{folder}{path}"))
    }
}

/// The folder of a file, with a stroke behind it, or nothing.
fn folder_of(path: &str) -> String {
    path.rsplit_once('/')
        .map_or_else(String::new, |(folder, _)| format!("{folder}/"))
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
    pub(super) fn parse(source: &Source, texts: &'s [Mended<'s>], included: Included) -> Self {
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
