//! What the runtime's tests share: a seeded generator, and systems small enough to write by hand.

#![allow(
    dead_code,
    unused_imports,
    reason = "each test program uses its own part of this module"
)]

mod cart_pole;
mod gimbal;
mod oscillator;
mod pendulum;

pub(crate) use cart_pole::CartPole;
pub(crate) use gimbal::Gimbal;
pub(crate) use oscillator::Oscillator;
pub(crate) use pendulum::Pendulum;

/// Seeded pseudo-random numbers (Steele, Lea & Flood 2014: `SplitMix64`).
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Uniform in [-1, 1).
    pub(crate) fn number(&mut self) -> f64 {
        let unit = (self.bits() >> 11) as f64 / (1_u64 << 53) as f64;
        2.0 * unit - 1.0
    }
}
