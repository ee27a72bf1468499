//! The inertial parameters of a body: their order, and where they stand among those of all bodies.

use std::ops::Range;

use crate::id::BodyId;

/// How many inertial parameters a body has.
pub const N_INERTIAL: usize = 10;

/// One of the ten inertial parameters of a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct InertialParameter {
    /// The body.
    pub body: BodyId,
    /// The place among the ten.
    pub place: usize,
}

impl InertialParameter {
    /// Their names, in their order: the mass, the first moment, the inertia about the body's origin.
    pub const NAMES: [&'static str; N_INERTIAL] = [
        "m", "mcx", "mcy", "mcz", "ixx", "ixy", "iyy", "ixz", "iyz", "izz",
    ];
    /// The places of the first moment.
    pub const MOMENTS: Range<usize> = 1..4;
    /// The places of the inertia.
    pub const INERTIAS: Range<usize> = 4..N_INERTIAL;
    /// The row and the column of each component of the inertia.
    pub const COMPONENTS: [[usize; 2]; 6] = [[0, 0], [0, 1], [1, 1], [0, 2], [1, 2], [2, 2]];

    /// The place among the parameters of all bodies, body after body: its column of a regressor.
    pub fn column(self) -> usize {
        self.body.index() * N_INERTIAL + self.place
    }

    /// The parameter of a column.
    pub fn of_column(column: usize) -> Self {
        Self {
            body: BodyId::new(column / N_INERTIAL),
            place: column % N_INERTIAL,
        }
    }
}
