//! The places of coordinates in `q` and of speeds in `u`.

use crate::id::{BodyId, CoordinateId, SpeedId};
use crate::tree::joints::resolve::{Freedom, Resolved};
use crate::tree::{Body, ChartCoordinates, Coordinate, Order, Orientation};

/// How many there are, or where the next one goes.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Numbers {
    pub(crate) coordinates: usize,
    pub(crate) speeds: usize,
}

impl Numbers {
    fn coordinate(&mut self) -> CoordinateId {
        self.coordinates += 1;
        CoordinateId::new(self.coordinates - 1)
    }

    fn speed(&mut self) -> SpeedId {
        self.speeds += 1;
        SpeedId::new(self.speeds - 1)
    }

    fn free(&mut self, coordinates: &mut [Coordinate; 3]) {
        for free in coordinates.iter_mut().filter(|free| free.is_free()) {
            *free = Coordinate::Free {
                coordinate: self.coordinate(),
                speed: self.speed(),
            };
        }
    }

    fn orientation(&mut self, orientation: &mut Orientation) {
        match orientation {
            Orientation::Rates(angles) => self.free(angles),
            Orientation::AngularVelocity { chart, speeds } => {
                match chart {
                    ChartCoordinates::Angles(angles) => angles.fill_with(|| self.coordinate()),
                    ChartCoordinates::EulerParameters(parameters) => {
                        parameters.fill_with(|| self.coordinate());
                    }
                }
                speeds.fill_with(|| self.speed());
            }
        }
    }
}

/// Numbers all free coordinates and their speeds; the result is how many there are.
pub(crate) fn number(bodies: &mut [Body], order: Order) -> Numbers {
    let mut next = Numbers::default();
    match order {
        Order::Body => {
            for body in bodies {
                next.orientation(&mut body.joint.orientation);
                next.free(&mut body.joint.translations);
            }
        }
        Order::Notes => {
            for body in bodies.iter_mut() {
                next.orientation(&mut body.joint.orientation);
            }
            for body in bodies {
                next.free(&mut body.joint.translations);
            }
        }
    }
    next
}

/// Gives the coordinates that follow others the places of those; `host` is the body in which a written one is.
pub(crate) fn follow(
    bodies: &mut [Body],
    joints: &[Resolved],
    host: &dyn Fn(usize) -> Option<BodyId>,
) {
    for place in 0..bodies.len() {
        let joint = &joints[bodies[place].user_number - 1];
        for motion in 0..6 {
            let Freedom::Follows {
                body: leader,
                motion: leading,
                multiplier,
                offset,
                ..
            } = joint.motions[motion]
            else {
                continue;
            };
            let leader = host(leader).map(|leader| &bodies[leader.index()].joint);
            let leader = leader.and_then(|leader| leader.coordinate_of(leading));
            let Some(Coordinate::Free { coordinate, speed }) = leader else {
                unreachable!("mimic: what is followed is a free coordinate with a rate")
            };
            let follower = Coordinate::Mimic {
                coordinate,
                speed,
                multiplier,
                offset,
            };
            let own = &mut bodies[place].joint;
            match (&mut own.orientation, motion) {
                (Orientation::Rates(angles), 0..3) => angles[motion] = follower,
                _ => own.translations[motion - 3] = follower,
            }
        }
    }
}
