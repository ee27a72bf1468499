//! [`Load`]: what acts on a body from outside.

use crate::Real;

/// Resultant force and moment on one body, `F'_K` and `M'_K` of Eq. (36).
///
/// Weight does not belong here: where the description gives gravity, the generated functions hold it already.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Load<R> {
    /// Resultant force, acting at the mass centre of the body with all that is fixed to it, body components, N.
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
