//! What the tests of this package share.
#![allow(dead_code, reason = "each test file uses its part of these")]

pub(crate) mod mass;
pub(crate) mod motion;
#[path = "../../../../codegen/tests/dynamics/numeric.rs"]
pub(crate) mod numeric;
pub(crate) mod reference;

use std::collections::BTreeMap;

use kane_test_robots::{Compiled, ROBOTS, Robot};
use numeric::dot;

/// The robot with this name.
pub(crate) fn robot(name: &str) -> Compiled {
    ROBOTS
        .into_iter()
        .find(|robot| robot.name == name)
        .expect("it is compiled")
}

/// The largest errors found, by quantity.
#[derive(Debug, Default)]
pub(crate) struct Errors {
    pub(crate) largest: BTreeMap<&'static str, f64>,
}

impl Errors {
    /// Requires an error to be within its tolerance.
    pub(crate) fn add(&mut self, what: &'static str, error: f64, tolerance: f64) {
        assert!(
            error <= tolerance,
            "{what}: off by {error:e}, {tolerance:e} allowed"
        );
        let largest = self.largest.entry(what).or_default();
        *largest = largest.max(error);
    }

    /// Shows them under a title.
    #[expect(clippy::print_stdout, reason = "shown with --nocapture")]
    pub(crate) fn show(&self, title: &str) {
        let errors = self
            .largest
            .iter()
            .map(|(what, error)| format!("\n    {what}: {error:.1e}"));
        println!("{title}{}", errors.collect::<String>());
    }
}

/// Rotation of a link and position of its origin, both in inertial components.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Placement {
    /// Link components to inertial ones.
    pub(crate) rotation: [[f64; 3]; 3],
    /// The origin.
    pub(crate) origin: [f64; 3],
}

/// Where every body is, then everything that is fixed to one, by name.
pub(crate) fn placements(robot: &dyn Robot, q: &[f64]) -> BTreeMap<&'static str, Placement> {
    let (rotations, origins) = (robot.rotation(q), robot.origin_position(q));
    let mut placements = BTreeMap::new();
    for (body, name) in robot.body_names().iter().enumerate() {
        let rotation = transposed(&rotations[body]);
        let origin = times(&rotation, origins[body]);
        placements.insert(*name, Placement { rotation, origin });
    }
    for frame in robot.frames() {
        let rotation = transposed(&frame.rotation(&rotations));
        let origin = frame.position(&rotations, &origins);
        placements.insert(frame.name, Placement { rotation, origin });
    }
    placements
}

pub(crate) fn transposed(m: &[[f64; 3]; 3]) -> [[f64; 3]; 3] {
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| m[j][i]))
}

pub(crate) fn times(m: &[[f64; 3]; 3], v: [f64; 3]) -> [f64; 3] {
    m.map(|row| dot(&row, &v))
}

pub(crate) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// Numbers from -1 to 1 that look random, the same ones every time: splitmix64.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn number(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        bits ^= bits >> 31;
        (bits >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    pub(crate) fn numbers(&mut self, n: usize) -> Vec<f64> {
        (0..n).map(|_| self.number()).collect()
    }
}
