//! How a `kane.toml` says a model is read, and what it changes of it.

use crate::{
    description::{
        Base, Chart, Reading,
        toml_reader::{Reader, Table, span},
    },
    diagnostic::{Diagnostic, Escaped, Spanned},
    options::SNAP_TOLERANCES,
    tree::Changes,
};

/// What a URDF or MJCF leaves to the user.
pub(super) fn reading(reader: &mut Reader, system: &Table<'_, '_>) -> Reading {
    let base = chosen(reader, system, Reading::BASE, &Base::NAMED);
    let chart = chosen(reader, system, Reading::CHART, &Chart::NAMED);
    let left_out = names(reader, system, Reading::LEAVE_OUT).into_iter();
    Reading {
        base,
        chart,
        leave_out: left_out.map(|name| name.value).collect(),
    }
}

/// One of these, where the key is there.
fn chosen<T: Copy>(
    reader: &mut Reader,
    system: &Table<'_, '_>,
    key: &str,
    named: &[(&str, T)],
) -> Option<T> {
    let unknown = format!("unknown {key}");
    let chosen = reader.choice(system.get(key)?, &system.what(key), named, &unknown);
    chosen.map(|chosen| chosen.value)
}

/// The names of what is changed, and what is said of the reading, where they stand, each with its key.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Changed {
    entries: Vec<(&'static str, Spanned<String>)>,
}

impl Changed {
    /// Those that are left where this list is given elsewhere.
    pub fn forget(&mut self, list: &str) {
        self.entries.retain(|(own, _)| *own != list);
    }

    /// What is wrong with one of them on a model, at its place; `None` where it is about none of them.
    pub fn fault(&self, fault: &Diagnostic) -> Option<Diagnostic> {
        let asked = fault.entry.as_ref()?;
        let mut entries = self.entries.iter();
        let (_, name) =
            entries.find(|(list, name)| *list == asked.list && name.value == asked.name)?;
        let label = if asked.name.is_empty() {
            "said here"
        } else {
            "named here"
        };
        Some(fault.clone().at(name.span, label))
    }
}

/// What is changed of the model, and where that stands.
pub(super) fn changes(reader: &mut Reader, system: &Table<'_, '_>) -> (Changes, Changed) {
    let before = Changes::default();
    let removed = names(reader, system, Changes::REMOVE);
    let locked = lock(reader, system);
    let entries = locked.iter().map(|(name, _)| (Changes::LOCK, name.clone()));
    let entries = entries.chain(removed.iter().map(|name| (Changes::REMOVE, name.clone())));
    // Of what is said of the reading, only where it stands.
    let said = [Reading::BASE, Reading::CHART, Reading::LEAVE_OUT].into_iter();
    let said =
        said.filter_map(|key| Some((key, Spanned::new(String::new(), span(system.get(key)?)))));
    let entries = entries.chain(said);
    let changed = Changed {
        entries: entries.collect(),
    };
    let massless = system.get("remove_massless");
    let massless = massless.and_then(|item| reader.truth(item, &system.what("remove_massless")));
    let locked = locked.into_iter();
    let changes = Changes {
        snap: snap(reader, system).unwrap_or(before.snap),
        lock: locked.map(|(name, value)| (name.value, value)).collect(),
        remove: removed.into_iter().map(|name| name.value).collect(),
        remove_massless: massless.unwrap_or_default(),
    };
    (changes, changed)
}

fn snap(reader: &mut Reader, system: &Table<'_, '_>) -> Option<f64> {
    let what = system.what("snap");
    let snap = reader.number(system.get("snap")?, &what)?;
    if SNAP_TOLERANCES.contains(&snap.value) {
        return Some(snap.value);
    }
    let fault = format!(
        "{what} is {:?}; expected at least {} and less than {}",
        snap.value, SNAP_TOLERANCES.start, SNAP_TOLERANCES.end
    );
    let fault = Diagnostic::error(fault);
    reader.faults.push(fault.at(snap.span, "no tolerance"));
    None
}

/// In the order of the names.
fn lock(reader: &mut Reader, system: &Table<'_, '_>) -> Vec<(Spanned<String>, f64)> {
    let what = system.what(Changes::LOCK);
    let table = system.get(Changes::LOCK);
    let table = table.and_then(|item| {
        if item.get_ref().is_table() {
            return reader.any_table(item, &what);
        }
        reader.wrong_type(item, &what, "a table such as `{ elbow = 0.5 }`");
        None
    });
    let entries = table.iter().flat_map(Table::entries);
    let locked = entries.filter_map(|(name, item)| {
        let what = format!("`{}` of {what}", name.value.escaped());
        let value = reader.number(item, &what)?;
        Some((Spanned::new(name.value.to_owned(), name.span), value.value))
    });
    let mut locked: Vec<_> = locked.collect();
    locked.sort_by(|(one, _), (other, _)| one.value.cmp(&other.value));
    locked
}

/// Names, none of them twice.
pub(super) fn names(
    reader: &mut Reader,
    system: &Table<'_, '_>,
    key: &str,
) -> Vec<Spanned<String>> {
    let Some(item) = system.get(key) else {
        return Vec::new();
    };
    let what = system.what(key);
    let mut names: Vec<Spanned<String>> = Vec::new();
    let entries = reader.list(item, &what, "names").unwrap_or_default();
    for (index, entry) in entries.into_iter().enumerate() {
        let Some(name) = reader.string(entry, &format!("entry {} of {what}", index + 1)) else {
            continue;
        };
        if let Some(first) = names.iter().find(|first| first.value == name.value) {
            let fault = format!("{what} names `{}` twice", name.value.escaped());
            reader.faults.push(
                Diagnostic::error(fault)
                    .at(name.span, "the second one")
                    .at(first.span, "the first one"),
            );
        } else {
            names.push(name);
        }
    }
    names
}
