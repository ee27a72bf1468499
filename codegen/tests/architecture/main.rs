//! How the source is laid out: no files that import each other, modules in the order in which they import one another, nothing
//! too long to be read at once, tests where they run and without comparisons that pass over NaN.
//!
//! A file imports another one where a path in it names something that stands there: a path of a `use`, or one in the code
//! whose first name is `crate`, `self`, `super`, or known in the module. What a `use` passes on under its name belongs to the
//! file in which it stands, not to the one that passes it on. So `mod` lines are no imports, nor is a `pub use`, unless the
//! file itself speaks of what it passes on. A path that ends at a module is an import of that module's file. What a macro
//! quotes is left out.
#![expect(
    clippy::panic,
    clippy::unwrap_used,
    reason = "a test stops where it fails, its helpers too"
)]

mod imports;
mod krate;
mod lengths;
mod nan;
mod no_tests;
mod order;
mod planted;
mod resolve;
mod walk;

use std::path::{Path, PathBuf};

use krate::Crate;
use walk::Sources;

/// The crates, by their folders and roots.
const CRATES: [(&str, &str); 3] = [
    ("codegen/src", "lib.rs"),
    ("codegen/src", "main.rs"),
    ("src", "lib.rs"),
];

/// Where people write Rust.
const FOLDERS: [&str; 8] = [
    "benches",
    "codegen/src",
    "codegen/tests",
    "examples",
    "firmware",
    "fuzz",
    "src",
    "tests",
];

fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

#[test]
fn no_files_import_each_other() {
    let circles = CRATES.iter().flat_map(|(folder, root)| {
        let sources = Sources::read(&repository().join(folder));
        let circles = order::circles(&Crate::read(&sources, root).imports());
        circles
            .into_iter()
            .map(move |circle| format!("{folder}:\n{circle}"))
    });
    let circles: Vec<String> = circles.collect();
    assert!(
        circles.is_empty(),
        "files import each other:\n{}\nput what they share into a file of its own",
        circles.concat()
    );
}

#[test]
fn modules_import_from_those_above_them_in_the_list() {
    let breaches = CRATES.iter().flat_map(|(folder, root)| {
        let sources = Sources::read(&repository().join(folder));
        let breaches = order::breaches(&Crate::read(&sources, root));
        breaches
            .into_iter()
            .map(move |breach| format!("{folder}/{breach}\n"))
    });
    let breaches: Vec<String> = breaches.collect();
    assert!(
        breaches.is_empty(),
        "modules import from those below them:\n{}",
        breaches.concat()
    );
}

/// What is wrong in each of the folders, a line each.
fn faults(folders: &[&str], found: impl Fn(&Sources) -> Vec<String>) -> String {
    let lines = folders.iter().flat_map(|folder| {
        let found = found(&Sources::read(&repository().join(folder)));
        found
            .into_iter()
            .map(move |one| format!("{folder}/{one}\n"))
    });
    lines.collect()
}

#[test]
fn files_and_functions_can_be_read_at_once() {
    let long = faults(&FOLDERS, lengths::too_long);
    assert!(long.is_empty(), "too long:\n{long}");
}

#[test]
fn sources_hold_no_tests() {
    let tests = faults(&["codegen/src", "src"], no_tests::found);
    assert!(
        tests.is_empty(),
        "tests that never run; move them to `tests` or `codegen/tests`:\n{tests}"
    );
}

#[test]
fn tests_pass_over_no_number() {
    let mut passing = faults(&["codegen/tests", "tests"], nan::passed_over);
    passing += &faults(&["examples"], nan::passed_over_beside_programs);
    assert!(
        passing.is_empty(),
        "passed over where they are NaN; use `compare::larger` or `largest`:\n{passing}"
    );
}
