//! Changes of states, and derivatives of a step.

/// A change of a state, of `q` as a direction of [`q_plus`](crate::manifold::q_plus) and of `u`, or a multiplier of both.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Change<U> {
    /// The change of `q`, one entry per speed, rad and m along the axes of `u`.
    pub q: U,
    /// The change of `u`, rad/s and m/s.
    pub u: U,
}

/// What a step is differentiated by.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Variable {
    Q,
    U,
    /// Forces, or values set at run time: the state before the step does not depend on them.
    Other,
}

/// The derivatives of the state after a step by the state before it and by `tau`, in blocks `[[R; NU]; NU]`, row by row.
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
    /// All blocks equal to `block`, as storage to overwrite.
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

    /// The derivatives of the coordinates and of the speeds, variable by variable.
    pub(super) fn by_variable(&mut self) -> [(Variable, &mut M, &mut M); 3] {
        [
            (Variable::Q, &mut self.q_by_q, &mut self.u_by_q),
            (Variable::U, &mut self.q_by_u, &mut self.u_by_u),
            (Variable::Other, &mut self.q_by_tau, &mut self.u_by_tau),
        ]
    }
}

/// The derivatives of the state after a step by all values set at run time, `[[R; n]; NU]` each, row by row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepByParameters<M> {
    /// Of the coordinates.
    pub q: M,
    /// Of the speeds.
    pub u: M,
}

impl<M: Copy> StepByParameters<M> {
    /// Both blocks equal to `block`, as storage to overwrite.
    pub fn filled(block: M) -> Self {
        Self { q: block, u: block }
    }
}
