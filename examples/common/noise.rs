//! Noise of what is measured, and chance; for several examples.

/// Numbers that nobody foresees, but for being the same in every run.
#[derive(Clone, Copy, Debug)]
pub struct Noise(u64);

impl Noise {
    /// Those of a seed.
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// Even from 0 to 1.
    pub fn even(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Of standard deviation one: the sum of twelve even numbers, nearly normal.
    pub fn normal(&mut self) -> f64 {
        (0..12).map(|_| self.even()).sum::<f64>() - 6.0
    }
}
