//! Arrays that functions are given and write: axes, each with a constant's name and a length, and what they are of.

use crate::tree::Tree;

/// The constant that holds the length of a packed mass matrix.
pub const PACKED_LEN: &str = "MASS_MATRIX_PACKED_LEN";
/// The constant that holds where its entries stand.
pub const PACKED_PLACES: &str = "MASS_MATRIX_PACKED_PLACES";

/// What an axis of an array counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// The components of a vector.
    Three,
    /// Coordinates.
    Coordinates,
    /// Speeds.
    Speeds,
    /// Every pair of [`Tree::coupled_speeds`].
    SpeedPairs,
    /// Bodies.
    Bodies,
    /// The columns of a compact output's non-zero partitions, with their pattern beside the function.
    Columns,
}

/// The axes of nested arrays, outermost first; none for one element. Row-major.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shape {
    /// The axes.
    pub axes: &'static [Axis],
}

/// What an array is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Element {
    /// A number.
    Scalar,
    /// The load on a body.
    Load,
    /// Values set at run time.
    Parameters,
    /// What depends on these alone.
    Prepared,
    /// Sines and cosines.
    SinCos,
}

/// The length of an array, as generated code names it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Length {
    /// The components of a vector.
    Three,
    /// A constant of the module: `NQ`.
    Constant(String),
}

impl Axis {
    /// How many there are of what it counts; `n_columns` is the number of a compact output's columns.
    pub fn length(self, tree: &Tree, n_columns: usize) -> usize {
        match self {
            Self::Three => 3,
            Self::Coordinates => tree.n_coordinates,
            Self::Speeds => tree.n_speeds,
            Self::SpeedPairs => tree.coupled_speeds().len(),
            Self::Bodies => tree.bodies.len(),
            Self::Columns => n_columns,
        }
    }

    /// Its length as generated code names it; `columns` names that of a compact output.
    fn declared(self, columns: impl FnOnce() -> String) -> Length {
        Length::Constant(match self {
            Self::Three => return Length::Three,
            Self::Coordinates => "NQ".to_owned(),
            Self::Speeds => "NU".to_owned(),
            Self::SpeedPairs => PACKED_LEN.to_owned(),
            Self::Bodies => "NB".to_owned(),
            Self::Columns => columns(),
        })
    }

    /// One of what it counts, in words.
    pub fn one(self) -> &'static str {
        match self {
            Self::Three => "an axis",
            Self::Coordinates => "a coordinate",
            Self::Speeds => "a speed",
            Self::SpeedPairs => "a pair of speeds",
            Self::Bodies => "a body",
            Self::Columns => "a column",
        }
    }
}

impl Shape {
    /// One number.
    pub const SCALAR: Self = Self { axes: &[] };
    /// `[R; 3]`.
    pub const VECTOR: Self = Self {
        axes: &[Axis::Three],
    };
    /// `[[R; 3]; 3]`.
    pub const MATRIX: Self = Self {
        axes: &[Axis::Three, Axis::Three],
    };
    /// `[R; NQ]`.
    pub const COORDINATES: Self = Self {
        axes: &[Axis::Coordinates],
    };
    /// `[R; NU]`.
    pub const SPEEDS: Self = Self {
        axes: &[Axis::Speeds],
    };
    /// `[[R; NU]; NU]`.
    pub const SPEED_MATRIX: Self = Self {
        axes: &[Axis::Speeds, Axis::Speeds],
    };
    /// `[R; MASS_MATRIX_PACKED_LEN]`.
    pub const SPEED_PAIRS: Self = Self {
        axes: &[Axis::SpeedPairs],
    };
    /// `[R; NB]`.
    pub const BODY_SCALARS: Self = Self {
        axes: &[Axis::Bodies],
    };
    /// `[[R; 3]; NB]`.
    pub const BODY_VECTORS: Self = Self {
        axes: &[Axis::Bodies, Axis::Three],
    };
    /// `[[[R; 3]; 3]; NB]`.
    pub const BODY_MATRICES: Self = Self {
        axes: &[Axis::Bodies, Axis::Three, Axis::Three],
    };
    /// `[[R; 3]; NAME_COLUMNS]`.
    pub const COLUMNS: Self = Self {
        axes: &[Axis::Columns, Axis::Three],
    };

    /// The lengths of the nested arrays, outermost first; `n_columns` is the number of a compact output's columns.
    pub fn lengths(self, tree: &Tree, n_columns: usize) -> Vec<usize> {
        let axes = self.axes.iter();
        axes.map(|axis| axis.length(tree, n_columns)).collect()
    }

    /// The lengths as generated code names them; `columns` names that of a compact output.
    pub fn declared(self, columns: impl Fn() -> String) -> Vec<Length> {
        let axes = self.axes.iter();
        axes.map(|axis| axis.declared(&columns)).collect()
    }

    /// True where some axis counts this.
    pub fn has(self, axis: Axis) -> bool {
        self.axes.contains(&axis)
    }
}

impl Element {
    /// The vectors that one is made of, in order; none for a number.
    pub fn vectors(self) -> &'static [&'static str] {
        match self {
            Self::Load => &["force", "moment"],
            Self::Scalar | Self::Parameters | Self::Prepared | Self::SinCos => &[],
        }
    }

    /// How many numbers one is of those that an argument may have.
    pub fn n_numbers(self) -> usize {
        match self.vectors() {
            [] => 1,
            vectors => 3 * vectors.len(),
        }
    }
}
