//! How much work the meshes of a model may be.

use crate::description::mesh::fault::{Fault, SIMPLIFY};
use crate::limits::MESH_STEPS;

/// The work that is left for the meshes of a model.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Effort(usize);

impl Effort {
    /// All of it.
    pub(crate) fn new() -> Self {
        Self(MESH_STEPS)
    }

    /// Takes so many steps, or says that there are too many.
    pub(super) fn spend(&mut self, steps: usize) -> Result<(), Fault> {
        let Some(left) = self.0.checked_sub(steps) else {
            self.0 = 0;
            let found = format!(
                "takes more than the {MESH_STEPS} steps that all meshes of a model may take"
            );
            return Err(Fault::new(found).help(SIMPLIFY));
        };
        self.0 = left;
        Ok(())
    }
}
