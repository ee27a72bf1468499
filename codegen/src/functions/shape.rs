//! Arrays that functions are given and write: dimensions, each with a constant's name and a length, and what they are of.

use super::packed::Packed;
use crate::{
    base_parameters,
    tree::{N_INERTIAL, Tree},
};

/// The constant that holds the number of bodies.
pub const N_BODIES: &str = "NB";
/// The constant that holds the number of coordinates.
pub const N_COORDINATES: &str = "NQ";
/// The constant that holds the number of speeds.
pub const N_SPEEDS: &str = "NU";

/// The constant that holds the number of base parameters.
pub const N_BASE_PARAMETERS: &str = "BASE_PARAMETERS_LEN";

/// The constant that holds the number of values set at run time.
pub const N_PARAMETERS: &str = "PARAMETERS_LEN";

/// What a dimension of an array counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Dimension {
    /// The components of a vector.
    Three,
    /// Coordinates.
    Coordinates,
    /// Speeds.
    Speeds,
    /// The places of a packed matrix over speeds.
    Packed(Packed),
    /// Bodies.
    Bodies,
    /// The inertial parameters of a body.
    Parameters,
    /// Values set at run time.
    Values,
    /// The components of a load: force, then moment.
    LoadComponents,
    /// Base parameters: combinations of these on which forces depend.
    BaseParameters,
    /// The columns of a compact output's non-zero partitions, with their pattern beside the function.
    Columns,
    /// The speeds that move the frame that a function is of, with their places beside the function.
    FrameSpeeds,
    /// The components of frames' motions and of the wrenches on them: six a frame, linear before angular.
    FrameComponents,
    /// The components of velocities of frames' origins and of the forces there: three a frame.
    FramePoints,
    /// The entries of a derivative that are not structurally zero, with their places beside the function.
    Entries,
}

/// The dimensions of nested arrays, outermost first; none for one element. Row-major.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Shape {
    /// The dimensions.
    pub dimensions: &'static [Dimension],
    /// Those of what it is differentiated by, within them.
    pub by: &'static [Dimension],
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
    /// A number.
    Number(usize),
    /// A constant of the module: `NQ`.
    Constant(String),
    /// Twice such a constant: that of a state.
    Twice(String),
}

impl Length {
    /// The constant that it names.
    pub fn constant(&self) -> Option<&str> {
        match self {
            Self::Number(_) => None,
            Self::Constant(name) | Self::Twice(name) => Some(name),
        }
    }
}

impl Dimension {
    /// Those whose length the frames decide that a function is of.
    pub(super) const OF_SUBJECTS: [Self; 3] =
        [Self::FrameSpeeds, Self::FrameComponents, Self::FramePoints];

    /// How many there are of what it counts; `None` where the function decides.
    pub fn length(self, tree: &Tree) -> Option<usize> {
        Some(match self {
            Self::Three => 3,
            Self::Parameters => N_INERTIAL,
            Self::Values => tree.parameters.len(),
            Self::LoadComponents => 6,
            Self::BaseParameters => base_parameters::of(tree).len(),
            Self::Coordinates => tree.n_coordinates,
            Self::Speeds => tree.n_speeds,
            Self::Packed(packed) => packed.places(tree).len(),
            Self::Bodies => tree.bodies.len(),
            Self::Columns
            | Self::FrameSpeeds
            | Self::FrameComponents
            | Self::FramePoints
            | Self::Entries => return None,
        })
    }

    /// The constant that holds its length, where modules have one of the same name.
    pub fn constant(self) -> Option<&'static str> {
        match self {
            Self::Three
            | Self::Parameters
            | Self::LoadComponents
            | Self::Columns
            | Self::FrameSpeeds
            | Self::FrameComponents
            | Self::FramePoints
            | Self::Entries => None,
            Self::Coordinates => Some(N_COORDINATES),
            Self::Speeds => Some(N_SPEEDS),
            Self::Packed(packed) => Some(packed.length_constant()),
            Self::Bodies => Some(N_BODIES),
            Self::BaseParameters => Some(N_BASE_PARAMETERS),
            Self::Values => Some(N_PARAMETERS),
        }
    }

    /// Its length as generated code names it; `own` names what the function decides.
    fn declared(self, own: impl FnOnce(Self) -> Length) -> Length {
        match (self, self.constant()) {
            (Self::Three, _) => Length::Number(3),
            (Self::Parameters, _) => Length::Number(N_INERTIAL),
            (Self::LoadComponents, _) => Length::Number(6),
            (_, Some(constant)) => Length::Constant(constant.to_owned()),
            (_, None) => own(self),
        }
    }

    /// One of what it counts, in words.
    pub fn one(self) -> &'static str {
        match self {
            Self::Three => "an axis",
            Self::Coordinates => "a coordinate",
            Self::Speeds => "a speed",
            Self::Packed(packed) => packed.one(),
            Self::Bodies => "a body",
            Self::Parameters => "a parameter",
            Self::Values => "a value set at run time",
            Self::LoadComponents => "a component of a load",
            Self::BaseParameters => "a base parameter",
            Self::Columns => "a column",
            Self::FrameSpeeds => "a speed that moves the frame",
            Self::FrameComponents => "a component of a frame",
            Self::FramePoints => "a component of a frame's origin",
            Self::Entries => "an entry",
        }
    }
}

impl Shape {
    pub(super) const fn of(dimensions: &'static [Dimension]) -> Self {
        Self {
            dimensions,
            by: &[],
        }
    }

    /// One number.
    pub const SCALAR: Self = Self::of(&[]);
    /// `[R; 3]`.
    pub const VECTOR: Self = Self::of(&[Dimension::Three]);
    /// `[[R; 3]; 3]`.
    pub const MATRIX: Self = Self::of(&[Dimension::Three, Dimension::Three]);
    /// `[R; NQ]`.
    pub const COORDINATES: Self = Self::of(&[Dimension::Coordinates]);
    /// `[R; NU]`.
    pub const SPEEDS: Self = Self::of(&[Dimension::Speeds]);
    /// `[[R; NU]; NU]`.
    pub const SPEED_MATRIX: Self = Self::of(&[Dimension::Speeds, Dimension::Speeds]);
    /// `[[R; 3]; NU]`.
    pub const SPEED_VECTORS: Self = Self::of(&[Dimension::Speeds, Dimension::Three]);
    /// `[[R; 10]; NB]`.
    pub const INERTIAL_PARAMETERS: Self = Self::of(&[Dimension::Bodies, Dimension::Parameters]);
    /// `[[[R; 10]; NB]; NU]`.
    pub const REGRESSOR: Self =
        Self::of(&[Dimension::Speeds, Dimension::Bodies, Dimension::Parameters]);
    /// `[R; BASE_PARAMETERS_LEN]`.
    pub const BASE_PARAMETERS: Self = Self::of(&[Dimension::BaseParameters]);
    /// `[[R; BASE_PARAMETERS_LEN]; NU]`.
    pub const BASE_REGRESSOR: Self = Self::of(&[Dimension::Speeds, Dimension::BaseParameters]);
    /// `[R; MASS_MATRIX_PACKED_LEN]`.
    pub const MASS_MATRIX_PACKED: Self = Self::of(&[Dimension::Packed(Packed::MassMatrix)]);
    /// `[R; MASS_MATRIX_INVERSE_PACKED_LEN]`.
    pub const INVERSE_PACKED: Self = Self::of(&[Dimension::Packed(Packed::Inverse)]);
    /// `[R; MASS_MATRIX_FACTORS_LEN]`.
    pub const FACTORS: Self = Self::of(&[Dimension::Packed(Packed::Factors)]);
    /// `[R; REGRESSOR_PACKED_LEN]`.
    pub const REGRESSOR_PACKED: Self = Self::of(&[Dimension::Packed(Packed::Regressor)]);
    /// `[R; PARAMETERS_LEN]`.
    pub const VALUES: Self = Self::of(&[Dimension::Values]);
    /// `[R; NB]`.
    pub const BODY_SCALARS: Self = Self::of(&[Dimension::Bodies]);
    /// `[[R; 3]; NB]`.
    pub const BODY_VECTORS: Self = Self::of(&[Dimension::Bodies, Dimension::Three]);
    /// `[[[R; 3]; 3]; NB]`.
    pub const BODY_MATRICES: Self =
        Self::of(&[Dimension::Bodies, Dimension::Three, Dimension::Three]);
    /// `[[R; NU]; 3]`.
    pub const VECTOR_BY_SPEEDS: Self = Self::of(&[Dimension::Three, Dimension::Speeds]);
    /// `[[R; NAME_SPEEDS_LEN]; 3]`.
    pub const VECTOR_BY_FRAME_SPEEDS: Self = Self::of(&[Dimension::Three, Dimension::FrameSpeeds]);
    /// `[[R; 6]; 6]`, of one frame.
    pub const FRAME_MATRIX: Self =
        Self::of(&[Dimension::FrameComponents, Dimension::FrameComponents]);
    /// `[[R; 3]; 3]`, of the origin of one frame.
    pub const POINT_MATRIX: Self = Self::of(&[Dimension::FramePoints, Dimension::FramePoints]);
    /// `[R; NAME_LEN]`, of a packed derivative.
    pub const ENTRIES: Self = Self::of(&[Dimension::Entries]);
    /// `[[R; 3]; NAME_COLUMNS]`.
    pub const COLUMNS: Self = Self::of(&[Dimension::Columns, Dimension::Three]);

    /// All dimensions, outermost first.
    pub fn all(self) -> impl Iterator<Item = Dimension> {
        self.dimensions.iter().chain(self.by).copied()
    }

    /// The lengths of the nested arrays, outermost first; `own` knows those that the function decides.
    pub fn lengths(self, tree: &Tree, own: impl Fn(Dimension) -> usize) -> Vec<usize> {
        let dimensions = self.all();
        dimensions
            .map(|dimension| dimension.length(tree).unwrap_or_else(|| own(dimension)))
            .collect()
    }

    /// The lengths as generated code names them; `own` names those that the function decides.
    pub fn declared(self, own: impl Fn(Dimension) -> Length) -> Vec<Length> {
        self.all()
            .map(|dimension| dimension.declared(&own))
            .collect()
    }

    /// The packed matrix that it is, if it is one.
    pub fn packed(self) -> Option<Packed> {
        let mut dimensions = self.dimensions.iter();
        dimensions.find_map(|dimension| match dimension {
            Dimension::Packed(packed) => Some(*packed),
            _ => None,
        })
    }

    /// True where some dimension of the array counts this; that of a variable it is differentiated by does not matter.
    pub fn has(self, dimension: Dimension) -> bool {
        self.dimensions.contains(&dimension)
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
