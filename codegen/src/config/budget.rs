//! Budgets, as a `kane.toml` writes them: limits of functions that are generated.

use crate::{
    budget::{Budget, OperationKind},
    description::toml_reader::{Item, Reader, Table, span},
    diagnostic::{Diagnostic, Escaped, Spanned},
    functions::Parsed,
    options::Functions,
};

use super::functions::request_faults;

/// Reads `budget` of a system: for each function a number, of all operations, or a table by kind.
pub(super) fn read(
    reader: &mut Reader,
    system: &Table<'_, '_>,
    functions: Option<&Functions>,
) -> Vec<Budget> {
    let what = system.what("budget");
    let table = system.get("budget");
    let table = table.and_then(|item| reader.any_table(item, &what));
    let mut budgets = Vec::new();
    for (name, item) in table.iter().flat_map(Table::entries) {
        let name = Spanned::new(name.value.to_owned(), name.span);
        match generated(&name, &what, functions) {
            Ok(function) => budgets.extend(limits(reader, &name, item, &what, &function)),
            Err(faults) => reader.faults.extend(faults),
        }
    }
    budgets
}

/// The function that is limited, where it is one that is generated.
fn generated(
    name: &Spanned<String>,
    what: &str,
    functions: Option<&Functions>,
) -> Result<String, Vec<Diagnostic>> {
    let requests = functions.map_or_else(Vec::new, Functions::requests);
    let mut given = requests.iter().filter_map(Parsed::given_name);
    if given.any(|own| own == name.value) {
        return Ok(name.value.clone());
    }
    let faults = request_faults(name, what);
    if !faults.is_empty() {
        return Err(faults);
    }
    let request = Parsed::read(&name.value).expect("config: a request without fault");
    let function = request.catalogue_function();
    let is_always = function.is_some_and(|function| function.is_always_generated(false));
    let is_asked_for = |functions: &Functions| {
        let mut joined = functions.requests().into_iter();
        function.is_some_and(|function| functions.names(function))
            || joined.any(|one| one.place() == request.place())
    };
    if is_always || functions.is_none_or(is_asked_for) {
        // Of a frame the model says how it is called; what is asked for says which it is.
        let known = request.of_any_model().map(|request| request.name());
        return Ok(known.unwrap_or_else(|_| request.text()));
    }
    let fault = format!(
        "{what} limits `{}`, which is not among the functions",
        name.value.escaped()
    );
    let fault = Diagnostic::error(fault).at(name.span, "not generated");
    let mut alike = requests.iter().filter(|one| one.sum() == request.sum());
    let called = alike.find_map(Parsed::given_name);
    let mut reordered = requests.iter().filter(|one| one.has_the_parts_of(&request));
    let help = match (called, reordered.next()) {
        (Some(called), _) => format!("it is called `{called}` there"),
        (None, Some(other)) => {
            let called = other
                .given_name()
                .map_or_else(|| other.sum(), str::to_owned);
            format!("did you mean `{called}`?")
        }
        (None, None) => "add it to `functions`, or take its limit away".to_owned(),
    };
    Err(vec![fault.help(help)])
}

fn limits(
    reader: &mut Reader,
    name: &Spanned<String>,
    item: &Item<'_>,
    what: &str,
    function: &str,
) -> Vec<Budget> {
    let what = format!("`{}` of {what}", name.value.escaped());
    let limit = |reader: &mut Reader, item: &Item<'_>, what: &str, kind: OperationKind| {
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
        return limit(reader, item, &what, OperationKind::Total)
            .into_iter()
            .collect();
    }
    let names = OperationKind::ALL.map(|(name, _)| name);
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
    for (name, kind) in OperationKind::ALL {
        let item = table.get(name);
        limits.extend(item.and_then(|item| limit(reader, item, &table.what(name), kind)));
    }
    limits
}
