//! How many numbers wait in memory until they are used.

use kane_codegen::{
    compile,
    config::Functions,
    options::Options,
    program::{Operand, Program},
    recursive::Technique,
};

use crate::compiled::robot;

/// The most numbers that were computed and are needed later, between two instructions.
fn waiting(program: &Program) -> usize {
    let mut last_use = vec![0; program.values.len()];
    for (place, instruction) in program.instructions.iter().enumerate() {
        for id in instruction.operands().filter_map(Operand::value) {
            last_use[id.index()] = place;
        }
    }
    let mut ends = vec![0; program.instructions.len()];
    let (mut now, mut most) = (0_usize, 0);
    for (place, instruction) in program.instructions.iter().enumerate() {
        for id in instruction
            .results()
            .filter(|id| last_use[id.index()] > place)
        {
            ends[last_use[id.index()]] += 1;
            now += 1;
        }
        now -= ends[place];
        most = most.max(now);
    }
    most
}

#[test]
fn few_numbers_of_a_regressor_wait() {
    let tree = robot("solo12");
    let options = Options {
        functions: Functions::Named(vec!["regressor_packed".to_owned()]),
        // What stands in arrays does not wait.
        without: [Technique::Lockstep].into(),
        ..Options::default()
    };
    let compiled = compile::compile(&tree, &options).unwrap();
    let most = compiled.functions.iter().map(|own| waiting(&own.program));
    // Column after column. If all columns of a body went through each joint together, more than twice as many would wait.
    insta::assert_snapshot!(most.max().unwrap(), @"122");
}
