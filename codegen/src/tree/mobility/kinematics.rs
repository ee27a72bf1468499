//! A joint at a state: the velocities that it gives its body.

use crate::geometry::{self, cross};
use crate::id::{BodyId, SpeedId};
use crate::tree::joint::{Attitude, Coordinate, Joint};
use crate::tree::mobility::rows::{Twist, dot, join};
use crate::tree::mobility::units::Units;
use crate::tree::system::Tree;

/// A joint at a state: lengths in units.
pub(crate) struct Kinematics {
    /// The twist of the body that a unit rate of each of the six motions gives it.
    pub(crate) columns: [Twist; 6],
    /// The twist of the body where that of the lower body is a unit: `carried[i]` for component `i`.
    pub(crate) carried: [Twist; 6],
    /// The distance between the two origins.
    pub(crate) lever: f64,
}

/// The joint of a body at a state; `value` gives angles in rad, and translations in units.
pub(crate) fn kinematics(
    tree: &Tree,
    units: &Units,
    body: BodyId,
    mut value: impl FnMut(Coordinate, bool) -> f64,
) -> Kinematics {
    let joint = &tree.body(body).joint;
    // Whatever describes an orientation, some angles lead to it.
    let angles = match joint.attitude() {
        Attitude::Angles(angles) => angles,
        Attitude::EulerParameters([coordinates @ .., _]) => {
            let speed = SpeedId::new(0);
            coordinates.map(|coordinate| Coordinate::Free { coordinate, speed })
        }
    };
    let angles = angles.map(|angle| value(angle, true));
    let shift = joint.translations.map(|shift| value(shift, false));
    let turned = geometry::body_fixed_123(angles);
    let whole = geometry::then(&joint.rotation, &turned);
    let [_, (s2, c2), (s3, c3)] = angles.map(|angle| (libm::sin(angle), libm::cos(angle)));
    // P_K by columns, Eq. (17).
    let turns = if joint.angles_with_rates().is_some() {
        [[c2 * c3, -c2 * s3, s2], [s3, c3, 0.0], [0.0, 0.0, 1.0]]
    } else {
        geometry::IDENTITY
    };
    let columns = std::array::from_fn(|motion| match motion {
        0..3 => join(turns[motion], [0.0; 3]),
        _ => join([0.0; 3], turned.map(|row| row[motion - 3])),
    });
    let attachment = joint.attachment.nominal(&tree.parameters);
    let shift = geometry::apply(&geometry::transposed(&joint.rotation), shift);
    let lever = std::array::from_fn(|i| attachment[i] / units.length + shift[i]);
    let mut carried = [[0.0; 6]; 6];
    for component in 0..3 {
        let mut unit = [0.0; 3];
        unit[component] = 1.0;
        let arm = geometry::apply(&whole, cross(unit, lever));
        let unit = geometry::apply(&whole, unit);
        carried[component] = join(unit, arm);
        carried[component + 3] = join([0.0; 3], unit);
    }
    Kinematics {
        columns,
        carried,
        lever: dot(&lever, &lever).sqrt(),
    }
}

/// The inertia of a motion's rotor.
pub(crate) fn rotor(tree: &Tree, units: &Units, joint: &Joint, motion: usize) -> f64 {
    let armature = tree.nominal(joint.mechanics[motion].armature) / units.mass;
    if motion < 3 {
        armature / units.length / units.length
    } else {
        armature
    }
}
