//! Generated modules, each with copies of which one token is changed, and the tests beside it.

#![allow(
    clippy::all,
    clippy::pedantic,
    clippy::restriction,
    missing_docs,
    unused_imports,
    unused_parens,
    unused_variables,
    dead_code,
    reason = "generated, and made wrong on purpose"
)]

/// The tests beside a module, with their names.
pub type Tests = &'static [(&'static str, fn() -> Result<(), kane::self_test::Mismatch>)];

/// The functions of a module, with their names: what each writes in the state and with the parameters that are drawn.
pub type Functions = &'static [(&'static str, fn(Random) -> Vec<f64>)];

/// A module as it is, and its mutants.
#[derive(Debug)]
pub struct Module {
    pub tests: Tests,
    pub functions: Functions,
    pub mutants: &'static [Mutant],
}

/// A module that is wrong in one place.
#[derive(Debug)]
pub struct Mutant {
    /// The line that is wrong.
    pub line: &'static str,
    pub tests: Tests,
    /// Of a large module the one that is wrong.
    pub functions: Functions,
}

pub use kane_test_support::random::Random;

/// What functions read and write: numbers in some shape.
trait Numbers {
    fn draw(random: &mut Random) -> Self;
    fn list(&self, numbers: &mut Vec<f64>);
}

impl Numbers for f64 {
    fn draw(random: &mut Random) -> Self {
        random.symmetric()
    }

    fn list(&self, numbers: &mut Vec<f64>) {
        numbers.push(*self);
    }
}

impl<T: Numbers, const N: usize> Numbers for [T; N] {
    fn draw(random: &mut Random) -> Self {
        [(); N].map(|()| T::draw(random))
    }

    fn list(&self, numbers: &mut Vec<f64>) {
        self.iter().for_each(|entry| entry.list(numbers));
    }
}

impl Numbers for kane::Load<f64> {
    fn draw(random: &mut Random) -> Self {
        let [force, moment] = Numbers::draw(random);
        Self { force, moment }
    }

    fn list(&self, numbers: &mut Vec<f64>) {
        [self.force, self.moment].list(numbers);
    }
}

include!(concat!(env!("OUT_DIR"), "/mutants.rs"));
