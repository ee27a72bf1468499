//! What a step makes of changes.

/// A change of a state: of `q` as a direction over the speeds, [`q_plus`](crate::manifold::q_plus), and of `u`; or a multiplier of
/// both.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Change<U> {
    /// Over the speeds, rad and m along the axes of `u`.
    pub q: U,
    /// Of `u`, rad/s and m/s.
    pub u: U,
}

/// The derivatives of a step by blocks, `[[R; NU]; NU]` each, by rows: of the state after it by the state before it, and by `tau`.
///
/// With the changes `q` before `u`, `A = [q_by_q, q_by_u; u_by_q, u_by_u]` and `B = [q_by_tau; u_by_tau]`. With the feature
/// `nalgebra`, `view::step_by_state` and `view::step_by_tau` make matrices of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepDerivatives<M> {
    /// Of the coordinates by the coordinates.
    pub q_by_q: M,
    /// Of the coordinates by the speeds, s.
    pub q_by_u: M,
    /// Of the coordinates by the forces.
    pub q_by_tau: M,
    /// Of the speeds by the coordinates, 1/s.
    pub u_by_q: M,
    /// Of the speeds by the speeds.
    pub u_by_u: M,
    /// Of the speeds by the forces.
    pub u_by_tau: M,
}

impl<M: Copy> StepDerivatives<M> {
    /// All blocks as this one, to be overwritten.
    pub fn filled(block: M) -> Self {
        Self {
            q_by_q: block,
            q_by_u: block,
            q_by_tau: block,
            u_by_q: block,
            u_by_u: block,
            u_by_tau: block,
        }
    }
}

/// The derivatives of the state after a step by all values set at run time, `[[R; n]; NU]` each, by rows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepByParameters<M> {
    /// Of the coordinates.
    pub q: M,
    /// Of the speeds.
    pub u: M,
}
