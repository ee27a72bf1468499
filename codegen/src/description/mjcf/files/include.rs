//! The files that a model names: those that it includes, and models that it attaches.
//!
//! In: a file and a way to read others. Out: [`Included`], and the texts behind one another in the source. Afterwards: no model
//! includes a file twice, so no file includes itself; elements are nested at most [`DEEPEST`] deep in each file.

use std::collections::BTreeMap;
use std::io;

use crate::description::mjcf::files::paths::is_absolute;
use crate::description::xml::{Document, Element, Known, Mended, Reader};
use crate::description::{Include, too_large, utf8};
use crate::diagnostic::{Diagnostic, Source, Span, shown};

/// How deep elements may be nested in a file; MuJoCo's own limit.
const DEEPEST: usize = 500;

/// Which files are named, and where.
#[derive(Debug, Default)]
pub(in crate::description::mjcf) struct Included {
    /// The number of the file, by the place of the element that names it.
    pub(in crate::description::mjcf) named: BTreeMap<usize, usize>,
    /// The folder of each file, from the main file's, with a stroke behind it.
    pub(in crate::description::mjcf) folders: Vec<String>,
    /// True of each file that can be read as elements.
    pub(in crate::description::mjcf) usable: Vec<bool>,
    /// The element that names each file, and in which file that stands; `None` for the main file.
    from: Vec<Option<(Span, usize)>>,
    /// The first file of the model to which each file belongs.
    models: Vec<usize>,
    /// The number of each file, by the first file of its model, and by its path from the main file's folder.
    paths: BTreeMap<(usize, String), usize>,
    /// The number of the first file of each attached model, by its path.
    model_paths: BTreeMap<String, usize>,
    /// What could not be read, and why: it is not tried twice.
    failed: BTreeMap<String, (io::ErrorKind, String)>,
}

/// An element that names a file.
struct Target {
    path: String,
    path_span: Span,
    element: Span,
    /// True where the file is a model of its own.
    is_model: bool,
}

/// What stands at a path.
enum Found {
    /// A file with this number, which is read already.
    Known(usize),
    Text(String),
    Missing(io::Error),
}

/// Reads all files that the source's file names, and those that these name, and appends them to it.
pub(in crate::description::mjcf) fn load(
    reader: &mut Reader,
    source: &mut Source,
    read: Include<'_>,
) -> Included {
    let mut included = Included::default();
    let (folder, name) = match source.name().rsplit_once('/') {
        Some((folder, name)) => (format!("{folder}/"), name.to_owned()),
        None => (String::new(), source.name().to_owned()),
    };
    included.add(0, &name, None);
    loop {
        let index = included.usable.len();
        let Some(targets) = targets_of(reader, source, &included, index) else {
            return included;
        };
        included.usable.push(targets.is_some());
        for target in targets.unwrap_or_default() {
            let model = target.is_model.then_some(included.from.len());
            let model = model.unwrap_or(included.models[index]);
            let (path, found) = included.look(index, &target, read);
            match found {
                Found::Text(text) => {
                    source.append(format!("{folder}{path}"), text);
                    if let Some(fault) = too_large(source) {
                        reader
                            .faults
                            .push(fault.at(target.path_span, target.label()));
                        return Included::default();
                    }
                    let number = included.from.len();
                    included.named.insert(target.element.start, number);
                    included.add(model, &path, Some((target.element, index)));
                }
                Found::Known(known) if target.is_model => {
                    included.named.insert(target.element.start, known);
                }
                Found::Known(known) => {
                    reader
                        .faults
                        .push(repeated(&included, known, index, &target));
                }
                Found::Missing(error) => reader.faults.push(target.missing(&error)),
            }
        }
    }
}

/// The files that a file names, `None` in it where it cannot be read; `None` behind the last file.
#[expect(
    clippy::option_option,
    reason = "no file, and a file that cannot be read"
)]
fn targets_of(
    reader: &mut Reader,
    source: &Source,
    included: &Included,
    index: usize,
) -> Option<Option<Vec<Target>>> {
    let file = source.files().nth(index)?;
    let mut mended = Mended::of(file.text(), file.base());
    for warning in mended.warnings.drain(..) {
        reader.faults.push(warning);
    }
    Some(match Document::parse(&mended, file.base()) {
        // It is refused later, whatever its elements name.
        Ok(document) if index == 0 && !is_model(document.root()) => Some(Vec::new()),
        Ok(document) => targets(reader, document.root()),
        Err(fault) => {
            let from = included.from.get(index).copied().flatten();
            let label = label(included.models[index] == index);
            let fault = fault.at_if(from.map(|(span, _)| span), label);
            reader.faults.push(fault);
            None
        }
    })
}

/// True for the root element of a model.
pub(in crate::description::mjcf) fn is_model(root: Element<'_>) -> bool {
    root.name() == "mujoco"
}

/// The words at an element that names a file.
fn label(is_model: bool) -> &'static str {
    if is_model {
        "named here"
    } else {
        "included here"
    }
}

impl Target {
    fn label(&self) -> &'static str {
        label(self.is_model)
    }

    fn missing(&self, error: &io::Error) -> Diagnostic {
        let kind = if self.is_model {
            "model file"
        } else {
            "included file"
        };
        let message = format!("the {kind} `{}` cannot be read: {error}", shown(&self.path));
        Diagnostic::error(message).at(self.path_span, self.label())
    }
}

impl Included {
    /// Adds a file of a model, which is that of the model's first file.
    fn add(&mut self, model: usize, path: &str, from: Option<(Span, usize)>) {
        let number = self.from.len();
        let folder = if from.is_some() {
            folder_of(path)
        } else {
            String::new()
        };
        if number == model && from.is_some() {
            self.model_paths.insert(normal(path), number);
        }
        self.paths.insert((model, normal(path)), number);
        self.folders.push(folder);
        self.models.push(model);
        self.from.push(from);
    }

    /// What stands beside the model's first file, or else beside the file that names it.
    fn look(&mut self, index: usize, target: &Target, read: Include<'_>) -> (String, Found) {
        let model = self.models[index];
        let known = |path: &str| {
            let path = normal(path);
            if target.is_model {
                self.model_paths.get(&path).copied()
            } else {
                self.paths.get(&(model, path)).copied()
            }
        };
        let first = self.beside(model, &target.path);
        let other = self.beside(index, &target.path);
        let first_known = known(&first);
        let other_known = known(&other);
        let found = self.at(&first, first_known, read);
        if matches!(found, Found::Missing(_)) && other != first {
            let there = self.at(&other, other_known, read);
            if !matches!(there, Found::Missing(_)) {
                return (other, there);
            }
        }
        (first, found)
    }

    fn at(&mut self, path: &str, known: Option<usize>, read: Include<'_>) -> Found {
        if let Some(known) = known {
            return Found::Known(known);
        }
        let again = |(kind, why): &(io::ErrorKind, String)| io::Error::new(*kind, why.clone());
        if let Some(failed) = self.failed.get(path) {
            return Found::Missing(again(failed));
        }
        match read(path).and_then(utf8) {
            Ok(text) => Found::Text(text),
            Err(error) => {
                let failed = (error.kind(), error.to_string());
                self.failed.insert(path.to_owned(), failed);
                Found::Missing(error)
            }
        }
    }

    /// The path from the main file's folder of what stands beside a file.
    fn beside(&self, file: usize, path: &str) -> String {
        let folder = &self.folders[file];
        if is_absolute(path) {
            path.to_owned()
        } else {
            format!("{folder}{path}")
        }
    }
}

/// The folder of a file, with a stroke behind it, or nothing.
fn folder_of(path: &str) -> String {
    path.rsplit_once('/')
        .map_or_else(String::new, |(folder, _)| format!("{folder}/"))
}

/// Each `include` of a file, and each `model` among its assets; `None` where elements are nested too deep.
fn targets(reader: &mut Reader, root: Element<'_>) -> Option<Vec<Target>> {
    let mut targets = Vec::new();
    let mut open = vec![root.children()];
    while let Some(children) = open.last_mut() {
        let Some(element) = children.next() else {
            open.pop();
            continue;
        };
        if let "include" | "model" = element.name() {
            targets.extend(target(reader, element));
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

fn target(reader: &mut Reader, element: Element<'_>) -> Option<Target> {
    let is_model = element.name() == "model";
    let known = Known {
        attributes: if is_model {
            &["name", "file"]
        } else {
            &["file"]
        },
        ignored_attributes: &["prefix", "content_type"],
        ..Known::NONE
    };
    let owner = if is_model { "`model`" } else { "`include`" };
    reader.unknown(element, owner, &known);
    let file = reader.required(element, owner, "file")?;
    Some(Target {
        path: file.value.to_owned(),
        path_span: file.span,
        element: element.span(),
        is_model,
    })
}

/// What is wrong where file `index` includes file `known` again.
fn repeated(included: &Included, known: usize, index: usize, target: &Target) -> Diagnostic {
    let path = shown(&target.path);
    let from = |file: usize| included.from.get(file).copied().flatten();
    let mut file = Some(index);
    while let Some(number) = file {
        if number == known {
            let message = format!("`{path}` includes itself");
            return Diagnostic::error(message).at(target.path_span, "included again");
        }
        file = from(number).map(|(_, from)| from);
    }
    let message = format!("`{path}` is included twice; a file may be included once");
    let fault = Diagnostic::error(message).at(target.path_span, "included again");
    fault.at_if(from(known).map(|(first, _)| first), "included first")
}

/// A path in which `./` and `folder/../` make no difference.
fn normal(path: &str) -> String {
    let mut places: Vec<&str> = Vec::new();
    let parts = path.split('/').enumerate();
    // An empty part at the beginning is the root.
    let parts = parts.filter(|(index, part)| *part != "." && (*index == 0 || !part.is_empty()));
    for (_, part) in parts {
        let last = places.last().copied();
        if part == ".." && last == Some("") {
            continue;
        }
        if part == ".." && last.is_some_and(|last| last != "..") {
            places.pop();
        } else {
            places.push(part);
        }
    }
    places.join("/")
}
