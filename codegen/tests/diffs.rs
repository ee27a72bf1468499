//! Changes of a model show in its generated code where they matter and nowhere else.

#![expect(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use std::{collections::BTreeSet, fs};

use kane_codegen::{
    compile::Options,
    config::{Formulation, Functions},
    diagnostic::Source,
    generate::generate,
};
use similar::{ChangeTag, TextDiff};

const BODIES: [&str; 8] = [
    "hub",
    "shoulder",
    "forearm",
    "left_panel",
    "left_tip",
    "antenna",
    "boom",
    "camera",
];

fn model() -> String {
    let path = format!("{}/../models/eight_body.toml", env!("CARGO_MANIFEST_DIR"));
    fs::read_to_string(path)
        .unwrap()
        .replace("order = \"notes\"", "order = \"body\"")
}

fn module(text: &str, formulation: Formulation) -> String {
    let options = Options {
        functions: Functions::All,
        formulation,
    };
    generate(
        &Source::new("eight_body.toml", text),
        "models/eight_body.toml",
        &options,
    )
    .unwrap()
    .source
}

/// The text with every statement on one line, however it was broken.
fn statements(text: &str) -> Vec<String> {
    let mut statements = Vec::new();
    let mut current = String::new();
    for line in text.lines().map(str::trim) {
        if !current.is_empty() {
            current.push(' ');
        }
        current.push_str(line);
        let ends = [";", "{", "}", ""]
            .iter()
            .any(|end| line.ends_with(end) && (!end.is_empty() || line.is_empty()));
        if ends || line.starts_with("//") || line.starts_with('#') {
            statements.push(std::mem::take(&mut current));
        }
    }
    statements
}

/// The statements that stand in one text alone, with a mark for which.
fn changes(old: &str, new: &str) -> Vec<(ChangeTag, String)> {
    let (old, new) = (statements(old), statements(new));
    let (old, new): (Vec<&str>, Vec<&str>) = (
        old.iter().map(String::as_str).collect(),
        new.iter().map(String::as_str).collect(),
    );
    let diff = TextDiff::from_slices(&old, &new);
    let changed = diff
        .iter_all_changes()
        .filter(|change| change.tag() != ChangeTag::Equal);
    changed
        .map(|change| (change.tag(), change.value().to_owned()))
        .collect()
}

/// The body that a statement belongs to: that of the value it assigns or stores.
fn body_of<'a>(statement: &str, bodies: &[&'a str]) -> Option<&'a str> {
    let name = match statement.strip_prefix("let ") {
        Some(rest) if rest.starts_with("(sines") => rest.split('[').nth(1)?.trim_start(),
        Some(rest) => rest
            .trim_start_matches(['(', '['])
            .trim_start_matches("_, "),
        // A number that is stored belongs to the last body whose speed its place names; six speeds a body.
        None if statement.contains("] = R::from_f64(") => {
            let places = statement
                .split(['[', ']'])
                .filter_map(|part| part.parse::<usize>().ok());
            return bodies.get(places.max()? / 6).copied();
        }
        // A value that is stored is a body's.
        None => statement.split(" = ").nth(1)?.trim_start_matches('-'),
    };
    let longest = bodies
        .iter()
        .filter(|body| name.starts_with(&format!("{body}_")));
    longest.max_by_key(|body| body.len()).copied()
}

/// Sizes, tables, documentation, the banner, and stores of zero.
fn is_size_or_table(statement: &str) -> bool {
    let words = ["pub const ", "body: ", "///", "//", "#["];
    words.iter().any(|word| statement.starts_with(word))
        || statement.ends_with("= R::from_f64(0.0);")
}

fn assert_only_bodies_change(changes: &[(ChangeTag, String)], path: &[&str], bodies: &[&str]) {
    // What is of the system as a whole ends every path.
    let allowed: BTreeSet<&str> = path.iter().copied().chain(["system"]).collect();
    let bodies: Vec<&str> = bodies.iter().copied().chain(["system"]).collect();
    for (tag, statement) in changes {
        let of_path = body_of(statement, &bodies).is_some_and(|body| allowed.contains(body));
        // Columns are stored body after body: new ones are the new body's, though it may share values with a sibling.
        let is_new_column = *tag == ChangeTag::Insert && statement.starts_with("columns[");
        assert!(
            of_path || is_new_column || is_size_or_table(statement),
            "{tag}{statement}"
        );
    }
    assert!(
        changes.len() > 10,
        "only {} statements changed: the test proves nothing",
        changes.len()
    );
}

/// A statement with its numbers taken out.
fn without_numbers(statement: &str) -> String {
    let mut text = String::new();
    for (place, part) in statement.split("R::from_f64(").enumerate() {
        let rest = if place == 0 {
            part
        } else {
            part.split_once(')').map_or("", |(_, rest)| rest)
        };
        text.push_str(rest);
        text.push('#');
    }
    text
}

#[test]
fn a_changed_mass_changes_numbers_on_the_body_s_path_and_renames_nothing() {
    for (body, mass, path) in [
        ("camera", "mass = 1.717", vec!["camera", "boom", "hub"]),
        ("shoulder", "mass = 1.86", vec!["shoulder", "hub"]),
        ("hub", "mass = 0.987", vec!["hub"]),
    ] {
        let old = model();
        let new = old.replace(mass, "mass = 2.123");
        assert_ne!(old, new, "{body}");
        for formulation in [Formulation::Cheapest, Formulation::Notes] {
            let (old, new) = (module(&old, formulation), module(&new, formulation));
            let changes = changes(&old, &new);
            let kinds = |wanted: ChangeTag| -> Vec<String> {
                let of_kind = changes
                    .iter()
                    .filter(|(tag, statement)| *tag == wanted && !statement.starts_with("//"));
                of_kind
                    .map(|(_, statement)| without_numbers(statement))
                    .collect()
            };
            assert_eq!(
                kinds(ChangeTag::Delete),
                kinds(ChangeTag::Insert),
                "{body} {formulation:?}"
            );
            // In the literal sums a body's terms are added to those of the bodies before it, whatever their branch.
            if formulation == Formulation::Cheapest {
                assert_only_bodies_change(&changes, &path, &BODIES);
            }
        }
    }
}

#[test]
fn a_last_leaf_changes_only_lines_of_the_bodies_on_its_path() {
    let old = model();
    let leaf = "\n[[body]]\nname = \"tool\"\nmass = 0.7\nmass_center = [0.11, 0.12, 0.13]\n\
        inertia = { xx = 0.21, yy = 0.22, zz = 0.23, xy = 0.01, xz = 0.02, yz = 0.03 }\n\
        attachment = [0.31, 0.32, 0.33]\njoint = \"free\"\n";
    for (lower, path) in [
        (7, vec!["tool", "boom", "hub"]),
        (3, vec!["tool", "forearm", "shoulder", "hub"]),
        (1, vec!["tool", "hub"]),
    ] {
        let new = old.replace("1, 1, 7]", &format!("1, 1, 7, {lower}]")) + leaf;
        let (old, new) = (
            module(&old, Formulation::Cheapest),
            module(&new, Formulation::Cheapest),
        );
        let bodies: Vec<&str> = BODIES.into_iter().chain(["tool"]).collect();
        assert_only_bodies_change(&changes(&old, &new), &path, &bodies);
    }
}

#[test]
fn the_order_of_keys_changes_no_byte() {
    let old = model();
    let mut bodies: Vec<String> = old.split("\n[[body]]\n").map(str::to_owned).collect();
    let head: Vec<&str> = bodies[0].lines().rev().collect();
    let head = head.join("\n");
    for body in &mut bodies[1..] {
        let lines: Vec<&str> = body.trim_end().lines().rev().collect();
        *body = lines.join("\n") + "\n";
    }
    let new = format!("{head}\n\n[[body]]\n{}", bodies[1..].join("\n[[body]]\n"));
    assert_ne!(old, new);
    assert_eq!(
        module(&old, Formulation::Cheapest),
        module(&new, Formulation::Cheapest)
    );
}
