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
    /// That of one value.
    Single(&'static str),
    /// By the speed to which an entry belongs.
    BySpeed(BySpeed),
    /// By the two speeds to which an entry belongs: of angles, of an angle and a translation, of translations.
    ByTwoSpeeds([&'static [&'static str]; 3]),
    /// By the coordinate to which an entry belongs: an angle, a translation, a part of a quaternion.
    ByCoordinate([&'static str; 3]),
    /// Of each pair the quotient.
    Quotients(Vec<(Unit, Unit)>),
}

impl Unit {
    /// None that is known.
    pub const UNKNOWN: Self = Self::Of(&[]);
    /// No unit.
    pub(super) const ONE: Self = Self::Of(&["1"]);
    /// Of a mass matrix.
    pub(super) const MASS_MATRIX: Self = Self::ByTwoSpeeds([&["kg m^2"], &["kg m"], &["kg"]]);
    /// Of the inverse of a mass matrix.
    pub(super) const MASS_MATRIX_INVERSE: Self =
        Self::ByTwoSpeeds([&["1/(kg m^2)"], &["1/(kg m)"], &["1/kg"]]);
    /// Of the factors of a mass matrix.
    pub(super) const MASS_MATRIX_FACTORS: Self =
        Self::ByTwoSpeeds([&["kg m^2", "1"], &["m", "1/m"], &["kg", "1"]]);
    /// How fast a mass matrix changes.
    pub(super) const MASS_MATRIX_DOT: Self =
        Self::ByTwoSpeeds([&["kg m^2/s"], &["kg m/s"], &["kg/s"]]);
    /// Of coordinates.
    pub(super) const COORDINATES: Self = Self::ByCoordinate(CoordinateKind::UNITS);
    /// Of speeds.
    pub(crate) const SPEEDS: Self = Self::BySpeed(SPEED);
    /// Of their rates.
    pub(super) const ACCELERATIONS: Self = Self::BySpeed(ACCELERATION);
    /// Of generalized forces.
    pub(crate) const FORCES: Self = Self::BySpeed(FORCE);
    /// Of changes of coordinates along the motions of the speeds.
    pub(crate) const DIRECTIONS: Self = Self::BySpeed(["rad", "m"]);

    /// All of them, each once; empty where none is known.
    pub fn all(&self) -> Vec<String> {
        self.among(&CoordinateKind::UNITS, &SPEED)
    }

    /// Those of [`Self::all`] that there are where coordinates and speeds have these units.
    pub fn among(&self, coordinates: &[&str], speeds: &[&str]) -> Vec<String> {
        let [turns, shifts] = SPEED.map(|unit| speeds.contains(&unit));
        let both = turns && shifts;
        match self {
            Self::Of(all) => unique(all.iter().copied()),
            Self::Single(unit) => unique([*unit]),
            Self::BySpeed(all) => unique(kept(all, [turns, shifts]).copied()),
            Self::ByTwoSpeeds(all) => {
                unique(kept(all, [turns, both, shifts]).copied().flatten().copied())
            }
            Self::ByCoordinate(all) => {
                let there_is = CoordinateKind::UNITS.map(|unit| coordinates.contains(&unit));
                unique(kept(all, there_is).copied())
            }
            Self::Quotients(pairs) => {
                let mut found = Vec::new();
                for (of, by) in pairs {
                    let by = by.among(coordinates, speeds);
                    for of in of.among(coordinates, speeds) {
                        found.extend(by.iter().map(|by| quotient(&of, by)));
                    }
                }
                unique(found)
            }
        }
    }

    /// In words; empty where none is known, and where entries have none.
    pub fn text(&self) -> String {
        if let Self::BySpeed([turn, shift]) = self {
            return format!("{turn} for an angle's speed, {shift} for a translation's");
        }
        self.in_words(&self.all())
    }

    /// Those of its units that there are, in words; empty where none is known, and where entries have none.
    pub(super) fn in_words(&self, there_are: &[String]) -> String {
        match (self, there_are) {
            (Self::ByCoordinate([.., quaternion]), [others @ .., last])
                if last == quaternion && !others.is_empty() =>
            {
                format!("{}; {quaternion} in quaternions", others.join(" and "))
            }
            (_, [one]) if one == "1" => String::new(),
            (_, [one, other]) => format!("{one} and {other}"),
            (_, all) => all.join(", "),
        }
    }

    /// Those of derivatives of the first of these by the second.
    pub(crate) fn quotients<'a>(pairs: impl IntoIterator<Item = (&'a Self, &'a Self)>) -> Self {
        let pairs = pairs.into_iter();
        Self::Quotients(pairs.map(|(of, by)| (of.clone(), by.clone())).collect())
    }
}

/// Those that there are.
fn kept<T, const N: usize>(all: &[T; N], there_are: [bool; N]) -> impl Iterator<Item = &T> {
    let all = all.iter().zip(there_are);
    all.filter_map(|(one, there_is)| there_is.then_some(one))
}

/// Each once, in the order in which they first stand.
fn unique(all: impl IntoIterator<Item = impl Into<String>>) -> Vec<String> {
    let mut known: Vec<String> = Vec::new();
    for own in all.into_iter().map(Into::into) {
        if !known.contains(&own) {
            known.push(own);
        }
    }
    known
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
