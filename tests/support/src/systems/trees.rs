//! The trees on which promises about generated code are tried: for every promise the same ones. And how many random trees
//! tests that start no compiler try.

use std::ops::RangeInclusive;

use super::system::{RandomSystem, Sizes, Style};

/// The least number of the trees, which are numbered from here on.
const FIRST: u64 = 3000;

/// How many trees are compiled: what the variable `KANE_TREES` says, or else a few.
#[expect(
    clippy::disallowed_methods,
    reason = "how much is tested is the tester's choice"
)]
pub fn count(few: u64) -> u64 {
    let asked = std::env::var("KANE_TREES");
    asked.map_or(few, |number| {
        number.parse().expect("`KANE_TREES` is a number")
    })
}

/// True where the variable `KANE_ALL_SEEDS` is set, as in CI.
pub fn all_seeds() -> bool {
    std::env::var_os("KANE_ALL_SEEDS").is_some_and(|value| !value.is_empty())
}

/// Tells cargo, from a build script, to compile all systems where the variable `KANE_ALL_SEEDS` is set: with the condition
/// `every_system`, which is false of ordinary runs.
#[expect(clippy::print_stdout, reason = "cargo reads what build scripts print")]
pub fn announce_all_seeds() {
    println!("cargo::rerun-if-env-changed=KANE_ALL_SEEDS");
    println!("cargo::rustc-check-cfg=cfg(every_system)");
    if all_seeds() {
        println!("cargo::rustc-cfg=every_system");
    }
}

/// A third of a number, and all of it where the variable `KANE_ALL_SEEDS` is set.
pub fn share(number: u64) -> u64 {
    if all_seeds() { number } else { number / 3 }
}

/// How many of the trees that are tried there are at least of a kind: a quarter of the number among all, for some thirds
/// have fewer than their share.
pub fn least(number: u64) -> u64 {
    if all_seeds() { number } else { number / 4 }
}

/// The seeds of the random trees that are tried: the first third, and all where the variable `KANE_ALL_SEEDS` is set.
pub fn tried(seeds: RangeInclusive<u64>) -> RangeInclusive<u64> {
    let number = seeds.end() - seeds.start() + 1;
    let first = *seeds.start();
    first..=first + share(number) - 1
}

/// The first trees. They have 2 to 10 bodies, and every other one joints of every kind.
pub fn first(count: u64) -> impl Iterator<Item = RandomSystem> {
    (0..count).map(|place| {
        let style = [Style::Plain, Style::Framed][usize::from(place % 2 == 1)];
        let bodies = 2 + usize::try_from(place % 9).expect("a remainder is small");
        let sizes = Sizes {
            bodies,
            speeds: 3 * bodies,
        };
        RandomSystem::new(FIRST + place, sizes, style)
    })
}
