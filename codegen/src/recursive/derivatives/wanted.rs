//! Which derivatives are asked for, where a function needs some of them before others are known.

/// Of what is not wanted, columns that pass in lockstep only say where it is other than zero, by the number one.
#[derive(Clone, Copy, Debug)]
pub struct Wanted {
    by_q: bool,
    by_u: bool,
    by_u_dot: bool,
}

impl Wanted {
    /// All of them.
    pub const ALL: Self = Self {
        by_q: true,
        by_u: true,
        by_u_dot: true,
    };

    /// Those that do not depend on accelerations.
    pub const BY_SPEEDS_AND_ACCELERATIONS: Self = Self {
        by_q: false,
        ..Self::ALL
    };

    /// Those that do.
    pub const BY_COORDINATES: Self = Self {
        by_q: true,
        by_u: false,
        by_u_dot: false,
    };

    /// True for all.
    pub(super) fn are_all(self) -> bool {
        self.by_q && self.by_u && self.by_u_dot
    }

    /// By the matrices, as [`Derivatives`](super::Derivatives) has them.
    pub(super) fn matrices(self) -> [bool; 3] {
        [self.by_q, self.by_u, self.by_u_dot]
    }
}
