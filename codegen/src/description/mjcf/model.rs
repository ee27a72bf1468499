//! What a whole file says, beside its bodies.

use crate::description::Reading;
use crate::description::mjcf::copies::Copies;
use crate::description::mjcf::defaults::Defaults;
use crate::description::mjcf::include::Files;
use crate::description::mjcf::meshes::Meshes;
use crate::description::mjcf::settings::Settings;

/// What the whole file says, beside its bodies.
#[derive(Debug)]
pub(super) struct Model<'d> {
    pub(super) files: &'d Files<'d>,
    pub(super) reading: &'d Reading,
    pub(super) settings: Settings,
    pub(super) defaults: Defaults<'d>,
    pub(super) meshes: Meshes<'d>,
    /// How many elements `replicate` copied.
    pub(super) copies: Copies,
}
