//! Reading `kane.toml`.

use kane_codegen::config::{self, Formulation, Functions};
use kane_codegen::diagnostic::Source;

const KNOWN: [&str; 3] = ["mass_matrix", "bias", "rotation"];

#[test]
fn what_is_absent_has_its_default() {
    let text = "[[system]]\nmodel = \"models/arm.toml\"\noutput = \"generated/arm.rs\"\n";
    let config = config::parse(&Source::new("kane.toml", text), &KNOWN).unwrap();
    let [arm] = config.systems.as_slice() else {
        panic!("one system")
    };
    assert_eq!(
        (arm.model.as_str(), arm.output.as_str()),
        ("models/arm.toml", "generated/arm.rs")
    );
    assert_eq!(
        (&arm.functions, arm.formulation),
        (&Functions::Default, Formulation::Cheapest)
    );
}

#[test]
fn systems_and_functions_keep_their_order() {
    let text = r#"
        [[system]]
        output = "b.rs"
        model = "b.toml"
        functions = ["rotation", "bias"]
        formulation = "notes"
        [[system]]
        model = "a.toml"
        output = "../a.rs"
        functions = ["all"]
        formulation = "recursive"
    "#;
    let config = config::parse(&Source::new("kane.toml", text), &KNOWN).unwrap();
    let [b, a] = config.systems.as_slice() else {
        panic!("two systems")
    };
    assert_eq!(
        b.functions,
        Functions::Named(vec!["rotation".to_owned(), "bias".to_owned()])
    );
    assert_eq!(
        (b.formulation, a.formulation),
        (Formulation::Notes, Formulation::Recursive)
    );
    assert_eq!(
        (a.model.as_str(), &a.functions),
        ("a.toml", &Functions::All)
    );
}

#[test]
fn file_that_is_not_toml_has_that_fault_alone() {
    let faults =
        config::parse(&Source::new("kane.toml", "[[system]\nmodel = 1"), &KNOWN).unwrap_err();
    insta::assert_snapshot!(faults, @r#"
    error: not valid TOML: unclosed array table, expected `]`
     --> kane.toml:1:10
      |
    1 | [[system]
      |          ^ here
    "#);
}
