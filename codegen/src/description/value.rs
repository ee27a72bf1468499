//! Values as the user wrote them: with their places, in their binding times, and for which coordinates they stand.

use crate::description::coordinate_name::CoordinateName;
use crate::diagnostic::Spanned;

/// A value with its place; `None` where the file holds none that can be used, which is then among the faults.
pub type Given<T> = Option<Spanned<T>>;

/// A value that may be absent: `None` where it is, or where what is written cannot be used, which is then a fault.
pub type Optional<T> = Option<Spanned<T>>;

/// A number in one of its binding times.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Scalar {
    /// Baked into the generated code.
    Baked(f64),
    /// Set by the user at run time; this is its nominal value.
    Runtime(f64),
}

impl Scalar {
    /// The number itself, or its nominal value.
    pub fn nominal(self) -> f64 {
        match self {
            Self::Baked(number) | Self::Runtime(number) => number,
        }
    }
}

/// A quantity of a joint's free coordinates.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum PerCoordinate<T> {
    /// None is given.
    #[default]
    Absent,
    /// One for every free coordinate.
    Same(Spanned<T>),
    /// One for each of these coordinates.
    Each(Vec<(Spanned<CoordinateName>, Spanned<T>)>),
}

impl<T: Copy> PerCoordinate<T> {
    /// What is given for one of the six coordinates.
    pub fn at(&self, coordinate: usize) -> Option<T> {
        match self {
            Self::Absent => None,
            Self::Same(value) => Some(value.value),
            Self::Each(values) => {
                let mut values = values.iter();
                let own = values.find(|(name, _)| name.value.index() == coordinate);
                own.map(|(_, value)| value.value)
            }
        }
    }
}

/// Limits of a coordinate; what is absent is unlimited.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Limits {
    /// The least value, rad, m.
    pub lower: Optional<f64>,
    /// The greatest value, rad, m.
    pub upper: Optional<f64>,
    /// The greatest speed, rad/s, m/s.
    pub velocity: Optional<f64>,
    /// The greatest force, N m, N.
    pub effort: Optional<f64>,
}
