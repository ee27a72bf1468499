//! Units of what functions are given and write. Documentation, headers and manifests say them from here alone.

use crate::tree::CoordinateKind;

/// What belongs to speeds has two units: one where the speed is that of an angle, another where it is that of a translation.
pub type BySpeed = [&'static str; 2];

/// Of speeds.
pub const SPEED: BySpeed = ["rad/s", "m/s"];
/// Of their rates.
pub(super) const ACCELERATION: BySpeed = ["rad/s^2", "m/s^2"];
/// Of generalized forces.
pub const FORCE: BySpeed = ["N m", "N"];
/// Of the motion of a point for a unit of a speed.
pub(super) const LEVER: BySpeed = ["m", "1"];
/// How fast that changes.
pub(super) const LEVER_DOT: BySpeed = ["m/s", "1/s"];
/// Of the turning of a frame for a unit of a speed.
pub(super) const TURNING: BySpeed = ["1", "1/m"];

/// The units of an array's entries.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Unit {
    /// All that entries have, each once; none where whoever calls decides, or where values set at run time do.
    Of(&'static [&'static str]),
    /// By the speed to which an entry belongs.
    BySpeed(BySpeed),
    /// By the coordinate to which an entry belongs: an angle, a translation, a part of a quaternion.
    ByCoordinate([&'static str; 3]),
    /// As [`Self::Of`], where they follow from a model or from others.
    Derived(Vec<String>),
}

impl Unit {
    /// None that is known.
    pub const UNKNOWN: Self = Self::Of(&[]);
    /// No unit.
    pub(super) const ONE: Self = Self::Of(&["1"]);
    /// Of a mass matrix.
    pub(super) const MASS_MATRIX: Self = Self::Of(&["kg m^2", "kg m", "kg"]);
    /// Of coordinates.
    pub(super) const COORDINATES: Self = Self::ByCoordinate(CoordinateKind::UNITS);

    /// All of them; empty where none is known.
    pub fn all(&self) -> Vec<&str> {
        match self {
            Self::Of(all) => all.to_vec(),
            Self::BySpeed(all) => all.to_vec(),
            Self::ByCoordinate(all) => all.to_vec(),
            Self::Derived(all) => all.iter().map(String::as_str).collect(),
        }
    }

    /// Those of [`Self::all`] that there are where coordinates and speeds have these units.
    pub fn among(&self, coordinates: &[&str], speeds: &[&str]) -> Vec<&str> {
        let (all, given, known) = match self {
            Self::ByCoordinate(_) => (self.all(), coordinates, &CoordinateKind::UNITS[..]),
            Self::BySpeed(_) => (self.all(), speeds, &SPEED[..]),
            Self::Of(_) | Self::Derived(_) => return self.all(),
        };
        let both = all.into_iter().zip(known);
        let found = both.filter(|(_, known)| given.contains(known));
        found.map(|(unit, _)| unit).collect()
    }

    /// In words; empty where none is known, and where entries have none.
    pub fn text(&self) -> String {
        match self {
            Self::BySpeed([turn, shift]) => {
                format!("{turn} for an angle's speed, {shift} for a translation's")
            }
            Self::ByCoordinate([angle, shift, quaternion]) => {
                format!("{angle} and {shift}; {quaternion} in quaternions")
            }
            Self::Of(_) | Self::Derived(_) => match &self.all()[..] {
                ["1"] => String::new(),
                [one, other] => format!("{one} and {other}"),
                all => all.join(", "),
            },
        }
    }

    /// Those of derivatives of the first of these by the second: of each pair the quotient, each once.
    pub(crate) fn quotients<'a>(pairs: impl IntoIterator<Item = (&'a Self, &'a Self)>) -> Self {
        let mut known: Vec<String> = Vec::new();
        for (of, by) in pairs {
            let of = of.all().into_iter();
            for one in of.flat_map(|of| by.all().into_iter().map(move |by| quotient(of, by))) {
                if !known.contains(&one) {
                    known.push(one);
                }
            }
        }
        Self::Derived(known)
    }
}

/// `N m/rad`, `(m/s)/rad`, `(rad/s^2)/(N m)`.
fn quotient(of: &str, by: &str) -> String {
    if by == "1" {
        return of.to_owned();
    }
    let of = if of.contains('/') {
        format!("({of})")
    } else {
        of.to_owned()
    };
    if by.contains(['/', ' ', '^']) {
        format!("{of}/({by})")
    } else {
        format!("{of}/{by}")
    }
}
