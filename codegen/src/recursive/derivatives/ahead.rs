//! Columns that leave the others and go ahead to the inertial frame.

use super::{column::DerivativeColumn, found::Derivatives};
use crate::{expr::ExprGraph, id::BodyId, recursive::matrices::shortcut::Shortcuts};

/// Where columns are on their way inward.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    pub(super) body: BodyId,
    /// How many steps of the way through its joint are behind, the rotation of the last one apart: its motions have read the columns.
    pub(super) step: usize,
}

impl Place {
    pub(super) fn at_link(body: BodyId) -> Self {
        Self { body, step: 0 }
    }
}

/// What sends columns ahead.
pub(super) trait SendAhead {
    /// Takes columns that it sends, and adds up what is read off them.
    fn send(
        &self,
        graph: &mut ExprGraph,
        from: Place,
        columns: &mut Vec<DerivativeColumn>,
        shortcuts: &mut Shortcuts<'_>,
        found: &mut Derivatives,
    );
}
