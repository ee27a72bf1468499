//! Fused multiply-add: the same values up to rounding, the same counts, and nothing of it where it is not asked for.

#![expect(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use std::fs;

use kane_codegen::{
    compile::{self, Compiled},
    config::Functions,
    description::{Base, Reading, no_includes},
    diagnostic::Source,
    expr::Input,
    generate,
    options::Options,
    program::{self, Instruction, Operand, Operation, Program},
};
use kane_test_support::compare::{Tolerance, assert_close};

use crate::compiled::read;

/// Rounding of a function, relative to the largest entry of its output: some hundred operations deep, and a solution
/// whose mass matrix has a condition number of some thousands.
const TOLERANCE: f64 = 1e-11;
const MODELS: [(&str, Option<Base>); 4] = [
    ("models/eight_body.toml", None),
    ("tests/robots/ur5/ur5.urdf", Some(Base::Fixed)),
    ("tests/robots/panda/panda.urdf", Some(Base::Fixed)),
    ("tests/robots/solo12/solo12.urdf", Some(Base::Free)),
];

fn compiled(path: &str, base: Option<Base>, fma: bool) -> Compiled {
    let tree = read(
        path,
        &Reading {
            base,
            ..Reading::default()
        },
    );
    let options = Options {
        fma,
        ..Options::default()
    };
    compile::compile(&tree, &options).unwrap()
}

/// Some state: the same number for the same input.
fn state(input: Input) -> f64 {
    let spread = |place: usize, step: f64| (0.4 + step * place as f64) % 1.6 - 0.8;
    match input {
        Input::Q(id) => spread(id.index(), 0.37),
        Input::U(id) => spread(id.index(), 0.71),
        Input::UDot(id) => spread(id.index(), 1.03),
        Input::Tau(id) => spread(id.index(), 1.31),
        other => unreachable!("{other:?} is no input of these"),
    }
}

#[test]
fn fused_functions_agree_up_to_rounding() {
    for (path, base) in MODELS {
        let (plain, fused) = (compiled(path, base, false), compiled(path, base, true));
        for (plain, fused) in plain.functions.iter().zip(&fused.functions) {
            let name = plain.request.name();
            let (plain, fused) = (plain.program.evaluate(state), fused.program.evaluate(state));
            let at = format!("{path}, {name}");
            assert_close(at, &fused, &plain, Tolerance::relative(TOLERANCE));
        }
    }
}

#[test]
fn fusing_keeps_the_counts_and_fuses_most_sums_of_the_dynamics() {
    for (path, base) in MODELS {
        let (plain, fused) = (compiled(path, base, false), compiled(path, base, true));
        for (plain, fused) in plain.functions.iter().zip(&fused.functions) {
            assert_eq!(plain.operations, fused.program.operations(), "{path}");
            assert_eq!(plain.program.fused(), 0, "{path}");
            if ["inverse_dynamics", "forward_dynamics"].contains(&plain.request.name().as_str()) {
                let (pairs, adds) = (fused.program.fused(), fused.operations.add);
                assert!(2 * pairs > adds, "{path}: {pairs} of {adds} sums are fused");
            }
        }
    }
}

/// The results of products that a sum could take in.
fn lone_products_of_sums(program: &Program) -> usize {
    let mut uses = vec![0; program.values.len()];
    let operands = program.instructions.iter().flat_map(Instruction::operands);
    for id in operands
        .chain(program.stores.iter().copied())
        .filter_map(Operand::value)
    {
        uses[id.index()] += 1;
    }
    let mut is_product = vec![false; program.values.len()];
    let mut count = 0;
    for instruction in &program.instructions {
        if let Instruction::Compute { result, operation } = instruction {
            is_product[result.index()] =
                matches!(operation, Operation::Mul(..)) && uses[result.index()] == 1;
            if matches!(operation, Operation::Add(..)) {
                let ids = operation.operands().filter_map(Operand::value);
                count += ids.filter(|id| is_product[id.index()]).count();
            }
        }
    }
    count
}

#[test]
fn no_product_that_a_sum_alone_uses_is_left() {
    for (path, base) in MODELS {
        for function in compiled(path, base, true).functions {
            program::verify(&function.program).unwrap();
            let left = lone_products_of_sums(&function.program);
            assert_eq!(left, 0, "{path}, {}", function.request.name());
        }
    }
}

fn module(fma: bool) -> String {
    let path = format!("{}/tests/models/cart_pole.toml", env!("CARGO_MANIFEST_DIR"));
    let source = Source::new("cart_pole.toml", fs::read_to_string(path).unwrap());
    let options = Options {
        functions: Functions::Named(vec!["forward_dynamics".to_owned()]),
        fma,
        ..Options::default()
    };
    let generated = generate::generate(&source, "models/cart_pole.toml", &options, &no_includes);
    generated.unwrap().source
}

#[test]
fn text_without_fused_multiplication_has_nothing_of_it() {
    let text = module(false);
    assert!(!text.contains("mul_add") && !text.contains("fma") && !text.contains("fused"));
}

#[test]
fn banner_and_hash_tell_of_fused_multiplication() {
    let banner = |fma| module(fma).lines().nth(1).unwrap().to_owned();
    let (plain, fused) = (banner(false), banner(true));
    assert!(fused.ends_with("; fma: true."), "{fused}");
    let hash = |line: &str| line.split_once(',').unwrap().0.to_owned();
    assert_ne!(hash(&plain), hash(&fused));
}

#[test]
fn a_cart_pole_with_fused_multiplication() {
    let text = module(true);
    let start = text.find("/// Forward dynamics").unwrap();
    insta::assert_snapshot!(text[start..].split("impl").next().unwrap());
}
