//! The tests beside a module pass for it, and fail for modules with one token changed.
//!
//! A changed token that changes no value is no fault: signs of products that are zero, whatever the state. Which these are,
//! the tests beside the module do not say, but states of other kind: numbers anywhere between -1 and 1.

use kane_test_mutations::{
    CART_POLE, DOUBLE_PENDULUM, EIGHT_BODY, Functions, Module, Mutant, PANDA, Random, Tests, UR5,
};
use kane_test_support::compare::largest;

/// How many states say that a mutant changes nothing.
const STATES: u64 = 100;

/// How far rounding leads two ways to one number apart, relative to the largest number of an output.
const ROUNDING: f64 = 1e-13;

/// How many mutants there are at least that change a value, of all and of the third that ordinary runs compile.
const LEAST: usize = if cfg!(every_system) { 10 } else { 2 };

/// The names of the tests that fail.
fn failing(tests: Tests) -> Vec<&'static str> {
    let failing = tests.iter().filter(|(_, test)| test().is_err());
    failing.map(|(name, _)| *name).collect()
}

/// The functions of which the mutant gives other values in some state.
fn changed(module: &Module, mutant: &Mutant) -> Vec<&'static str> {
    let of = |functions: Functions, wanted: &str| {
        let mut functions = functions.iter();
        let found = functions.find(|(name, _)| *name == wanted);
        found.expect("a mutant has the functions of its module").1
    };
    let names = mutant.functions.iter().map(|(name, _)| *name);
    let changed = names.filter(|name| {
        let (right, wrong) = (of(module.functions, name), of(mutant.functions, name));
        (0..STATES).any(|seed| differ(&right(Random::new(seed)), &wrong(Random::new(seed))))
    });
    changed.collect()
}

fn differ(right: &[f64], wrong: &[f64]) -> bool {
    let largest = largest(right);
    assert!(largest.is_finite(), "a state without values");
    // What is not a number is another one.
    let is_same = |(right, wrong): (&f64, &f64)| (right - wrong).abs() <= ROUNDING * largest;
    !right.iter().zip(wrong).all(is_same)
}

/// Asserts that tests catch the mutants that change a value, and blame none that changes nothing.
#[expect(
    clippy::print_stdout,
    reason = "which mutants change nothing, and which tests catch the others"
)]
fn assert_caught(module: &Module) {
    assert_eq!(failing(module.tests), [""; 0], "the module as it is");
    let (harmful, harmless): (Vec<&Mutant>, Vec<&Mutant>) = module
        .mutants
        .iter()
        .partition(|mutant| !changed(module, mutant).is_empty());
    for mutant in &harmless {
        println!("changes nothing: {}", mutant.line);
        assert_eq!(failing(mutant.tests), [""; 0], "{}", mutant.line);
    }
    assert!(
        harmful.len() >= LEAST,
        "{} mutants change a value",
        harmful.len()
    );
    let mut missed = Vec::new();
    for mutant in &harmful {
        let failing = failing(mutant.tests);
        println!("{}: {}", mutant.line, failing.join(", "));
        if failing.is_empty() {
            missed.push(mutant.line);
        }
    }
    assert_eq!(missed, [""; 0], "not caught");
}

macro_rules! tests {
    ($($name:ident of $module:ident;)+) => {$(
        #[test]
        fn $name() {
            assert_caught(&$module);
        }
    )+};
}

tests! {
    mutants_of_a_cart_with_a_pole_are_caught of CART_POLE;
    mutants_of_a_double_pendulum_are_caught of DOUBLE_PENDULUM;
    mutants_of_an_arm_of_six_joints_are_caught of UR5;
    mutants_of_an_arm_of_seven_joints_are_caught of PANDA;
    mutants_of_eight_free_bodies_are_caught of EIGHT_BODY;
}
