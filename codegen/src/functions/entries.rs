//! What equations give, as the entries of outputs, row-major.

use crate::{
    expr::{Expr, Vector},
    id::BodyMap,
    kane::center::{self, Momentum},
    solve::SpeedMatrix,
};

/// What has entries in one order.
pub(super) trait Entries {
    /// One after the other, row by row.
    fn entries(self) -> Vec<Expr>;
}

impl Entries for Expr {
    fn entries(self) -> Vec<Expr> {
        vec![self]
    }
}

impl Entries for Vector {
    fn entries(self) -> Vec<Expr> {
        self.to_vec()
    }
}

impl Entries for Vec<Expr> {
    fn entries(self) -> Vec<Expr> {
        self
    }
}

impl Entries for SpeedMatrix {
    fn entries(self) -> Vec<Expr> {
        self.concat()
    }
}

impl Entries for BodyMap<Expr> {
    fn entries(self) -> Vec<Expr> {
        self.into_values().collect()
    }
}

/// The columns of a matrix.
impl Entries for Vec<Vector> {
    fn entries(self) -> Vec<Expr> {
        let row = |axis: usize| self.iter().map(move |column| column[axis]);
        (0..3).flat_map(row).collect()
    }
}

/// Linear, then angular.
impl Entries for Momentum {
    fn entries(self) -> Vec<Expr> {
        [self.linear, self.angular].concat()
    }
}

/// The columns of two matrices: linear, then angular.
impl Entries for Vec<Momentum> {
    fn entries(self) -> Vec<Expr> {
        center::rows(&self).concat()
    }
}
