//! What the header for C says of a module's names and limits.

use kane_codegen::listing::{Facts, Module};
use kane_codegen::origin::Origin;
use kane_codegen::printers::c;
use kane_codegen::{compile, options::Options};
use kane_test_support::models::{build, system};

/// The header of a module of which these facts are others.
fn header(change: impl FnOnce(&mut Facts)) -> String {
    let text = system("[0, 1]", &[("one", "[\"theta1\"]"), ("two", "[\"s1\"]")]);
    let tree = build(&text).expect("a sound description").tree;
    let options = Options::default();
    let compiled = compile::compile(&tree, &options).expect("the default functions");
    let origin = Origin::new(&tree, "two.toml", &options);
    let mut module = Module::new(&tree, origin, &compiled);
    change(&mut module.facts);
    c::header(&module, "two")
}

#[test]
fn names_are_literals_whatever_they_hold() {
    let header = header(|facts| {
        "left \"foot\"\n".clone_into(&mut facts.bodies[0].name);
        "größe".clone_into(&mut facts.bodies[1].name);
    });
    assert!(header.contains("\"left \\\"foot\\\"\\012\""), "{header}");
    assert!(header.contains("\"gr\\303\\266\\303\\237e\""), "{header}");
}

#[test]
fn body_called_as_a_table_has_another_name() {
    let header = header(|facts| "names".clone_into(&mut facts.bodies[0].identifier));
    assert!(header.contains("TWO_BODY_NAMES_ = 0"), "{header}");
    assert!(header.contains("TWO_BODY_NAMES[TWO_NB]"), "{header}");
}

#[test]
fn body_called_as_the_rest_of_a_table_has_another_name() {
    let header = header(|facts| {
        // The speeds that move the frame of a body that is called `body`.
        facts.sizes.0[0].name = "BODY_SPEEDS".to_owned();
        "speeds".clone_into(&mut facts.bodies[0].identifier);
        "speeds_".clone_into(&mut facts.bodies[1].identifier);
    });
    assert!(header.contains("TWO_BODY_SPEEDS_ = 0"), "{header}");
    assert!(header.contains("TWO_BODY_SPEEDS__ = 1"), "{header}");
}

#[test]
fn numbers_without_bound_are_huge() {
    let header = header(|facts| facts.limits.lower = vec![f64::NEG_INFINITY, 0.1]);
    let start = header.find("LOWER_LIMITS[").expect("the table of limits");
    let table: String = header[start..].chars().take_while(|&c| c != ';').collect();
    let numbers = table.split_once('{').expect("its numbers").1;
    let numbers: Vec<&str> = numbers.split([',', '}']).map(str::trim).collect();
    assert_eq!(numbers[..2], ["-HUGE_VAL", "0.1"]);
}
