//! A system whose functions can be evaluated, in whatever way.

use kane_codegen::tree::Tree;

use super::{composition::Composition, state::State};

/// A system whose functions can be evaluated.
pub trait Model {
    /// What to call it in a message.
    fn name(&self) -> String;

    /// What its description comes to.
    fn composition(&self) -> &Composition;

    /// Its tree, with the numbering of all arrays, and the nominal values of its parameters.
    fn tree(&self) -> &Tree {
        self.composition().tree()
    }

    /// The output of a function, row-major; partial velocities as dense `3 x NU` matrices, body after body.
    fn evaluate(&self, function: &str, state: &State) -> Vec<f64>;
}
