//! Names that a message lists.

#![expect(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use kane_codegen::description::toml;
use kane_codegen::diagnostic::Source;
use kane_codegen::tree::{Changes, build_with};
use kane_test_support::models::system;

/// What is said of a joint to remove that the model lacks, where it has so many: `j1`, `j2` and so on.
fn help(n_joints: usize) -> String {
    let names: Vec<String> = (1..=n_joints).map(|n| format!("j{n}")).collect();
    let joint = "[\"theta1\"]";
    let bodies: Vec<(&str, &str)> = names.iter().map(|name| (name.as_str(), joint)).collect();
    let text = system(&format!("{:?}", vec![0; n_joints]), &bodies);
    let description = toml::parse(&Source::new("model.toml", text));
    let changes = Changes {
        remove: vec!["unlike any".to_owned()],
        ..Changes::default()
    };
    let faults = build_with(&description, &changes).unwrap_err();
    faults.to_string()
}

#[test]
fn of_many_names_the_first_are_listed_and_the_others_counted() {
    let ends = |n_joints: usize, end: &str| {
        let help = help(n_joints);
        assert!(help.trim_end().ends_with(end), "{help}");
    };
    ends(3, " j1, j2, j3");
    ends(40, ", j39, j40");
    ends(42, ", j39, j40 and 2 more");
}
