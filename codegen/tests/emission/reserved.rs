//! The names that no local value of a function may have: those of arguments and outputs, and no others.

use std::collections::BTreeSet;

use kane_codegen::{
    functions::{CATALOGUE, OF_FRAMES},
    listing::RESERVED,
};

/// Names that the printers give, whatever is asked for.
const PRINTED: [&str; 6] = ["cosines", "lane", "p", "parameters", "sin_cos", "sines"];

#[test]
fn no_local_value_can_take_the_name_of_an_argument_or_output_and_no_body_is_renamed_in_vain() {
    let functions = CATALOGUE.iter().chain(&OF_FRAMES);
    let names = functions.flat_map(|function| {
        let arguments = function.arguments.iter().map(|argument| argument.name());
        let outputs = function.outputs.iter().map(|output| &*output.name);
        arguments.chain(outputs)
    });
    let names: BTreeSet<&str> = names.chain(PRINTED).collect();
    assert_eq!(BTreeSet::from(RESERVED), names);
}
