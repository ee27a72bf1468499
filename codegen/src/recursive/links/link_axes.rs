//! Along which axes a joint's motions are taken.
//!
//! Three angles turn a link about three axes of which only the last is its own; their accelerations are, but for the rates'
//! products, `P^-1` times an angular acceleration along its own axes, Eq. (9). Solving for the latter costs less: it enters
//! where it is, and what is known of the link alone stays constant. The same holds of three translations.

use std::collections::BTreeSet;

use crate::{
    id::{BodyMap, SpeedId},
    recursive::{plan::Plan, technique::Technique},
    tree::{Coordinate, Joint, Mechanics, Motion, Tree},
};

/// Which of a joint's motions are taken along the axes of its link: the others are about the angles' axes and along the
/// joint's.
#[derive(Clone, Copy, Debug)]
pub(in crate::recursive) struct LinkAxes {
    /// The three rotations: what stands in their places are components of the relative angular velocity.
    turns: bool,
    /// The three translations.
    shifts: bool,
}

impl LinkAxes {
    /// The motions as the speeds are.
    pub(in crate::recursive) fn of_speeds(joint: &Joint) -> Self {
        Self {
            turns: joint.angular_velocity().is_some(),
            shifts: false,
        }
    }

    /// The motions as they are solved for. Those of which some are prescribed are as the speeds.
    pub(in crate::recursive) fn of_solution(
        joint: &Joint,
        plan: &Plan,
        prescribed: &BTreeSet<SpeedId>,
    ) -> Self {
        if !plan.uses(Technique::LinkAxes) || is_any_among(&joint.motions(), prescribed) {
            return Self::of_speeds(joint);
        }
        let turns = joint
            .angles_with_rates()
            .is_none_or(|angles| are_free(angles) && !has_rotors(&joint.mechanics[..3]));
        let shifts = turns && are_free(joint.translations) && !has_rotors(&joint.mechanics[3..]);
        Self { turns, shifts }
    }

    /// The motions of a joint along its link's axes: about them, then along them, where they are taken so.
    pub(in crate::recursive) fn motions(self, joint: &Joint) -> [Option<[Motion; 3]>; 2] {
        let all = |motions: [Option<Motion>; 3]| {
            let [a, b, c] = motions;
            Some([a?, b?, c?])
        };
        [
            all(joint.turns()).filter(|_| self.turns),
            all(joint.shifts()).filter(|_| self.shifts),
        ]
    }

    /// True where translations are taken along the joint's axes, before it turns.
    pub(in crate::recursive) fn shift_before_turns(self) -> bool {
        !self.shifts
    }
}

/// The bodies that nothing holds or moves on the inertial frame, where the plan takes them to fall.
pub(in crate::recursive) fn falling(
    tree: &Tree,
    plan: &Plan,
    prescribed: &BTreeSet<SpeedId>,
) -> BodyMap<bool> {
    BodyMap::outward(tree.bodies.len(), |body, _| {
        let joint = &tree.body(body).joint;
        let is_moved = is_any_among(&joint.shifts(), prescribed);
        let is_loose = tree.lower(body).is_none() && are_free(joint.translations) && !is_moved;
        // A rotor does not fall.
        plan.uses(Technique::Fall) && is_loose && !has_rotors(&joint.mechanics[3..])
    })
}

fn is_any_among(motions: &[Option<Motion>], speeds: &BTreeSet<SpeedId>) -> bool {
    let mut motions = motions.iter().flatten();
    motions.any(|motion| speeds.contains(&motion.speed))
}

fn are_free(coordinates: [Coordinate; 3]) -> bool {
    coordinates.iter().all(|coordinate| coordinate.is_free())
}

/// A rotor acts on the rate of its own coordinate.
fn has_rotors(mechanics: &[Mechanics]) -> bool {
    mechanics.iter().any(Mechanics::has_rotor)
}
