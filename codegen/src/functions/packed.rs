//! Which entries of a matrix a packed output holds: one table.
//!
//! In: a [`Packed`] and a tree. Out: the places, `[row, column]`, and what constants that hold them are called: of a symmetric matrix
//! with `column <= row`, row after row; of a regressor column after column. Afterwards: places follow from the tree alone, never from
//! values, and those of a new last leaf come last.

use crate::{
    solve,
    tree::{Tree, regressor_places},
};

/// The constant that holds the order in which speeds are eliminated.
pub const ELIMINATION: &str = "MASS_MATRIX_FACTORS_ORDER";

/// A packed matrix.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Packed {
    /// The mass matrix: speeds that move a body in common.
    MassMatrix,
    /// Its inverse: speeds of one tree at the root.
    Inverse,
    /// Its factors: speeds that move a body in common, or that elimination couples.
    Factors,
    /// The regressor: bodies that a speed moves, by their parameters.
    Regressor,
}

/// A row of the table.
struct Entry {
    function: &'static str,
    length: &'static str,
    places: &'static str,
    brief: &'static str,
    written: &'static str,
    of: fn(&Tree) -> Vec<[usize; 2]>,
}

impl Packed {
    /// All of them, in the order in which modules hold their places.
    pub const ALL: [Self; 4] = [
        Self::MassMatrix,
        Self::Inverse,
        Self::Factors,
        Self::Regressor,
    ];

    fn entry(self) -> Entry {
        match self {
            Self::MassMatrix => Entry {
                function: "mass_matrix_packed",
                length: "MASS_MATRIX_PACKED_LEN",
                places: "MASS_MATRIX_PACKED_PLACES",
                brief: "Number of entries of a packed mass matrix",
                written: "The row and column of each entry that `mass_matrix_packed` writes; those above the diagonal are the same.",
                of: |tree| Vec::from_iter(tree.coupled_speeds()),
            },
            Self::Inverse => Entry {
                function: "mass_matrix_inverse_packed",
                length: "MASS_MATRIX_INVERSE_PACKED_LEN",
                places: "MASS_MATRIX_INVERSE_PACKED_PLACES",
                brief: "Number of entries of a packed inverse of a mass matrix",
                written: "The row and column of each entry that `mass_matrix_inverse_packed` writes; those above the diagonal are the same.",
                of: |tree| Vec::from_iter(solve::inverse_places(tree)),
            },
            Self::Factors => Entry {
                function: "mass_matrix_factors",
                length: "MASS_MATRIX_FACTORS_LEN",
                places: "MASS_MATRIX_FACTORS_PLACES",
                brief: "Number of entries of the factors of a mass matrix",
                written: "The two speeds of each entry that `mass_matrix_factors` writes: of D on the diagonal, of L elsewhere, in the row of the one that is eliminated first.",
                of: |tree| Vec::from_iter(solve::factor_places(tree)),
            },
            Self::Regressor => Entry {
                function: "regressor_packed",
                length: "REGRESSOR_PACKED_LEN",
                places: "REGRESSOR_PACKED_PLACES",
                brief: "Number of entries of a packed regressor",
                written: "The row, which is a speed, and the column, `10 body + parameter`, of each entry that `regressor_packed` writes, column after column; all others are zero.",
                of: regressor_places,
            },
        }
    }

    /// The function that is packed so.
    pub fn function(self) -> &'static str {
        self.entry().function
    }

    /// The constant that holds how many entries there are.
    pub fn length_constant(self) -> &'static str {
        self.entry().length
    }

    /// The constant that holds where they stand.
    pub fn places_constant(self) -> &'static str {
        self.entry().places
    }

    /// One of its entries, in words.
    pub fn one(self) -> &'static str {
        match self {
            Self::MassMatrix | Self::Inverse | Self::Factors => "a pair of speeds",
            Self::Regressor => "a parameter of a body and a speed",
        }
    }

    /// What the number of entries is, in words.
    pub fn brief(self) -> &'static str {
        self.entry().brief
    }

    /// What the places are, in words.
    pub fn written(self) -> &'static str {
        self.entry().written
    }

    /// Where the entries stand.
    pub fn places(self, tree: &Tree) -> Vec<[usize; 2]> {
        (self.entry().of)(tree)
    }
}
