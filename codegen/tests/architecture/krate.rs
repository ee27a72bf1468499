//! The modules of a crate, each with what it defines and what it speaks of.

use std::collections::{BTreeMap, BTreeSet};

use syn::{Expr, Item, Lit, Meta};

use crate::{
    imports::{self, Spoken, Use},
    walk::Sources,
};

/// A module.
#[derive(Debug, Default)]
pub(crate) struct Module {
    /// The file in which it stands.
    pub(crate) file: String,
    /// The module in which it stands.
    pub(crate) parent: usize,
    /// Modules in it, in the order in which they are listed.
    pub(crate) children: Vec<(String, usize)>,
    /// Names of what it defines, but for modules.
    pub(crate) defined: BTreeSet<String>,
    /// What its `use` lines bring.
    pub(crate) uses: Vec<Use>,
    /// What the rest of it speaks of.
    pub(crate) spoken: Spoken,
}

/// A crate; the first module is its root.
#[derive(Debug)]
pub(crate) struct Crate {
    pub(crate) modules: Vec<Module>,
}

/// A path in one file that names what stands in another one.
pub(crate) type Imports = BTreeMap<String, BTreeMap<String, String>>;

/// Where the files of a module's own modules are.
struct Place<'a> {
    /// The module's file.
    file: &'a str,
    /// The folder of the files, with a `/` at its end.
    folder: String,
}

impl Crate {
    /// Reads the crate with this root, all files of which are below one folder. Files that are elsewhere are left out.
    pub(crate) fn read(sources: &Sources, root: &str) -> Self {
        let mut all = Self {
            modules: Vec::new(),
        };
        all.add_file(sources, root, String::new(), 0);
        all
    }

    fn add_file(&mut self, sources: &Sources, file: &str, folder: String, parent: usize) -> usize {
        let parsed = syn::parse_file(&sources.0[file]);
        let items = parsed
            .unwrap_or_else(|error| panic!("{file}: {error}"))
            .items;
        self.add(sources, &Place { file, folder }, items, parent)
    }

    fn add(
        &mut self,
        sources: &Sources,
        place: &Place<'_>,
        items: Vec<Item>,
        parent: usize,
    ) -> usize {
        let own = self.modules.len();
        self.modules.push(Module {
            file: place.file.to_owned(),
            parent,
            ..Module::default()
        });
        for item in items {
            match item {
                Item::Mod(item) => {
                    let name = item.ident.to_string();
                    let within = format!("{}{name}/", place.folder);
                    let child = match item.content {
                        Some((_, items)) => {
                            let place = Place {
                                file: place.file,
                                folder: within,
                            };
                            Some(self.add(sources, &place, items, own))
                        }
                        None => file_of(sources, place, &name, &item.attrs)
                            .map(|file| self.add_file(sources, &file, within, own)),
                    };
                    let children = &mut self.modules[own].children;
                    children.extend(child.map(|child| (name, child)));
                }
                Item::Use(item) => {
                    self.modules[own].uses.extend(imports::of_use(&item));
                }
                item => {
                    self.modules[own].defined.extend(definition(&item));
                    imports::of_item(&item, &mut self.modules[own].spoken);
                }
            }
        }
        own
    }

    /// Which files import which others, each by the first path that was found.
    pub(crate) fn imports(&self) -> Imports {
        let mut imports = Imports::new();
        for (place, module) in self.modules.iter().enumerate() {
            let own = imports.entry(module.file.clone()).or_default();
            let uses = module.uses.iter().filter(|one| {
                let is_spoken_of = |name: &String| module.spoken.names.contains(name);
                !one.is_public || one.name.as_ref().is_some_and(is_spoken_of)
            });
            let paths = uses.map(|one| &one.path).chain(&module.spoken.paths);
            for path in paths {
                for file in self.files(place, path) {
                    if file != module.file {
                        own.entry(file).or_insert_with(|| path.join("::"));
                    }
                }
            }
        }
        imports
    }
}

/// The file of a module that is none of its parent's, if it is among the sources.
fn file_of(
    sources: &Sources,
    place: &Place<'_>,
    name: &str,
    attributes: &[syn::Attribute],
) -> Option<String> {
    let given = attributes
        .iter()
        .find_map(|attribute| match &attribute.meta {
            Meta::NameValue(pair) if pair.path.is_ident("path") => match &pair.value {
                Expr::Lit(literal) => match &literal.lit {
                    Lit::Str(text) => Some(text.value()),
                    _ => None,
                },
                _ => None,
            },
            _ => None,
        });
    let folder = &place.folder;
    let files = match given {
        Some(given) => {
            let folder = place.file.rsplit_once('/');
            let folder = folder.map_or(String::new(), |(folder, _)| format!("{folder}/"));
            vec![format!("{folder}{given}")]
        }
        None => vec![
            format!("{folder}{name}.rs"),
            format!("{folder}{name}/mod.rs"),
        ],
    };
    let mut files = files.into_iter();
    files.find(|file| sources.0.contains_key(file))
}

/// The name that an item defines; `None` for what has none.
fn definition(item: &Item) -> Option<String> {
    let name = match item {
        Item::Const(item) => &item.ident,
        Item::Enum(item) => &item.ident,
        Item::Fn(item) => &item.sig.ident,
        Item::Macro(item) => item.ident.as_ref()?,
        Item::Static(item) => &item.ident,
        Item::Struct(item) => &item.ident,
        Item::Trait(item) => &item.ident,
        Item::Type(item) => &item.ident,
        Item::Union(item) => &item.ident,
        _ => return None,
    };
    Some(name.to_string())
}
