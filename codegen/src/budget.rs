//! Budgets: how many operations a function may need.
//!
//! In: limits, as `kane.toml` writes them, and functions with their operations. Out: what goes beyond its limit. Does not:
//! decide what follows from that.

use crate::{
    config::{self, Functions},
    description::toml_reader::{Item, Reader, Table, span},
    diagnostic::{Diagnostic, Spanned},
    functions::Parsed,
    program::Operations,
};

/// A limit of one function's operations.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Budget {
    /// The generated function's name.
    pub function: String,
    /// Which operations.
    pub kind: Kind,
    /// How many there may be.
    pub limit: usize,
}

/// Which operations are limited.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// All.
    Total,
    /// Multiplications.
    Mul,
    /// Additions and subtractions.
    Add,
    /// Divisions.
    Div,
    /// Sines and cosines.
    Trig,
}

impl Kind {
    /// All of them, with the names that they have in `kane.toml`.
    pub const ALL: [(&str, Self); 5] = [
        ("total", Self::Total),
        ("mul", Self::Mul),
        ("add", Self::Add),
        ("div", Self::Div),
        ("trig", Self::Trig),
    ];

    /// Their number.
    pub fn of(self, operations: Operations) -> usize {
        match self {
            Self::Total => operations.total(),
            Self::Mul => operations.mul,
            Self::Add => operations.add,
            Self::Div => operations.div,
            Self::Trig => operations.trig,
        }
    }

    /// Its name in `kane.toml`.
    pub fn name(self) -> &'static str {
        let found = Self::ALL.iter().find(|(_, kind)| *kind == self);
        found.expect("budget: every kind has a name").0
    }
}

/// A function that goes beyond its budget.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Excess<'a> {
    /// The limit.
    pub budget: &'a Budget,
    /// How many operations there are.
    pub count: usize,
}

/// What goes beyond its limit, in the order of the budgets. A limit of a function that is not there is kept by it.
pub fn exceeded<'a>(budgets: &'a [Budget], functions: &[(String, Operations)]) -> Vec<Excess<'a>> {
    let excess = |budget: &'a Budget| {
        let mut functions = functions.iter();
        let (_, operations) = functions.find(|(name, _)| *name == budget.function)?;
        let count = budget.kind.of(*operations);
        (count > budget.limit).then_some(Excess { budget, count })
    };
    budgets.iter().filter_map(excess).collect()
}

/// Reads `budget` of a system: for each function a number, of all operations, or a table by kind.
pub(crate) fn read(
    reader: &mut Reader,
    system: &Table<'_, '_>,
    functions: Option<&Functions>,
    known: &[&str],
) -> Vec<Budget> {
    let what = system.what("budget");
    let table = system.get("budget");
    let table = table.and_then(|item| reader.any_table(item, &what));
    let mut budgets = Vec::new();
    for (name, item) in table.iter().flat_map(Table::entries) {
        let name = Spanned::new(name.value.to_owned(), name.span);
        match generated(&name, &what, functions, known) {
            Ok(function) => budgets.extend(limits(reader, &name, item, &what, &function)),
            Err(fault) => reader.faults.push(fault),
        }
    }
    budgets
}

/// The function that is limited, where it is one that is generated.
fn generated(
    name: &Spanned<String>,
    what: &str,
    functions: Option<&Functions>,
    known: &[&str],
) -> Result<String, Diagnostic> {
    if let Some(fault) = config::request_fault(name, what, known) {
        return Err(fault);
    }
    let request = Parsed::read(&name.value).expect("config: a request without fault");
    // Every module has it.
    let is_always = name.value == "q_dot";
    let is_asked_for = |functions: &Functions| {
        let alone = request.alone();
        let mut joined = functions.requests().into_iter();
        alone.is_some_and(|function| functions.names(function))
            || joined.any(|one| one.place() == request.place())
    };
    if is_always || functions.is_none_or(is_asked_for) {
        // Of a frame the model says how it is called; what is asked for says which it is.
        let known = request.of_any_model().map(|request| request.name());
        return Ok(known.unwrap_or_else(|_| request.text()));
    }
    let fault = format!(
        "{what} limits `{}`, which is not among the functions",
        name.value.escape_debug()
    );
    Err(Diagnostic::error(fault)
        .at(name.span, "not generated")
        .help("add it to `functions`, or take its limit away"))
}

fn limits(
    reader: &mut Reader,
    name: &Spanned<String>,
    item: &Item<'_>,
    what: &str,
    function: &str,
) -> Vec<Budget> {
    let what = format!("`{}` of {what}", name.value.escape_debug());
    let limit = |reader: &mut Reader, item: &Item<'_>, what: &str, kind: Kind| {
        let limit = reader.integer(item, what)?;
        let number = usize::try_from(limit.value).ok();
        if number.is_none() {
            let fault = format!("{what} is {}; expected 0 or more", limit.value);
            let fault = Diagnostic::error(fault).at(limit.span, "negative");
            reader.faults.push(fault);
        }
        Some(Budget {
            function: function.to_owned(),
            kind,
            limit: number?,
        })
    };
    if !item.get_ref().is_table() {
        return limit(reader, item, &what, Kind::Total)
            .into_iter()
            .collect();
    }
    let names = Kind::ALL.map(|(name, _)| name);
    let Some(table) = reader.table(item, &what, &names) else {
        return Vec::new();
    };
    if table.entries().next().is_none() {
        let fault = Diagnostic::error(format!("{what} is empty"));
        reader
            .faults
            .push(fault.at(span(item), "expected a limit, such as `total = 500`"));
    }
    let mut limits = Vec::new();
    for (name, kind) in Kind::ALL {
        let item = table.get(name);
        limits.extend(item.and_then(|item| limit(reader, item, &table.what(name), kind)));
    }
    limits
}
