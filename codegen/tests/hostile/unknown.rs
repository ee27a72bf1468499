//! Very many names that are unknown: what was meant is looked for until that takes too long.

use kane_codegen::{
    description::{Description, toml},
    diagnostic::Source,
    options::Functions,
    tree::{self, Changes},
};
use kane_test_support::models::system;

/// More pairs of names than are compared.
const COUNT: usize = 1_200;

/// A star of bodies, `body0` and so on.
fn star() -> Description {
    let names: Vec<String> = (0..COUNT).map(|number| format!("body{number}")).collect();
    let bodies = names.iter().map(|name| (name.as_str(), "[\"theta1\"]"));
    let bodies: Vec<(&str, &str)> = bodies.collect();
    let text = system(&format!("{:?}", vec![0; COUNT]), &bodies);
    toml::parse(&Source::new("model.toml", text))
}

/// Names that are each near one of a body.
fn unknown() -> impl Iterator<Item = String> {
    (0..COUNT).map(|number| format!("bady{number}"))
}

fn is_near(help: &str) -> bool {
    help.starts_with("did you mean `body")
}

/// What was meant by the first is told, and by the last no more.
fn check<'a>(mut helps: impl DoubleEndedIterator<Item = &'a str>) {
    assert!(helps.next().is_some_and(is_near));
    assert!(helps.next_back().is_some_and(|help| !is_near(help)));
}

#[test]
fn of_joints_that_are_locked_or_removed() {
    let description = star();
    let locked = Changes {
        lock: unknown().map(|name| (name, 0.0)).collect(),
        ..Changes::default()
    };
    let removed = Changes {
        remove: unknown().collect(),
        ..Changes::default()
    };
    for changes in [locked, removed] {
        let faults = tree::build_with(&description, &changes).unwrap_err();
        assert_eq!(faults.list().len(), COUNT);
        check(
            faults
                .list()
                .iter()
                .filter_map(|fault| fault.help.as_deref()),
        );
    }
}

#[test]
fn of_joints_that_are_prescribed() {
    let description = star();
    let tree = tree::build(&description).unwrap().tree;
    let names: Vec<String> = unknown().collect();
    let faults = tree::prescribe(&description, tree, &names).unwrap_err();
    let helps: Vec<String> = faults.iter().map(tree::PrescribedFault::help).collect();
    assert_eq!(helps.len(), COUNT);
    check(helps.iter().map(String::as_str));
}

#[test]
fn of_frames_of_functions() {
    let tree = tree::build(&star()).unwrap().tree;
    let functions = Functions::of(unknown().map(|name| format!("pose({name})")));
    let faults = functions.on(&tree).unwrap_err();
    assert_eq!(faults.len(), COUNT);
    let messages: Vec<String> = faults.iter().map(ToString::to_string).collect();
    let helps = messages
        .iter()
        .filter_map(|message| message.split_once("; "));
    check(helps.map(|(_, help)| help));
}
