//! A column of one body and one parameter, on its way inward.

use super::super::lever::Levered;
use crate::id::BodyId;

/// The wrench that a unit of one parameter needs.
pub(super) struct UnitColumn {
    pub(super) body: BodyId,
    pub(super) parameter: usize,
    pub(super) needed: Levered,
}
