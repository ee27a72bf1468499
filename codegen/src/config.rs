//! `kane.toml`: which systems a repository generates.
//!
//! In: the file. Out: a [`Config`], every fault reported at once otherwise. Afterwards: paths are relative to the
//! file, with `/` between folders, no two systems write one file, and every function named is known.
//! Does not: open the files.

use std::collections::{BTreeMap, BTreeSet};
use std::ffi::OsStr;
use std::path::{Component, Path, PathBuf};

use crate::budget::{self, Budget};
use crate::companions::{self, Abi, Kind};
use crate::compile::SNAP_TOLERANCES;
use crate::description::toml_reader::{Item, Reader, Table, list, span};
use crate::description::{Base, Chart, Reading};
use crate::diagnostic::{Diagnostic, Diagnostics, Source, Spanned, nearest};
use crate::functions::{Function, Parsed, RequestError};
use crate::recursive::Technique;
use crate::tree::Changes;

/// What a `kane.toml` asks for.
#[derive(Clone, Debug, PartialEq)]
pub struct Config {
    /// The systems, in the order of the file.
    pub systems: Vec<System>,
}

/// One system to generate.
#[derive(Clone, Debug, PartialEq)]
pub struct System {
    /// The description's path, relative to `kane.toml`.
    pub model: Spanned<String>,
    /// The generated file's path, relative to `kane.toml`.
    pub output: String,
    /// How the model is read.
    pub reading: Reading,
    /// What is changed of it.
    pub changes: Changes,
    /// What to generate.
    pub functions: Functions,
    /// From which formulation.
    pub formulation: Formulation,
    /// Whether functions use fused multiply-add.
    pub fma: bool,
    /// The techniques to leave out.
    pub without: BTreeSet<Technique>,
    /// What is written beside the module.
    pub companions: BTreeSet<Kind>,
    /// How many operations its functions may need.
    pub budget: Vec<Budget>,
}

/// The functions to generate.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum Functions {
    /// The default set.
    #[default]
    Default,
    /// All there are.
    All,
    /// These, in the order written.
    Named(Vec<String>),
}

impl Functions {
    /// Those that are named, in the order in which a module holds them, each once; names that are none are left out.
    pub fn requests(&self) -> Vec<Parsed> {
        let names: &[String] = match self {
            Self::Default | Self::All => &[],
            Self::Named(names) => names,
        };
        let requests = names.iter().filter_map(|name| Parsed::read(name).ok());
        let mut requests: Vec<Parsed> = requests.collect();
        requests.sort_by_key(Parsed::place);
        requests.dedup_by_key(|request| request.place());
        requests
    }

    /// True where the function is among them.
    pub fn names(&self, function: &Function) -> bool {
        match self {
            Self::Default => function.is_default,
            Self::All => true,
            Self::Named(names) => names.iter().any(|name| {
                let named = Parsed::read(name).ok();
                let named = named.and_then(|named| named.alone());
                named.is_some_and(|named| named.name == function.name)
            }),
        }
    }
}

/// Which of the equations' forms to generate.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Formulation {
    /// For each function whichever needs fewer operations.
    #[default]
    Cheapest,
    /// The notes' equations as they stand.
    Notes,
    /// Sums over bodies re-associated along the tree.
    Recursive,
}

impl Formulation {
    /// All of them, with the names that they have in `kane.toml`.
    pub const ALL: [(&str, Self); 3] = [
        ("cheapest", Self::Cheapest),
        ("notes", Self::Notes),
        ("recursive", Self::Recursive),
    ];
}

const SYSTEM_KEYS: [&str; 15] = [
    "model",
    "output",
    "manifest",
    "tests",
    "abi",
    "functions",
    "formulation",
    "fma",
    "without",
    "budget",
    "base",
    "chart",
    "snap",
    "lock",
    "remove",
];

/// Reads a `kane.toml`; `known` are the names of the functions that can be generated.
///
/// ```
/// use kane_codegen::config::{self, Functions};
/// use kane_codegen::diagnostic::Source;
///
/// let text = "[[system]]\nmodel = \"models/arm.toml\"\noutput = \"generated/arm.rs\"\nfunctions = [\"bias\"]\n";
/// let config = config::parse(&Source::new("kane.toml", text), &["mass_matrix", "bias"]).unwrap();
/// assert_eq!(config.systems[0].functions, Functions::Named(vec!["bias".to_owned()]));
/// ```
///
/// # Errors
/// Everything that is wrong with the file.
pub fn parse(source: &Source, known: &[&str]) -> Result<Config, Diagnostics> {
    let mut reader = Reader::default();
    let document = reader.document(source);
    let mut systems = Vec::new();
    if !(document.is_empty() && reader.has_faults()) {
        let root = reader.root(&document, &["system"]);
        let item = reader.required(&root, "system", "[[system]]");
        let items = item.and_then(|item| reader.list(item, "`system`", "tables, `[[system]]`"));
        let items = items.unwrap_or_default().into_iter().enumerate();
        systems
            .extend(items.filter_map(|(index, item)| system(&mut reader, item, index + 1, known)));
        check_outputs(&mut reader, &systems);
    }
    if reader.has_faults() {
        return Err(Diagnostics::new(source.clone(), reader.faults.into_told()));
    }
    Ok(Config {
        systems: systems
            .into_iter()
            .filter_map(Written::into_system)
            .collect(),
    })
}

/// A system of which some values may be faulty.
struct Written {
    model: Option<Spanned<String>>,
    output: Option<Spanned<String>>,
    reading: Reading,
    changes: Changes,
    functions: Option<Functions>,
    formulation: Option<Formulation>,
    fma: bool,
    without: BTreeSet<Technique>,
    companions: BTreeSet<Kind>,
    budget: Vec<Budget>,
}

impl Written {
    fn into_system(self) -> Option<System> {
        Some(System {
            model: self.model?,
            output: self.output?.value,
            reading: self.reading,
            changes: self.changes,
            functions: self.functions?,
            formulation: self.formulation?,
            fma: self.fma,
            without: self.without,
            companions: self.companions,
            budget: self.budget,
        })
    }
}

fn system(reader: &mut Reader, item: &Item<'_>, number: usize, known: &[&str]) -> Option<Written> {
    let table = reader.table(item, &format!("system {number}"), &SYSTEM_KEYS)?;
    let model = reader.required(&table, "model", "model = \"models/pendulum.toml\"");
    let model = model.and_then(|item| path(reader, item, &table.what("model")));
    let output = reader.required(&table, "output", "output = \"generated/pendulum.rs\"");
    let output = output.and_then(|item| path(reader, item, &table.what("output")));
    if let Some(output) = output
        .as_ref()
        .filter(|output| Path::new(&output.value).extension() != Some(OsStr::new("rs")))
    {
        let fault = format!(
            "{} is `{}`; expected a file that ends in `.rs`",
            table.what("output"),
            output.value
        );
        reader
            .faults
            .push(Diagnostic::error(fault).at(output.span, "no Rust file"));
    }
    let companions = companions(reader, &table);
    if let Some(output) = &output {
        check_name(reader, output, &companions, &table.what("output"));
    }
    let functions = functions(reader, &table, known);
    Some(Written {
        budget: budget::read(reader, &table, functions.as_ref(), known),
        model,
        output,
        reading: reading(reader, &table),
        changes: changes(reader, &table),
        functions,
        formulation: formulation(reader, &table),
        fma: truth(reader, &table, "fma"),
        without: without(reader, &table),
        companions,
    })
}

/// False where the key is absent.
fn truth(reader: &mut Reader, system: &Table<'_, '_>, key: &str) -> bool {
    let item = system.get(key);
    let value = item.and_then(|item| reader.truth(item, &system.what(key)));
    value.unwrap_or_default()
}

fn companions(reader: &mut Reader, system: &Table<'_, '_>) -> BTreeSet<Kind> {
    let mut companions = BTreeSet::new();
    for (key, kind) in [("manifest", Kind::Manifest), ("tests", Kind::Tests)] {
        if truth(reader, system, key) {
            companions.insert(kind);
        }
    }
    let abi = system.get("abi");
    let abi =
        abi.and_then(|item| reader.choice(item, &system.what("abi"), &Abi::ALL, "unknown ABI"));
    let abi = abi.map(|abi| Kind::Abi(abi.value));
    companions.extend(abi);
    companions
}

/// Refuses a module whose name cannot stand where what is beside it needs it.
fn check_name(
    reader: &mut Reader,
    output: &Spanned<String>,
    companions: &BTreeSet<Kind>,
    what: &str,
) {
    let name = Path::new(&output.value).file_stem().unwrap_or_default();
    let name = name.to_string_lossy();
    if !companions::can_be_beside(companions, &name) {
        let fault = Diagnostic::error(format!(
            "{what} is `{}`; names in C begin with the module's",
            output.value
        ));
        reader.faults.push(
            fault
                .at(output.span, "no name that C and Rust can have")
                .help(companions::EXPECTED_NAME),
        );
    }
}

/// A path that means the same on every machine: relative, and written with `/`.
fn path(reader: &mut Reader, item: &Item<'_>, what: &str) -> Option<Spanned<String>> {
    let path = reader.string(item, what)?;
    let fault = if path.value.is_empty() {
        Some((format!("{what} is empty"), "expected a path"))
    } else if path.value.chars().any(char::is_control) {
        Some((
            format!("{what} holds a character that cannot be shown"),
            "expected printable characters",
        ))
    } else if path.value.contains('\\') {
        Some((
            format!("{what} holds a backslash; expected `/` between folders"),
            "backslash",
        ))
    } else if path.value.starts_with('/') || path.value.chars().nth(1) == Some(':') {
        Some((
            format!("{what} is an absolute path; expected one relative to this file"),
            "absolute path",
        ))
    } else {
        None
    };
    match fault {
        Some((fault, label)) => {
            reader
                .faults
                .push(Diagnostic::error(fault).at(path.span, label));
            None
        }
        None => Some(path),
    }
}

fn functions(reader: &mut Reader, system: &Table<'_, '_>, known: &[&str]) -> Option<Functions> {
    let Some(item) = system.get("functions") else {
        return Some(Functions::Default);
    };
    let what = system.what("functions");
    let entries = reader.list(item, &what, "names")?;
    if entries.is_empty() {
        let fault = Diagnostic::error(format!("{what} is empty"))
            .at(span(item), "expected names, or \"all\"");
        reader
            .faults
            .push(fault.help("leave `functions` out for the default set"));
        return None;
    }
    let mut names: Vec<Spanned<String>> = Vec::new();
    for (index, entry) in entries.iter().enumerate() {
        let Some(name) = reader.string(entry, &format!("entry {} of {what}", index + 1)) else {
            continue;
        };
        let all = name.value == "all";
        if let Some(fault) = (!all).then(|| request_fault(&name, &what, known)).flatten() {
            reader.faults.push(fault);
        } else if let Some(first) = names.iter().find(|first| first.value == name.value) {
            let fault = Diagnostic::error(format!("{what} names `{}` twice", name.value));
            reader.faults.push(
                fault
                    .at(name.span, "the second one")
                    .at(first.span, "the first one"),
            );
        } else {
            names.push(name);
        }
    }
    let all = names.iter().find(|name| name.value == "all");
    match all {
        Some(_) if entries.len() == 1 => Some(Functions::All),
        Some(all) => {
            let fault = Diagnostic::error(format!("{what} names functions beside `all`"));
            reader
                .faults
                .push(fault.at(all.span, "this names them all"));
            None
        }
        None => Some(Functions::Named(
            names.into_iter().map(|name| name.value).collect(),
        )),
    }
}

/// What is wrong with the name of a function in a list or table.
pub(crate) fn request_fault(
    name: &Spanned<String>,
    what: &str,
    known: &[&str],
) -> Option<Diagnostic> {
    let among = |part: &str| known.contains(&part);
    let fault = match Parsed::read(&name.value) {
        Ok(request) => {
            let mut parts = request.functions().map(|part| part.name);
            let name = parts.find(|part| !among(part))?.to_owned();
            RequestError::Unknown { name }
        }
        Err(fault) => fault,
    };
    let RequestError::Unknown { name: part } = fault else {
        return Some(part_fault(name, what, &fault));
    };
    let whole = if part == name.value {
        String::new()
    } else {
        format!(" in `{}`", name.value.escape_debug())
    };
    let fault = Diagnostic::error(format!(
        "{what} names `{}`{whole}, which is no function",
        part.escape_debug()
    ));
    let help = match nearest(&part, known) {
        Some(near) => format!("did you mean `{near}`?"),
        None => format!("the functions are {}", list(known)),
    };
    Some(fault.at(name.span, "unknown function").help(help))
}

/// What is wrong with a request of known functions, with its place in the text where that stands there as it is.
fn part_fault(name: &Spanned<String>, what: &str, fault: &RequestError) -> Diagnostic {
    let shown = Diagnostic::error(format!("{what}: {fault}"));
    let Some(place) = fault.place() else {
        return shown.at(name.span, "cannot be joined");
    };
    // Between two quotes of one character each, and nothing escaped.
    let is_plain = name.span.end - name.span.start == name.value.len() + 2;
    let start = name.span.start + 1;
    let span = if is_plain {
        (start + place.start..start + place.end.max(place.start + 1)).into()
    } else {
        name.span
    };
    shown.at(span, "here")
}

fn formulation(reader: &mut Reader, system: &Table<'_, '_>) -> Option<Formulation> {
    let Some(item) = system.get("formulation") else {
        return Some(Formulation::default());
    };
    let what = system.what("formulation");
    let found = reader.choice(item, &what, &Formulation::ALL, "unknown formulation");
    found.map(|found| found.value)
}

fn without(reader: &mut Reader, system: &Table<'_, '_>) -> BTreeSet<Technique> {
    let what = system.what("without");
    let item = system.get("without");
    let entries = item.and_then(|item| reader.list(item, &what, "names"));
    let entries = entries.unwrap_or_default().into_iter().enumerate();
    let names = entries.filter_map(|(index, entry)| {
        let what = format!("entry {} of {what}", index + 1);
        reader.choice(entry, &what, &Technique::ALL, "unknown technique")
    });
    names.map(|technique| technique.value).collect()
}

fn reading(reader: &mut Reader, system: &Table<'_, '_>) -> Reading {
    let base = system.get("base");
    let base = base
        .and_then(|item| reader.choice(item, &system.what("base"), &Base::NAMED, "unknown base"));
    let chart = system.get("chart");
    let chart = chart.and_then(|item| {
        reader.choice(item, &system.what("chart"), &Chart::NAMED, "unknown chart")
    });
    Reading {
        base: base.map(|base| base.value),
        chart: chart.map(|chart| chart.value),
    }
}

fn changes(reader: &mut Reader, system: &Table<'_, '_>) -> Changes {
    let mut changes = Changes::default();
    let snap = system.get("snap");
    if let Some(snap) = snap.and_then(|item| reader.number(item, &system.what("snap"))) {
        if SNAP_TOLERANCES.contains(&snap.value) {
            changes.snap = snap.value;
        } else {
            let fault = format!(
                "{} is {:?}; expected at least {} and less than {}",
                system.what("snap"),
                snap.value,
                SNAP_TOLERANCES.start,
                SNAP_TOLERANCES.end
            );
            reader
                .faults
                .push(Diagnostic::error(fault).at(snap.span, "no tolerance"));
        }
    }
    if let Some(item) = system.get("lock") {
        let table = reader.any_table(item, &system.what("lock"));
        for (name, item) in table.iter().flat_map(Table::entries) {
            let what = system.what("lock");
            let what = format!("`{}` of {what}", name.value.escape_debug());
            let value = reader.number(item, &what);
            changes
                .lock
                .extend(value.map(|value| (name.value.to_owned(), value.value)));
        }
        changes.lock.sort_by(|(one, _), (other, _)| one.cmp(other));
    }
    if let Some(item) = system.get("remove") {
        changes.remove = names(reader, item, &system.what("remove"));
    }
    changes
}

/// Names, none of them twice.
fn names(reader: &mut Reader, item: &Item<'_>, what: &str) -> Vec<String> {
    let mut names: Vec<Spanned<String>> = Vec::new();
    let entries = reader.list(item, what, "names").unwrap_or_default();
    for (index, entry) in entries.into_iter().enumerate() {
        let Some(name) = reader.string(entry, &format!("entry {} of {what}", index + 1)) else {
            continue;
        };
        if let Some(first) = names.iter().find(|first| first.value == name.value) {
            let fault = format!("{what} names `{}` twice", name.value.escape_debug());
            reader.faults.push(
                Diagnostic::error(fault)
                    .at(name.span, "the second one")
                    .at(first.span, "the first one"),
            );
        } else {
            names.push(name);
        }
    }
    names.into_iter().map(|name| name.value).collect()
}

/// Two systems that write one file would each undo the other.
fn check_outputs(reader: &mut Reader, systems: &[Written]) {
    let mut first: BTreeMap<PathBuf, &Spanned<String>> = BTreeMap::new();
    for system in systems {
        let Some(output) = &system.output else {
            continue;
        };
        let files = files(&output.value, &system.companions);
        let known = |file: &PathBuf| Some((file.clone(), *first.get(&places(file))?));
        if let Some((file, first)) = files.iter().find_map(known) {
            let fault = Diagnostic::error(format!("two systems write `{}`", file.display()));
            reader.faults.push(
                fault
                    .at(output.span, "the second one")
                    .at(first.span, "the first one"),
            );
        }
        first.extend(files.iter().map(|file| (places(file), output)));
    }
}

/// The module and what is beside it.
fn files(output: &str, companions: &BTreeSet<Kind>) -> Vec<PathBuf> {
    let module = Path::new(output);
    let beside = companions.iter().flat_map(|kind| kind.beside(module));
    std::iter::once(module.to_owned()).chain(beside).collect()
}

/// The path, where `./` and `folder/../` make no difference.
fn places(path: &Path) -> PathBuf {
    let mut places = PathBuf::new();
    for part in path.components() {
        let is_below = || {
            places
                .components()
                .next_back()
                .is_some_and(|last| last != Component::ParentDir)
        };
        match part {
            Component::CurDir => {}
            Component::ParentDir if is_below() => {
                places.pop();
            }
            part => places.push(part),
        }
    }
    places
}
