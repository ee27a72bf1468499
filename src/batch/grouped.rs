//! Quantities with contiguous groups: a slice of the arrays that the functions take, so that nothing is
//! copied before or after a call.

use super::rows::Size;
use super::{Batch, Group, LengthError};
use crate::functions::{Bias, ForwardDynamics, InverseDynamics, MassMatrix, MassMatrixPacked};
use crate::{Array, Lanes, System};

impl<L: Lanes> Batch<L> {
    /// The number of groups: the states divided by [`Lanes::LANES`], rounded up.
    #[must_use]
    pub fn n_groups(&self) -> usize {
        self.states.div_ceil(L::LANES.max(1))
    }

    /// Converts rows to groups: `groups[g][r]` gets the part of row `r` for the states of group `g`. Lanes beyond the last state repeat it.
    ///
    /// # Errors
    /// A slice of the wrong length; nothing is written then.
    pub fn to_groups<A: Array<L>>(
        &self,
        rows: &[L::Scalar],
        groups: &mut [A],
    ) -> Result<(), LengthError> {
        let rows = self.rows("rows", rows, A::LEN)?;
        self.check_groups("groups", groups.len())?;
        for (group, values) in self.groups().zip(groups) {
            group.read(&rows, values.as_mut());
        }
        Ok(())
    }

    /// Converts groups to rows, the inverse of [`Self::to_groups`].
    ///
    /// # Errors
    /// A slice of the wrong length; nothing is written then.
    pub fn from_groups<A: Array<L>>(
        &self,
        groups: &[A],
        rows: &mut [L::Scalar],
    ) -> Result<(), LengthError> {
        let mut rows = self.rows_mut("rows", rows, A::LEN)?;
        self.check_groups("groups", groups.len())?;
        let written = |(group, values): (Group<L>, &A)| group.write(values.as_ref(), &mut rows);
        self.groups().zip(groups).for_each(written);
        Ok(())
    }

    /// Refuses a slice without exactly one array for each group.
    fn check_groups(&self, argument: &'static str, found: usize) -> Result<(), LengthError> {
        let size = Size {
            argument,
            rows: 1,
            states: self.n_groups(),
        };
        size.check(found)
    }
}

/// Methods that call a function group by group.
macro_rules! methods {
    ($(
        $(#[$documentation:meta])*
        $method:ident, $function:ident: $trait:ident($($argument:ident: $given:ident),+) -> $output:ident: $written:ident;
    )+) => {
        impl<L: Lanes> Batch<L> {$(
            $(#[$documentation])*
            ///
            /// # Errors
            /// A slice without exactly one array for each group; nothing is written then.
            pub fn $method<S: $trait<L>>(
                &self,
                system: &S,
                $($argument: &[S::$given],)+
                $output: &mut [S::$written],
            ) -> Result<(), LengthError> {
                $(self.check_groups(stringify!($argument), $argument.len())?;)+
                self.check_groups(stringify!($output), $output.len())?;
                let mut outputs = $output.iter_mut();
                $(let mut $argument = $argument.iter();)+
                while let (Some(output), $(Some($argument),)+) = (outputs.next(), $($argument.next(),)+) {
                    system.$function($($argument,)+ output);
                }
                Ok(())
            }
        )+}
    };
}

methods! {
    /// [`System::q_dot`] of every group.
    q_dot_of_groups, q_dot: System(q: Q, u: U) -> q_dot: Q;
    /// [`Bias::bias`] of every group.
    bias_of_groups, bias: Bias(q: Q, u: U) -> bias: U;
    /// [`InverseDynamics::inverse_dynamics`] of every group.
    inverse_dynamics_of_groups, inverse_dynamics: InverseDynamics(q: Q, u: U, u_dot: U) -> tau: U;
    /// [`ForwardDynamics::forward_dynamics`] of every group.
    forward_dynamics_of_groups, forward_dynamics: ForwardDynamics(q: Q, u: U, tau: U) -> u_dot: U;
    /// [`MassMatrix::mass_matrix`] of every group.
    mass_matrix_of_groups, mass_matrix: MassMatrix(q: Q) -> m: Matrix;
    /// [`MassMatrixPacked::mass_matrix_packed`] of every group.
    mass_matrix_packed_of_groups, mass_matrix_packed: MassMatrixPacked(q: Q) -> entries: Entries;
}
