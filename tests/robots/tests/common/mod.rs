//! What the tests of this package share.

pub(crate) mod mass;
pub(crate) mod motion;
pub(crate) mod reference;

use std::collections::BTreeMap;

use kane_test_robots::{Compiled, ROBOTS, Robot};
use kane_test_support::numeric::dot;

/// The robot with this name.
pub(crate) fn robot(name: &str) -> Compiled {
    ROBOTS
        .into_iter()
        .find(|robot| robot.name == name)
        .expect("it is compiled")
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
