//! [`Load`]: the external force and moment on a body.

use crate::Real;

/// Resultant force and moment on one body, `F'_K` and `M'_K` of Eq. (36).
///
/// Do not include weight: if the model has gravity, the generated functions include it already.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Load<R> {
    /// Resultant force at the mass centre of the body, including all that is fixed to it, body components, N.
    pub force: [R; 3],
    /// Resultant moment (about the mass centre), body components, N m.
    pub moment: [R; 3],
}

impl<R: Real> Default for Load<R> {
    /// No load.
    #[inline]
    fn default() -> Self {
        let zero = R::from_f64(0.0);
        Self {
            force: [zero; 3],
            moment: [zero; 3],
        }
    }
}
