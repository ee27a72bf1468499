//! A joint whose motions are about and along coordinate axes.

use crate::description::{Chart, Speeds};
use crate::diagnostic::Span;
use crate::geometry::Rotation;

/// A joint whose motions are about and along coordinate axes.
#[derive(Clone, Debug)]
pub(crate) struct ResolvedJoint {
    /// From the joint's axes, as written, to those of its coordinates.
    pub(crate) align: Rotation,
    /// The six motions: about, then along the three axes.
    pub(crate) motions: [Freedom; 6],
    /// How the orientation is described.
    pub(crate) chart: Chart,
    /// What its speeds are.
    pub(crate) speeds: Speeds,
    /// What stands before the names of its coordinates.
    pub(crate) identifier: String,
    /// The place of its only free motion, as it is written: what others can follow, also where it is then held.
    pub(crate) leading: Option<usize>,
}

/// Whether a motion is free.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Freedom {
    /// It is, as is written here.
    Free(Span),
    /// It is `multiplier` times that motion of that body (a place in the user's list), plus `offset`.
    Follows {
        /// The other body's place in the user's list.
        body: usize,
        /// The place among its six motions.
        motion: usize,
        /// Times the other.
        multiplier: f64,
        /// Plus, rad or m.
        offset: f64,
        /// Where its joint is written.
        span: Span,
    },
    /// It is held at this value, rad or m.
    Locked(f64),
}

impl ResolvedJoint {
    /// The places of the free motions.
    pub(crate) fn free(&self) -> impl Iterator<Item = usize> + '_ {
        (0..6).filter(|motion| matches!(self.motions[*motion], Freedom::Free(_)))
    }

    /// The same joint, with what each of its motions, by its place, becomes.
    pub(crate) fn with_motions(self, becomes: impl Fn(usize, Freedom) -> Freedom) -> Self {
        let motions = std::array::from_fn(|motion| becomes(motion, self.motions[motion]));
        Self { motions, ..self }
    }

    /// True where nothing moves: the body is part of its lower body.
    pub(crate) fn is_fixed(&self) -> bool {
        self.motions
            .iter()
            .all(|motion| matches!(motion, Freedom::Locked(_)))
    }

    /// The values of the three angles, or of the three translations; zero where they are free.
    pub(crate) fn locked(&self, first: usize) -> [f64; 3] {
        std::array::from_fn(|i| match self.motions[first + i] {
            Freedom::Locked(value) => value,
            Freedom::Free(_) | Freedom::Follows { .. } => 0.0,
        })
    }

    /// True where a motion follows another.
    pub(crate) fn follows(&self) -> bool {
        let mut motions = self.motions.iter();
        motions.any(|motion| matches!(motion, Freedom::Follows { .. }))
    }

    /// True for a joint that turns in every direction and whose speeds are no rates.
    pub(crate) fn has_angular_velocity(&self) -> bool {
        self.speeds == Speeds::AngularVelocity
    }
}
