//! The page of other tools' names, and what the command says about the same names.

use kane_codegen::functions::{Function, Parsed, elsewhere};

use crate::page::repository;

/// The rows of the first table, each with the code of each cell.
fn rows() -> Vec<Vec<Vec<String>>> {
    let page = std::fs::read_to_string(repository("docs/dictionary.md")).unwrap();
    let table = page.lines().skip_while(|line| *line != "## Functions");
    let table = table.skip_while(|line| !line.starts_with('|'));
    let table = table.take_while(|line| line.starts_with('|')).skip(2);
    table
        .map(|row| {
            let cells = row.trim_matches('|').split('|');
            cells.map(code).collect()
        })
        .collect()
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
    for request in rows.iter().flat_map(|cells| &cells[0]) {
        Parsed::read(request).unwrap_or_else(|_| panic!("{request} is no request"));
        let function = request.split(['(', ')']).find(|part| part.len() > 1);
        assert!(
            Function::names().contains(&function.unwrap()),
            "{request} is of no function"
        );
    }
}

#[test]
fn the_command_says_the_same_of_a_name() {
    let mut known = 0;
    for cells in rows() {
        // With the type of an argument behind it a name has another meaning.
        for name in cells[1..].iter().filter_map(|names| names.first()) {
            if let Some(request) = elsewhere(name) {
                let ours: Vec<String> = cells[0]
                    .iter()
                    .map(|own| own.replace("(F)", "(FRAME)"))
                    .map(|own| own.replace("(F, local)", "(FRAME)"))
                    .collect();
                assert!(ours.iter().any(|own| own == request), "{name}: {request}");
                known += 1;
            }
        }
    }
    assert!(known > 15, "the command knows {known} of the names");
}
