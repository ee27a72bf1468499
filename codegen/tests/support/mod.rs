//! Descriptions for tests, and seeded numbers.
#![allow(dead_code, reason = "each test file uses its part of these")]

use kane_codegen::description::toml;
use kane_codegen::diagnostic::{Diagnostics, Source};
use kane_codegen::tree::{self, Checked};

/// Reads and builds.
pub(crate) fn build(text: &str) -> Result<Checked, Diagnostics> {
    tree::build(&toml::parse(&Source::new("model.toml", text)))
}

/// The keys of a body of which nothing matters but its name and its joint.
pub(crate) fn body(name: &str, joint: &str) -> String {
    format!(
        "[[body]]
name = \"{name}\"
mass = 2.0
mass_center = [0.01, 0.02, -0.5]
inertia = {{ xx = 0.1, yy = 0.1, zz = 0.02, xy = 0.01, xz = 0.0, yz = 0.0 }}
attachment = [0.0, 0.1, 0.3]
joint = {joint}
"
    )
}

/// A system of such bodies.
pub(crate) fn system(lower_bodies: &str, bodies: &[(&str, &str)]) -> String {
    let bodies: Vec<String> = bodies
        .iter()
        .map(|(name, joint)| body(name, joint))
        .collect();
    format!(
        "name = \"system\"\nlower_bodies = {lower_bodies}\n\n{}",
        bodies.join("\n")
    )
}

/// Seeded numbers: splitmix64.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    /// A number below `end`.
    pub(crate) fn below(&mut self, end: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        usize::try_from((bits ^ (bits >> 31)) % end as u64).expect("it is below a usize")
    }

    /// A random order of these.
    pub(crate) fn shuffle<T>(&mut self, list: &mut [T]) {
        for last in (1..list.len()).rev() {
            list.swap(last, self.below(last + 1));
        }
    }
}
