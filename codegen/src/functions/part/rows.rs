//! What sweeps cost.

/// How many rows sweeps carry along.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Rows {
    /// From the inputs to the outputs: one for each variable or direction.
    pub forward: usize,
    /// From the outputs back: one for each output or multiplied sum.
    pub reverse: usize,
}
