//! Seeded numbers (splitmix64), so that every run on every machine sees the same ones.

/// A sequence of them.
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed)
    }

    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        bits ^ (bits >> 31)
    }

    /// A count below another one, which is not zero.
    pub(crate) fn below(&mut self, count: usize) -> usize {
        usize::try_from(self.bits() % (count as u64)).expect("a remainder is small")
    }

    /// A number between -1 and 1.
    pub(crate) fn signed(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    /// Between a tenth and 1.2 in magnitude, with three digits: as angles, away from the singularity.
    pub(crate) fn number(&mut self) -> f64 {
        let bits = self.bits();
        let magnitude = thousandths(100 + (bits >> 1) % 1101);
        if bits & 1 == 0 { magnitude } else { -magnitude }
    }

    /// Between a tenth and 0.4, with three digits: a value that changes by this part of it is another, and near.
    pub(crate) fn part(&mut self) -> f64 {
        thousandths(100 + self.bits() % 301)
    }
}

fn thousandths(count: u64) -> f64 {
    f64::from(u32::try_from(count).expect("a remainder is small")) / 1000.0
}
