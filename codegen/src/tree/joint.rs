//! A joint: which of a body's relative coordinates are free, and what they are called in `q` and `u`.

use crate::geometry::Rotation;
use crate::id::{CoordinateId, SpeedId};
use crate::tree::mechanics::Mechanics;
use crate::tree::offset::Offset;

/// The joint of a body with its lower body: an orientation and three translations between two constant frames.
#[derive(Clone, Debug)]
pub struct Joint {
    /// The joint's own name, as the user wrote it; the body's where it has none.
    pub name: String,
    /// What stands before the names of its coordinates: lower snake case, unique.
    pub identifier: String,
    /// True where the joint has a name of its own, which is then that of its coordinate if it has only one.
    pub is_named: bool,
    /// `A_K`: from the lower body's axes to those of the joint in the lower body.
    pub rotation: Rotation,
    /// q'_K: from the lower body's origin to where the joint sits, lower-body components, m.
    pub attachment: Offset,
    /// How the body is turned relative to the joint's axes in the lower body.
    pub orientation: Orientation,
    /// `s_1`, `s_2`, `s_3`, m: translation of the body's origin along the joint's axes in the lower body.
    pub translations: [Coordinate; 3],
    /// Springs, dampers, rotors and limits of the six motions: about, then along the three axes.
    pub mechanics: [Mechanics; 6],
}

/// How a body is turned relative to its joint's axes in the lower body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Orientation {
    /// By 1-2-3 body-fixed angles `theta_1`, `theta_2`, `theta_3`, rad, whose rates are the speeds, Eq. (44).
    Rates([Coordinate; 3]),
    /// By three free angles or Euler parameters; the speeds are components of the relative angular velocity along the
    /// body's axes, rad/s, Eq. (8).
    AngularVelocity {
        /// The coordinates.
        chart: ChartCoordinates,
        /// `w_1`, `w_2`, `w_3`.
        speeds: [SpeedId; 3],
    },
}

/// Coordinates of an orientation that is free in all directions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ChartCoordinates {
    /// The three angles; singular at `cos(theta_2) = 0`.
    Angles([CoordinateId; 3]),
    /// Euler parameters, a unit quaternion: `e_0` is the scalar; `JR_K = C(e)^T` with Hamilton's product.
    EulerParameters([CoordinateId; 4]),
}

/// What an orientation is a function of, whatever its speeds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Attitude {
    /// 1-2-3 body-fixed angles. Where the speeds are components of an angular velocity, each angle bears the one of its place, which
    /// is not its rate.
    Angles([Coordinate; 3]),
    /// Euler parameters.
    EulerParameters([CoordinateId; 4]),
}

/// One of the six relative coordinates of a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Coordinate {
    /// Free to move, with its places in `q` and `u`.
    Free {
        /// The place in `q`.
        coordinate: CoordinateId,
        /// The place in `u`: the speed is the coordinate's rate, Eq. (44).
        speed: SpeedId,
    },
    /// Follows the coordinate of another joint: `multiplier` times that one plus `offset`.
    Mimic {
        /// The other's place in `q`.
        coordinate: CoordinateId,
        /// The other's place in `u`.
        speed: SpeedId,
        /// Times the other; not zero.
        multiplier: f64,
        /// Plus, rad or m.
        offset: f64,
    },
    /// Held at a constant value, rad or m.
    Locked(f64),
}

/// What one of a joint's own coordinates is, with its number, from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum CoordinateKind {
    /// `theta_1`, `theta_2` or `theta_3`, rad.
    Angle(usize),
    /// `e_0` to `e_3`.
    EulerParameter(usize),
    /// `s_1`, `s_2` or `s_3`, m.
    Translation(usize),
}

impl CoordinateKind {
    /// What it is called within the joint: `theta1`, `e0`, `s3`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Angle(i) => ["theta1", "theta2", "theta3"][i],
            Self::EulerParameter(i) => ["e0", "e1", "e2", "e3"][i],
            Self::Translation(i) => ["s1", "s2", "s3"][i],
        }
    }

    /// The units: of angles, of translations, of Euler parameters.
    pub const UNITS: [&'static str; 3] = ["rad", "m", "1"];

    /// Its own of these.
    pub fn unit(self) -> &'static str {
        let [angle, translation, parameter] = Self::UNITS;
        match self {
            Self::Angle(_) => angle,
            Self::EulerParameter(_) => parameter,
            Self::Translation(_) => translation,
        }
    }

    /// True for a length.
    pub fn is_translation(self) -> bool {
        match self {
            Self::Angle(_) | Self::EulerParameter(_) => false,
            Self::Translation(_) => true,
        }
    }
}

/// What a speed does to a relative motion: the motion's own speed is `factor` times it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion {
    /// The speed.
    pub speed: SpeedId,
    /// One, but for a coordinate that follows another.
    pub factor: f64,
}

impl Joint {
    /// What the orientation is a function of.
    pub fn attitude(&self) -> Attitude {
        match self.orientation {
            Orientation::Rates(angles) => Attitude::Angles(angles),
            Orientation::AngularVelocity { chart, speeds } => match chart {
                ChartCoordinates::Angles(angles) => {
                    Attitude::Angles(std::array::from_fn(|i| Coordinate::Free {
                        coordinate: angles[i],
                        speed: speeds[i],
                    }))
                }
                ChartCoordinates::EulerParameters(parameters) => {
                    Attitude::EulerParameters(parameters)
                }
            },
        }
    }

    /// The angles, where the orientation is a function of them.
    pub fn angles(&self) -> Option<[Coordinate; 3]> {
        match self.attitude() {
            Attitude::Angles(angles) => Some(angles),
            Attitude::EulerParameters(_) => None,
        }
    }

    /// The Euler parameters, where the orientation is a function of them.
    pub fn euler_parameters(&self) -> Option<[CoordinateId; 4]> {
        match self.attitude() {
            Attitude::Angles(_) => None,
            Attitude::EulerParameters(parameters) => Some(parameters),
        }
    }

    /// The angles whose rates are the speeds; `None` where components of the angular velocity are.
    pub fn angles_with_rates(&self) -> Option<[Coordinate; 3]> {
        match self.orientation {
            Orientation::Rates(angles) => Some(angles),
            Orientation::AngularVelocity { .. } => None,
        }
    }

    /// The speeds that are components of the relative angular velocity, where they are.
    pub fn angular_velocity(&self) -> Option<[SpeedId; 3]> {
        match self.orientation {
            Orientation::Rates(_) => None,
            Orientation::AngularVelocity { speeds, .. } => Some(speeds),
        }
    }

    /// The motions about the three axes.
    pub fn turns(&self) -> [Option<Motion>; 3] {
        match self.orientation {
            Orientation::Rates(angles) => angles.map(Coordinate::motion),
            Orientation::AngularVelocity { speeds, .. } => {
                speeds.map(|speed| Some(Motion { speed, factor: 1.0 }))
            }
        }
    }

    /// The motions along the three axes.
    pub fn shifts(&self) -> [Option<Motion>; 3] {
        self.translations.map(Coordinate::motion)
    }

    /// The six motions: about, then along the three axes.
    pub fn motions(&self) -> [Option<Motion>; 6] {
        let ([a, b, c], [d, e, f]) = (self.turns(), self.shifts());
        [a, b, c, d, e, f]
    }

    /// What the six motions are called: `theta1` or `w1`, to `s3`.
    pub fn motion_names(&self) -> [&'static str; 6] {
        match self.orientation {
            Orientation::Rates(_) => ["theta1", "theta2", "theta3", "s1", "s2", "s3"],
            Orientation::AngularVelocity { .. } => ["w1", "w2", "w3", "s1", "s2", "s3"],
        }
    }

    /// The coordinates that are the joint's own, with what they are: angles or Euler parameters, then translations.
    pub fn coordinates(&self) -> Vec<(CoordinateKind, CoordinateId)> {
        let own = |kind: fn(usize) -> CoordinateKind, coordinates: [Coordinate; 3]| {
            let own = coordinates.into_iter().enumerate();
            own.filter_map(move |(i, own)| Some((kind(i), own.place()?)))
        };
        let mut coordinates = Vec::new();
        match self.attitude() {
            Attitude::Angles(angles) => coordinates.extend(own(CoordinateKind::Angle, angles)),
            Attitude::EulerParameters(parameters) => {
                let parameters = parameters.into_iter().enumerate();
                let parameters =
                    parameters.map(|(i, own)| (CoordinateKind::EulerParameter(i), own));
                coordinates.extend(parameters);
            }
        }
        coordinates.extend(own(CoordinateKind::Translation, self.translations));
        coordinates
    }

    /// The name of its coordinate or component of an angular velocity called `kind`: the joint's own name where it has one
    /// and only this.
    pub fn name_of(&self, kind: &str, is_only: bool) -> String {
        if self.is_named && is_only {
            self.identifier.clone()
        } else {
            format!("{}_{kind}", self.identifier)
        }
    }

    /// The speeds that are the joint's own, each with the place of its motion among the six.
    pub fn speeds(&self) -> Vec<(usize, SpeedId)> {
        let is_own = |place: &usize| match self.orientation {
            Orientation::Rates(angles) if *place < 3 => angles[*place].is_free(),
            Orientation::AngularVelocity { .. } if *place < 3 => true,
            _ => self.translations[*place - 3].is_free(),
        };
        let motions = self.motions();
        (0..6)
            .filter(is_own)
            .filter_map(|place| Some((place, motions[place]?.speed)))
            .collect()
    }

    /// The coordinate whose rate is this motion; `None` for a component of an angular velocity.
    pub fn coordinate_of(&self, motion: usize) -> Option<Coordinate> {
        match (self.orientation, motion) {
            (Orientation::Rates(angles), 0..3) => Some(angles[motion]),
            (Orientation::AngularVelocity { .. }, 0..3) => None,
            _ => Some(self.translations[motion - 3]),
        }
    }

    /// True where `theta_1` and `theta_3` are both free: the angles are then singular at `cos(theta_2) = 0`.
    pub fn has_singular_chart(&self) -> bool {
        self.angles()
            .is_some_and(|angles| angles[0].motion().is_some() && angles[2].motion().is_some())
    }
}

impl Coordinate {
    /// True for a coordinate with a place of its own in `q`.
    pub fn is_free(self) -> bool {
        matches!(self, Self::Free { .. })
    }

    /// Its own place in `q`.
    fn place(self) -> Option<CoordinateId> {
        match self {
            Self::Free { coordinate, .. } => Some(coordinate),
            Self::Mimic { .. } | Self::Locked(_) => None,
        }
    }

    /// The speed that moves it, if any does.
    pub fn motion(self) -> Option<Motion> {
        match self {
            Self::Free { speed, .. } => Some(Motion { speed, factor: 1.0 }),
            Self::Mimic {
                speed, multiplier, ..
            } => Some(Motion {
                speed,
                factor: multiplier,
            }),
            Self::Locked(_) => None,
        }
    }
}
