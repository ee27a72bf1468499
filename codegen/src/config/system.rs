//! One `[[system]]` of a `kane.toml`.

use std::collections::BTreeSet;

use crate::{
    budget::Budget,
    description::toml_reader::{Item, Reader, Table},
    diagnostic::Spanned,
    options::{
        Formulation, Functions, Options,
        companion::{Abi, CompanionKind},
    },
    recursive::Technique,
    tree::Changes,
};

use super::{
    budget,
    changes::{self, Changed},
    functions::{self, Named},
    outputs::{self, Output},
    path,
    prescribed::{self, Prescribed},
};

/// One system to generate.
#[derive(Clone, Debug, PartialEq)]
pub struct System {
    /// The description's path, relative to `kane.toml`.
    pub model: Spanned<String>,
    /// The generated file's path, relative to `kane.toml`.
    pub output: Spanned<String>,
    /// What is generated, and how.
    pub options: Options,
    /// The functions that it names, where they stand: what is wrong with one may follow from the model.
    pub named: Named,
    /// The joints that it prescribes, where they stand: what is wrong with one follows from the model.
    pub prescribed: Prescribed,
    /// The joints that it locks and removes, where they stand: what is wrong with one follows from the model.
    pub changed: Changed,
    /// How many operations its functions may need.
    pub budget: Vec<Budget>,
}

const KEYS: [&str; 18] = [
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
    "leave_out",
    "snap",
    "lock",
    "remove",
    "remove_massless",
    "prescribed",
];

/// What could be read of a system.
#[derive(Default)]
pub(super) struct Read {
    /// Its model.
    pub(super) model: Option<String>,
    /// All of it, where nothing of it has a fault that leaves it unknown.
    pub(super) system: Option<System>,
    /// What it writes.
    pub(super) output: Option<Output>,
}

/// Reads a system, as far as it has no fault.
pub(super) fn read(reader: &mut Reader, item: &Item<'_>, number: usize) -> Read {
    let Some(table) = reader.table(item, &format!("system {number}"), &KEYS) else {
        return Read::default();
    };
    let model = reader.required(&table, "model", "model = \"models/pendulum.toml\"");
    let model = model.and_then(|item| path::read(reader, item, &table.what("model")));
    let output = outputs::module(reader, &table);
    let companions = companions(reader, &table);
    let output = output.map(|module| Output::new(reader, &table, module, &companions));
    let functions = functions::read(reader, &table);
    let (functions, named) = functions.unzip();
    let budget = budget::read(reader, &table, functions.as_ref());
    let prescribed = prescribed::read(reader, &table);
    let (changes, changed) = changes::changes(reader, &table);
    let options = options(
        reader,
        &table,
        functions,
        changes,
        &prescribed,
        companions,
        output.as_ref(),
    );
    let known = model.as_ref().map(|model| model.value.clone());
    let system = || {
        Some(System {
            model: model?,
            output: output.as_ref()?.module.clone(),
            options: options?,
            named: named?,
            prescribed,
            changed,
            budget,
        })
    };
    Read {
        model: known,
        system: system(),
        output,
    }
}

/// Reads the options, as far as none has a fault.
fn options(
    reader: &mut Reader,
    system: &Table<'_, '_>,
    functions: Option<Functions>,
    changes: Changes,
    prescribed: &Prescribed,
    companions: BTreeSet<CompanionKind>,
    output: Option<&Output>,
) -> Option<Options> {
    let reading = changes::reading(reader, system);
    let formulation = formulation(reader, system);
    let fma = truth(reader, system, "fma");
    let without = without(reader, system);
    Some(Options {
        reading,
        changes,
        prescribed: prescribed.names(),
        functions: functions?,
        formulation: formulation?,
        fma,
        without,
        companions,
        module: output?.name.clone(),
    })
}

/// False where the key is absent.
fn truth(reader: &mut Reader, system: &Table<'_, '_>, key: &str) -> bool {
    let item = system.get(key);
    let value = item.and_then(|item| reader.truth(item, &system.what(key)));
    value.unwrap_or_default()
}

fn companions(reader: &mut Reader, system: &Table<'_, '_>) -> BTreeSet<CompanionKind> {
    let mut companions = BTreeSet::new();
    for (key, kind) in CompanionKind::SWITCHED {
        if truth(reader, system, key) {
            companions.insert(kind);
        }
    }
    let abi = system.get("abi");
    let what = system.what("abi");
    let help = Some("the header for C serves C++ too");
    let abi =
        abi.and_then(|item| reader.choice_or_help(item, &what, &Abi::ALL, "unknown ABI", help));
    let abi = abi.map(|abi| CompanionKind::Abi(abi.value));
    companions.extend(abi);
    companions
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
