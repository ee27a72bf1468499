//! The trees on which promises about generated code are tried: for every promise the same ones.

use super::system::{RandomSystem, Sizes, Style};

/// The least number of the trees, which are numbered from here on.
const FIRST: u64 = 3000;

/// How many trees are tried: what the variable `KANE_TREES` says, or else a few.
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
