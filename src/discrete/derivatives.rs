//! Changes of states, and derivatives of a step.

use crate::vector::{set_column, unit, zero};
use crate::{Array, Real};

/// A change of a state, of `q` as a direction of [`q_plus`](crate::manifold::q_plus) and of `u`, or a multiplier of both.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Change<U> {
    /// The change of `q`, one entry per speed, rad and m along the axes of `u`.
    pub q: U,
    /// The change of `u`, rad/s and m/s.
    pub u: U,
}

impl<U> Change<U> {
    /// No change.
    pub(super) fn zero<R: Real>() -> Self
    where
        U: Array<R>,
    {
        Self {
            q: zero(),
            u: zero(),
        }
    }
}

/// The variable by which a step is differentiated.
#[derive(Clone, Copy)]
pub(super) enum Variable {
    Q,
    U,
    Tau,
}

impl Variable {
    /// The change of the state if one entry of the variable changes by one.
    pub(super) fn change<R: Real, U: Array<R>>(self, place: usize) -> Change<U> {
        let none = Change::zero();
        match self {
            Self::Q => Change {
                q: unit(place),
                ..none
            },
            Self::U => Change {
                u: unit(place),
                ..none
            },
            Self::Tau => none,
        }
    }
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

    /// Overwrites all columns, where `after(variable, place)` is the change after the step as that entry grows by one.
    pub(super) fn set_columns<R: Real, U: Array<R>>(
        &mut self,
        after: impl Fn(Variable, usize) -> Change<U>,
    ) where
        M: Array<U>,
    {
        for (variable, of_q, of_u) in [
            (Variable::Q, &mut self.q_by_q, &mut self.u_by_q),
            (Variable::U, &mut self.q_by_u, &mut self.u_by_u),
            (Variable::Tau, &mut self.q_by_tau, &mut self.u_by_tau),
        ] {
            for place in 0..U::LEN {
                let changed = after(variable, place);
                set_column(of_q, place, &changed.q);
                set_column(of_u, place, &changed.u);
            }
        }
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

    /// Overwrites all columns, where `after(place)` is the change after the step as that value grows by one.
    pub(super) fn set_columns<R: Real, U: Array<R>, V: Array<R>>(
        &mut self,
        after: impl Fn(usize) -> Change<U>,
    ) where
        M: Array<V>,
    {
        for place in 0..V::LEN {
            let changed = after(place);
            set_column(&mut self.q, place, &changed.q);
            set_column(&mut self.u, place, &changed.u);
        }
    }
}
