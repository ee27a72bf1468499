//! Noise of what is measured.

/// Numbers of standard deviation one that nobody foresees, but for being the same in every run.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Noise(u64);

impl Noise {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// The sum of twelve even numbers, nearly normal.
    pub(crate) fn next(&mut self) -> f64 {
        let even = (0..12).map(|_| {
            self.0 = self
                .0
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (self.0 >> 11) as f64 / (1_u64 << 53) as f64
        });
        even.sum::<f64>() - 6.0
    }
}
