//! Generated modules, each with copies of which one token is changed, and the tests beside it.

#![allow(
    clippy::all,
    clippy::pedantic,
    clippy::restriction,
    missing_docs,
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

/// `SplitMix64`.
#[derive(Debug)]
pub struct Random(pub u64);

impl Random {
    /// Between -1 and 1.
    fn number(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut word = self.0;
        word = (word ^ (word >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        word = (word ^ (word >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (word ^ (word >> 31)) as f64 / 2_f64.powi(63) - 1.0
    }
}

/// What functions read and write: numbers in some shape.
trait Numbers {
    fn draw(random: &mut Random) -> Self;
    fn list(&self, numbers: &mut Vec<f64>);
}

impl Numbers for f64 {
    fn draw(random: &mut Random) -> Self {
        random.number()
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
