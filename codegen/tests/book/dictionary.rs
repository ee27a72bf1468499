//! The page of other tools' names, and what the command says about the same names.

use std::collections::BTreeSet;

use kane_codegen::functions::{Function, Parsed, elsewhere};

use crate::page::repository;

fn page() -> String {
    std::fs::read_to_string(repository("docs/dictionary.md")).unwrap()
}

/// The rows of the first table after the line that begins so.
fn table<'a>(page: &'a str, title: &str) -> impl Iterator<Item = &'a str> {
    let lines = page
        .lines()
        .skip_while(move |line| !line.starts_with(title));
    let table = lines.skip_while(|line| !line.starts_with('|'));
    let rows = table.take_while(|line| line.starts_with('|')).skip(2);
    rows.map(|row| row.trim_matches(['|', ' ']))
}

/// The rows of the first table, each with the code of each cell.
fn rows() -> Vec<Vec<Vec<String>>> {
    let page = page();
    let rows = table(&page, "## Functions");
    rows.map(|row| row.split('|').map(code).collect()).collect()
}

/// What stands between backticks.
fn code(cell: &str) -> Vec<String> {
    let parts = cell.split('`').skip(1).step_by(2);
    parts.map(str::to_owned).collect()
}

#[test]
fn our_names_are_requests() {
    let rows = rows();
    assert!(rows.len() > 20, "{rows:?}");
    let requests = rows.iter().flat_map(|cells| &cells[0]);
    let is_argument = |request: &&String| ["u", "q_direction"].contains(&request.as_str());
    for request in requests.filter(|request| !is_argument(request)) {
        Parsed::read(request).unwrap_or_else(|_| panic!("{request} is no request"));
        let mut words = request.split(['(', ')', ';']);
        assert!(
            words.any(|word| Function::names().contains(&word)),
            "{request} is of no function"
        );
    }
}

/// The names of a cell that stand alone: what has words beside it means another thing.
fn alone(cell: &str) -> Vec<String> {
    let items = cell.split([',', ';']).map(str::trim);
    let names = items.filter_map(|item| item.strip_prefix('`')?.strip_suffix('`'));
    let is_name = |name: &&str| {
        let is_constant = name
            .chars()
            .all(|letter| letter.is_uppercase() || letter == '_');
        !is_constant && !name.contains([' ', '`', '('])
    };
    names.filter(is_name).map(str::to_owned).collect()
}

#[test]
fn the_command_knows_every_name_of_the_tables() {
    let page = page();
    let rows: Vec<(Vec<String>, Vec<String>)> = ["## Functions", "Drake's"]
        .into_iter()
        .flat_map(|title| table(&page, title))
        .map(|row| {
            let (own, others) = row.split_once(" | ").unwrap();
            let own = code(own)
                .iter()
                .map(|own| own.replace("(F)", "(FRAME)"))
                .collect();
            (own, others.split(" | ").flat_map(alone).collect())
        })
        .collect();
    assert!(rows.iter().map(|(_, names)| names.len()).sum::<usize>() > 60);
    let names = rows.iter().flat_map(|(_, names)| names);
    let is_told = |name: &&String| {
        let Some(request) = elsewhere(name) else {
            return false;
        };
        let mut same = rows.iter().filter(|(_, names)| names.contains(name));
        same.any(|(own, _)| own.iter().any(|own| own == request))
    };
    let others: Vec<_> = names.filter(|name| !is_told(name)).collect();
    assert!(others.is_empty(), "{others:?}");
}

#[test]
fn the_page_of_functions_has_every_function_and_the_default_set() {
    let page = std::fs::read_to_string(repository("docs/functions.md")).unwrap();
    let is_there =
        |name: &str| page.contains(&format!("`{name}`")) || page.contains(&format!("`{name}("));
    let with_dot = |name: &str| name.strip_suffix("_dot").is_some_and(is_there);
    let names = Function::names().into_iter();
    let lacking: Vec<&str> = names
        .filter(|name| !is_there(name) && !with_dot(name))
        .collect();
    assert!(lacking.is_empty(), "{lacking:?}");
    let table = table(&page, "The default set");
    let told: BTreeSet<String> = table
        .flat_map(|row| code(row.split('|').next().unwrap()))
        .collect();
    let set = Function::all()
        .filter(|own| own.is_default)
        .map(|own| own.name.to_owned());
    assert_eq!(told, set.collect());
}
