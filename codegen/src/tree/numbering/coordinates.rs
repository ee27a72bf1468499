//! The places of coordinates in `q` and of speeds in `u`.
//!
//! In: the joints of the bodies that move, outward. Out: the [`JointCoordinates`] of each. Afterwards: every free motion
//! has places of its own, and what follows another has that one's.

use std::collections::BTreeMap;

use crate::description::{Chart, Order};
use crate::id::{CoordinateId, SpeedId};
use crate::tree::joint::{ChartCoordinates, Coordinate, Orientation};
use crate::tree::joints::{Freedom, ResolvedJoint};

/// The coordinates and speeds of all joints.
pub(crate) struct Numbered {
    /// Of each body that moves, outward.
    pub(crate) joints: Vec<JointCoordinates>,
    /// The length of `q`.
    pub(crate) n_coordinates: usize,
    /// The length of `u`.
    pub(crate) n_speeds: usize,
}

/// The six motions of a joint, with their places.
#[derive(Clone, Copy, Debug)]
pub(crate) struct JointCoordinates {
    /// About the three axes.
    pub(crate) orientation: Orientation,
    /// Along the three axes.
    pub(crate) translations: [Coordinate; 3],
}

/// Numbers the free coordinates and speeds of the bodies that move; `moving` holds their places in the user's list.
pub(crate) fn number(joints: &[ResolvedJoint], moving: &[usize], order: Order) -> Numbered {
    let mut next = Next::default();
    let moving_joints = || moving.iter().map(|place| &joints[*place]);
    let (turns, shifts): (Vec<Turns>, Vec<[OwnMotion; 3]>) = match order {
        Order::Body => moving_joints()
            .map(|joint| (next.turns(joint), next.motions(joint, 3)))
            .unzip(),
        Order::Notes => {
            let turns = moving_joints().map(|joint| next.turns(joint)).collect();
            let shifts = moving_joints().map(|joint| next.motions(joint, 3));
            (turns, shifts.collect())
        }
    };
    let own: BTreeMap<usize, (&Turns, &[OwnMotion; 3])> = moving
        .iter()
        .copied()
        .zip(turns.iter().zip(&shifts))
        .collect();
    let coordinate = |motion: &OwnMotion| placed(motion, &own);
    let joints = turns
        .iter()
        .zip(&shifts)
        .map(|(turns, shifts)| JointCoordinates {
            orientation: match turns {
                Turns::Rates(angles) => Orientation::Rates(angles.each_ref().map(coordinate)),
                Turns::AngularVelocity { chart, speeds } => Orientation::AngularVelocity {
                    chart: *chart,
                    speeds: *speeds,
                },
            },
            translations: shifts.each_ref().map(coordinate),
        });
    Numbered {
        joints: joints.collect(),
        n_coordinates: next.coordinate,
        n_speeds: next.speed,
    }
}

/// A motion with its own places, if it is free; what it follows has not been looked up.
enum OwnMotion {
    Free(CoordinateId, SpeedId),
    Follows {
        /// The place of the other body in the user's list.
        body: usize,
        /// The place among its six motions.
        motion: usize,
        multiplier: f64,
        offset: f64,
    },
    Locked(f64),
}

/// The motions about the three axes.
enum Turns {
    Rates([OwnMotion; 3]),
    AngularVelocity {
        chart: ChartCoordinates,
        speeds: [SpeedId; 3],
    },
}

/// The motion as a coordinate, with the places of what it follows.
fn placed(motion: &OwnMotion, own: &BTreeMap<usize, (&Turns, &[OwnMotion; 3])>) -> Coordinate {
    match *motion {
        OwnMotion::Free(coordinate, speed) => Coordinate::Free { coordinate, speed },
        OwnMotion::Locked(value) => Coordinate::Locked(value),
        OwnMotion::Follows {
            body,
            motion,
            multiplier,
            offset,
        } => {
            let leader = match (own.get(&body), motion) {
                (Some((Turns::Rates(angles), _)), 0..3) => Some(&angles[motion]),
                (Some((_, shifts)), 3..) => Some(&shifts[motion - 3]),
                _ => None,
            };
            let Some(&OwnMotion::Free(coordinate, speed)) = leader else {
                unreachable!("mimic: what is followed is a free coordinate with a rate")
            };
            Coordinate::Mimic {
                coordinate,
                speed,
                multiplier,
                offset,
            }
        }
    }
}

/// Where the next coordinate and the next speed go.
#[derive(Default)]
struct Next {
    coordinate: usize,
    speed: usize,
}

impl Next {
    fn coordinate(&mut self) -> CoordinateId {
        self.coordinate += 1;
        CoordinateId::new(self.coordinate - 1)
    }

    fn speed(&mut self) -> SpeedId {
        self.speed += 1;
        SpeedId::new(self.speed - 1)
    }

    fn turns(&mut self, joint: &ResolvedJoint) -> Turns {
        if !joint.has_angular_velocity() {
            return Turns::Rates(self.motions(joint, 0));
        }
        let chart = match joint.chart {
            Chart::Angles => ChartCoordinates::Angles([(); 3].map(|()| self.coordinate())),
            Chart::Quaternion => {
                ChartCoordinates::EulerParameters([(); 4].map(|()| self.coordinate()))
            }
        };
        Turns::AngularVelocity {
            chart,
            speeds: [(); 3].map(|()| self.speed()),
        }
    }

    /// The three motions from the `first` on.
    fn motions(&mut self, joint: &ResolvedJoint, first: usize) -> [OwnMotion; 3] {
        [first, first + 1, first + 2].map(|motion| match joint.motions[motion] {
            Freedom::Free(_) => OwnMotion::Free(self.coordinate(), self.speed()),
            Freedom::Follows {
                body,
                motion,
                multiplier,
                offset,
                ..
            } => OwnMotion::Follows {
                body,
                motion,
                multiplier,
                offset,
            },
            Freedom::Locked(value) => OwnMotion::Locked(value),
        })
    }
}
