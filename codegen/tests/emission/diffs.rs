//! Changes of a model show in its generated code where they matter and nowhere else.

#![expect(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use std::{
    collections::{BTreeMap, BTreeSet},
    fs,
    sync::{Arc, Mutex, OnceLock},
};

use kane_codegen::{
    config::{Formulation, Functions},
    description::no_includes,
    diagnostic::Source,
    functions::CATALOGUE,
    generate::generate,
    options::Options,
    recursive::Technique::{Articulated, Carriers, Lockstep},
};

use kane_test_support::models::{at_run_time, system};

use crate::names::{Names, as_assignment};

/// The eight-body example, body after body.
fn eight_body() -> String {
    let path = format!("{}/../models/eight_body.toml", env!("CARGO_MANIFEST_DIR"));
    let text = fs::read_to_string(path).unwrap();
    text.replace("order = \"notes\"", "order = \"body\"")
}

/// A trunk and a torso with two arms, all numbers different from one another and none 0 or 1.
fn arms() -> String {
    let mut text =
        "name = \"arms\"\ngravity = [0.1, 0.2, -9.81]\nlower_bodies = [0, 1, 2, 2]\n".to_owned();
    for (k, name) in ["trunk", "torso", "left", "right"].into_iter().enumerate() {
        text += &body(name, k + 2, "[\"theta1\", \"theta3\"]");
    }
    text
}

/// A body whose numbers `k` makes different from every other's.
fn body(name: &str, k: usize, joint: &str) -> String {
    format!(
        "\n[[body]]\nname = \"{name}\"\nmass = {k}.57\nmass_center = [0.11{k}, -0.12{k}, 0.13{k}]\n\
         inertia = {{ xx = 0.21{k}, yy = 0.22{k}, zz = 0.23{k}, xy = 0.01{k}, xz = -0.02{k}, yz = 0.03{k} }}\n\
         attachment = [0.31{k}, -0.32{k}, 0.33{k}]\njoint = {joint}\n"
    )
}

fn with_leaf(text: &str, lower: usize, leaf: &str) -> String {
    let (head, rest) = text.split_once("lower_bodies = [").unwrap();
    let (lower_bodies, rest) = rest.split_once(']').unwrap();
    format!("{head}lower_bodies = [{lower_bodies}, {lower}]{rest}{leaf}")
}

/// The module of a description, generated once for all tests.
fn module(text: &str, formulation: Formulation) -> Arc<str> {
    type Generated = Arc<OnceLock<Arc<str>>>;
    static KNOWN: Mutex<BTreeMap<String, Generated>> = Mutex::new(BTreeMap::new());
    let key = format!("{formulation:?}\n{text}");
    let known = Arc::clone(KNOWN.lock().unwrap().entry(key).or_default());
    let all = || generated(text, formulation, Functions::All(Vec::new()));
    Arc::clone(known.get_or_init(|| all().into()))
}

fn generated(text: &str, formulation: Formulation, functions: Functions) -> String {
    let options = Options {
        functions,
        formulation,
        // Which solver is the cheaper, what carries branches, and which of them are alike depends on all bodies.
        without: BTreeSet::from([Articulated, Carriers, Lockstep]),
        ..Options::default()
    };
    generate(
        &Source::new("model.toml", text),
        "models/model.toml",
        &options,
        &no_includes,
    )
    .unwrap()
    .source
}

/// The text with every statement and every field on one line, however it was broken.
fn statements(text: &str) -> Vec<String> {
    let mut statements = Vec::new();
    let mut current = String::new();
    for line in text.lines().map(str::trim) {
        if !current.is_empty() {
            current.push(' ');
        }
        current.push_str(line);
        let is_field = current == line && line.ends_with(',') && !line.contains(['(', '[']);
        let ends = line.is_empty() || line.ends_with([';', '{', '}']) || is_field;
        if ends || line.starts_with("//") || line.starts_with('#') {
            statements.push(std::mem::take(&mut current));
        }
    }
    statements
}

/// A statement without the place at which it reads a sine or cosine: where a body's angles come to be needed, those of
/// the bodies after it move.
fn without_place(statement: &str) -> String {
    for array in ["= sines[", "= cosines["] {
        if let Some((value, place)) = statement.split_once(array) {
            assert!(place.trim_end_matches("];").parse::<usize>().is_ok());
            return format!("{value}{array}];");
        }
    }
    statement.to_owned()
}

/// The statements that stand in one text alone, function by function, with a mark for which.
fn changes(old: &str, new: &str) -> Vec<(char, String)> {
    let counted = |text: &str| {
        let mut counts: BTreeMap<(String, String), i64> = BTreeMap::new();
        let mut function = String::new();
        for statement in statements(text) {
            if let Some(rest) = statement.strip_prefix("pub fn ") {
                rest.split('<').next().unwrap().clone_into(&mut function);
            }
            // What a long function declares before it is assigned counts as declared where it is.
            let (target, value) = statement.split_once(" = ").unwrap_or((&statement, ""));
            if value.is_empty() && target.starts_with("let (") {
                continue;
            }
            let is_declared = target.contains([' ', '[', '*', ':']);
            let statement = if value.is_empty() || is_declared {
                without_place(&statement)
            } else {
                format!("let {}", without_place(&statement))
            };
            *counts.entry((function.clone(), statement)).or_default() += 1;
        }
        counts
    };
    let (old, new) = (counted(old), counted(new));
    let keys: BTreeSet<_> = old.keys().chain(new.keys()).collect();
    let change = |key| {
        let more = new.get(key).unwrap_or(&0) - old.get(key).unwrap_or(&0);
        let mark = if more > 0 { '+' } else { '-' };
        (more != 0).then(|| (mark, key.1.clone()))
    };
    keys.into_iter().filter_map(change).collect()
}

/// Sizes, tables, documentation, the banner and stores of zero.
fn is_size_or_table(statement: &str) -> bool {
    let table = [
        "kane::Block {",
        "kane::BaseTerm {",
        "base: ",
        "parameter: ",
        "factor: ",
        "reason = \"generated",
        // A base parameter in words.
        "\"",
        "kane::Joint {",
        "name: ",
        "chart: ",
        "q: [",
        "body: ",
        "partition: ",
        "speed: ",
        "columns: ",
        "first: ",
        "kane::Cost::new(",
        // Inertial parameters and base parameters, in numbers.
        "pi[",
        "}",
    ];
    let mut words = table.into_iter().chain(["pub const ", "///", "//", "#["]);
    words.any(|word| statement.starts_with(word)) || statement.ends_with("= R::from_f64(0.0);")
}

fn assert_only_bodies_change(old: &str, new: &str, path: &[&str]) {
    let names = Names::of(new);
    // What is of the system as a whole ends every path.
    let allowed: BTreeSet<&str> = path.iter().copied().chain(["system"]).collect();
    let changes = changes(old, new);
    let is_of_path = |statement: &str| {
        let body = names.body_of(statement);
        body.is_some_and(|body| allowed.contains(body))
    };
    // An entry that is a value of the path in one text may in the other be stored as another's, which is the same.
    let stored = |statement: &str| {
        let (target, _) = statement.split_once(" = ")?;
        target.ends_with(']').then(|| target.to_owned())
    };
    let of_path = changes.iter().map(|(_, own)| as_assignment(own));
    let of_path = of_path.filter(|own| is_of_path(own));
    let stored_of_path: BTreeSet<String> = of_path.filter_map(|own| stored(&own)).collect();
    let mut strays = Vec::new();
    for (mark, statement) in &changes {
        let statement = &as_assignment(statement);
        let is_stored = stored(statement).is_some_and(|own| stored_of_path.contains(&own));
        let of_path = is_of_path(statement) || is_stored;
        // Columns are stored body after body: new ones are the new body's, though it may share values with a sibling.
        let is_new_column = *mark == '+' && statement.starts_with("columns[");
        if !(of_path || is_new_column || is_size_or_table(statement)) {
            strays.push(format!("{mark}{statement}"));
        }
    }
    assert!(
        strays.is_empty(),
        "{} of {} changes stray, {path:?}:\n{}",
        strays.len(),
        changes.len(),
        strays[..strays.len().min(20)].join("\n")
    );
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

fn assert_only_numbers_change(old: &str, new: &str) {
    assert_ne!(old, new, "nothing changed: the test proves nothing");
    let code = |text: &str| -> Vec<String> {
        let is_hash = |statement: &str| statement.starts_with("pub const FINGERPRINT");
        let statements = statements(text)
            .into_iter()
            .filter(|statement| !statement.starts_with("//") && !is_hash(statement));
        statements
            .map(|statement| without_numbers(&statement))
            .collect()
    };
    for (old, new) in code(old).into_iter().zip(code(new)) {
        assert_eq!(old, new);
    }
    assert_eq!(code(old).len(), code(new).len());
}

#[test]
fn a_changed_mass_changes_numbers_on_the_body_s_path_and_renames_nothing() {
    let old = eight_body();
    for (mass, path) in [
        ("mass = 1.717", &["camera", "boom", "hub"][..]),
        ("mass = 1.86", &["shoulder", "hub"]),
        ("mass = 0.987", &["hub"]),
    ] {
        let new = old.replace(mass, "mass = 2.123");
        assert_ne!(old, new, "{mass}");
        let [notes, changed] = [&old, &new].map(|text| module(text, Formulation::Notes));
        assert_only_numbers_change(&notes, &changed);
        let (cheapest, changed) = (
            module(&old, Formulation::Cheapest),
            module(&new, Formulation::Cheapest),
        );
        assert_only_numbers_change(&cheapest, &changed);
        // In the literal sums a body's terms are added to those of the bodies before it, whatever their branch.
        assert_only_bodies_change(&cheapest, &changed, path);
    }
}

/// The mass of all bodies is in every column.
#[test]
fn a_changed_mass_changes_no_lines_of_another_tree() {
    let mut old =
        "name = \"pair\"\ngravity = [0.1, 0.2, -9.81]\nlower_bodies = [0, 1, 0, 3]\n".to_owned();
    for (k, name) in ["one", "arm", "two", "leg"].into_iter().enumerate() {
        let joint = ["\"free\"", "[\"theta1\"]"][k % 2];
        old += &body(name, k + 2, joint);
    }
    let new = old.replace("mass = 5.57", "mass = 6.57");
    let functions = [
        "center_of_mass_jacobian",
        "d(center_of_mass_velocity)/d(q, u)",
        "d(center_of_mass_jacobian_dot_u)/d(q, u)",
        "d(centroidal_momentum_matrix_dot_u)/d(q, u)",
        "d(angular_momentum)/d(q, u)",
    ];
    for function in functions {
        let functions = || Functions::Named(vec![function.to_owned()]);
        let [old, new] =
            [&old, &new].map(|text| generated(text, Formulation::Recursive, functions()));
        let changes = changes(&old, &new);
        assert!(changes.len() > 10, "{function}: the test proves nothing");
        let of_others = |statement: &str| {
            ["let one_", "let arm_"]
                .iter()
                .any(|name| statement.starts_with(name))
        };
        let mut strays = changes.iter().filter(|(_, statement)| of_others(statement));
        assert_eq!(strays.next(), None, "{function}");
    }
}

#[test]
fn numbers_set_at_run_time_change_no_lines_of_another_tree() {
    let joint = "\"free\"\nchart = \"angles\"\ndamping = { s1 = 0.3, s2 = 0.4, s3 = 0.5 }";
    let head = "name = \"two\"\ngravity = [0.0, 0.0, -9.81]\nlower_bodies = [0, 0]\n";
    let [one, other] = [body("a", 2, joint), body("b", 3, joint)];
    let lines = |other: &str| -> Vec<String> {
        let text = format!("{head}{one}{other}");
        let functions = Functions::Named(vec!["hessian(kinetic_energy; q)".to_owned()]);
        let module = generated(&text, Formulation::Recursive, functions);
        let own = module
            .lines()
            .filter(|line| line.trim().starts_with("let a_"));
        own.map(str::to_owned).collect()
    };
    let at_run_time = at_run_time(&other);
    assert_ne!(at_run_time, other);
    assert!(lines(&at_run_time) == lines(&other));
}

#[test]
fn a_constant_that_changes_its_sign_renames_nothing() {
    let old = arms();
    let old = old.replace(
        "mass_center = [0.115, -0.125, 0.135]",
        "mass_center = [0.115, -0.125, -0.5]",
    );
    let new = old
        .replace("mass = 5.57", "mass = 0.57")
        .replace("-0.125", "0.525");
    assert_ne!(old, new);
    assert_only_numbers_change(
        &module(&old, Formulation::Cheapest),
        &module(&new, Formulation::Cheapest),
    );
}

#[test]
fn a_last_leaf_changes_only_lines_of_the_bodies_on_its_path() {
    let old = eight_body();
    let leaf = body("tool", 7, "\"free\"");
    for (lower, path) in [
        (7, &["tool", "boom", "hub"][..]),
        (3, &["tool", "forearm", "shoulder", "hub"]),
        (1, &["tool", "hub"]),
    ] {
        let new = with_leaf(&old, lower, &leaf);
        let [old, new] = [&old, &new].map(|text| module(text, Formulation::Cheapest));
        assert_only_bodies_change(&old, &new, path);
    }
}

#[test]
fn a_last_leaf_s_angles_are_lines_of_their_own_among_all_angles() {
    let old = eight_body();
    let new = with_leaf(&old, 7, &body("tool", 7, "\"free\""));
    let angles = |text: &str| -> Vec<String> {
        let text = module(text, Formulation::Cheapest);
        let function = text.split_once("pub fn inverse_dynamics<").unwrap().1;
        let list = function.split_once("R::sin_cos_array([\n").unwrap().1;
        let list = list.split_once("    ]);").unwrap().0;
        list.lines().map(|line| line.trim().to_owned()).collect()
    };
    let (old, new) = (angles(&old), angles(&new));
    assert_eq!(old.len(), 24);
    assert_eq!(new[..24], old);
    assert_eq!(new[24..], ["tool_theta1,", "tool_theta2,", "tool_theta3,"]);
}

#[test]
fn a_last_leaf_changes_only_lines_of_its_path_on_hinges_and_with_runtime_values() {
    let leaf = body("foot", 7, "[\"theta2\", \"s1\"]");
    for (lower, path) in [
        (3, &["foot", "left", "torso", "trunk"][..]),
        (1, &["foot", "trunk"]),
    ] {
        for text in [arms(), at_run_time(&arms())] {
            let new = with_leaf(&text, lower, &leaf);
            let (old, new) = (
                module(&text, Formulation::Recursive),
                module(&new, Formulation::Recursive),
            );
            assert_only_bodies_change(&old, &new, path);
        }
    }
}

/// The comparison of thousands of fields is more than the compiler's stack holds.
#[test]
fn structures_with_many_fields_are_not_compared() {
    let names: Vec<String> = (0..100).map(|place| format!("link{place}")).collect();
    let bodies = names.iter().enumerate();
    let bodies =
        bodies.map(|(place, name)| (name.as_str(), ["[\"theta1\"]", "[\"theta2\"]"][place % 2]));
    let lower: Vec<usize> = (0..names.len()).collect();
    let text = at_run_time(&system(&format!("{lower:?}"), &bodies.collect::<Vec<_>>()));
    let options = Options {
        functions: Functions::Named(vec!["bias".to_owned()]),
        ..Options::default()
    };
    let source = Source::new("chain.toml", text);
    let module = generate(&source, "chain.toml", &options, &no_includes).unwrap();
    let derived = |structure: &str| {
        let (before, _) = module.source.split_once(structure).unwrap();
        before.lines().last().unwrap().to_owned()
    };
    assert_eq!(
        derived("pub struct Prepared"),
        "#[derive(Clone, Copy, Debug)]"
    );
    assert_eq!(
        derived("pub struct Parameters"),
        "#[derive(Clone, Copy, Debug, PartialEq)]"
    );
}

#[test]
fn a_function_s_text_does_not_depend_on_what_else_is_asked_for() {
    let text = at_run_time(&arms());
    let all = module(&text, Formulation::Cheapest);
    for function in CATALOGUE
        .iter()
        .filter(|function| !function.formulations().is_empty())
    {
        let functions = Functions::Named(vec![function.name.to_owned()]);
        let options = Options {
            functions,
            ..Options::default()
        };
        let alone = generate(
            &Source::new("m.toml", &*text),
            "m.toml",
            &options,
            &no_includes,
        )
        .unwrap()
        .source;
        let body = |module: &str| {
            let start = module.find(&format!("pub fn {}<", function.name)).unwrap();
            module[start..start + module[start..].find("\n}\n").unwrap()].to_owned()
        };
        assert_eq!(body(&alone), body(&all), "{}", function.name);
    }
}

#[test]
fn the_order_of_keys_changes_no_byte() {
    let old = eight_body();
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
