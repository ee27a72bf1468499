//! Many states at once: structure of arrays in, structure of arrays out, each lane of a vector one state.
//!
//! A quantity of a batch of `n` states is a slice of rows: all states' first number, then all states' second, and so on,
//! row by row (`q[0]` of every state, `q[1]` of every state, ...). So `q` has `NQ n` numbers, `tau` has `NU n`, and a mass
//! matrix `NU NU n`, entry `m[r][c]` in row `NU r + c`. States need no order and no padding; what is left over after the
//! last full group of lanes is computed with repeated lanes, of which nothing is stored.
//!
//! ```
//! # #[cfg(all(feature = "eight_body", feature = "wide"))] {
//! use kane::batch::Batch;
//! use kane::eight_body::{NQ, NU, Prepared};
//! use kane::wide::f64x4;
//!
//! const N: usize = 10;
//! let system = Prepared::<f64x4>::nominal();
//! let (q, u, u_dot) = (vec![0.1; NQ * N], vec![0.2; NU * N], vec![0.3; NU * N]);
//! let mut tau = vec![0.0; NU * N];
//! Batch::<f64x4>::new(N).inverse_dynamics(&system, &q, &u, &u_dot, &mut tau)?;
//! # }
//! # Ok::<(), kane::batch::LengthError>(())
//! ```
//!
//! Every lane has the bits that the same function gives for that state alone. The usual functions are methods of
//! [`Batch`]; any other is a loop over its groups:
//!
//! ```
//! # #[cfg(feature = "eight_body")] {
//! use kane::batch::Batch;
//! use kane::eight_body::{NQ, NU, Prepared};
//! use kane::functions::KineticEnergy;
//!
//! # const N: usize = 10;
//! # let system = Prepared::<f64>::nominal();
//! # let (q, u, mut energies) = (vec![0.1; NQ * N], vec![0.2; NU * N], vec![0.0; N]);
//! let batch = Batch::<f64>::new(N);
//! let (q, u) = (batch.rows("q", &q, NQ)?, batch.rows("u", &u, NU)?);
//! let mut energies = batch.rows_mut("energies", &mut energies, 1)?;
//! let (mut one_q, mut one_u, mut energy) = ([0.0; NQ], [0.0; NU], 0.0);
//! for group in batch.groups() {
//!     group.load(&q, &mut one_q);
//!     group.load(&u, &mut one_u);
//!     system.kinetic_energy(&one_q, &one_u, &mut energy);
//!     group.store([&energy], &mut energies);
//! }
//! # }
//! # Ok::<(), kane::batch::LengthError>(())
//! ```

use core::error::Error;
use core::fmt;
use core::marker::PhantomData;

use crate::functions::{Bias, ForwardDynamics, InverseDynamics, MassMatrix};
use crate::{Array, Lanes, System};

/// A number of states, computed [`Lanes::LANES`] at a time.
#[derive(Clone, Copy, Debug)]
pub struct Batch<L> {
    states: usize,
    lanes: PhantomData<L>,
}

/// Up to [`Lanes::LANES`] neighbouring states of a [`Batch`].
#[derive(Clone, Copy, Debug)]
pub struct Group<L> {
    first: usize,
    states: usize,
    lanes: PhantomData<L>,
}

/// A quantity of every state of a [`Batch`], row by row: [`Batch::rows`].
#[derive(Clone, Copy, Debug)]
pub struct Rows<'a, T> {
    values: &'a [T],
    states: usize,
}

/// As [`Rows`], to be written: [`Batch::rows_mut`].
#[derive(Debug)]
pub struct RowsMut<'a, T> {
    values: &'a mut [T],
    states: usize,
}

/// A slice is not as long as its rows and the batch's states make it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LengthError {
    /// The name of the argument.
    pub argument: &'static str,
    /// Its length.
    pub found: usize,
    /// How many rows it should have.
    pub rows: usize,
    /// How many states are in a row.
    pub states: usize,
}

impl fmt::Display for LengthError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            argument,
            found,
            rows,
            states,
        } = self;
        write!(
            f,
            "`{argument}` has {found} numbers, {rows} rows of {states} states are required"
        )
    }
}

impl Error for LengthError {}

impl<L: Lanes> Batch<L> {
    /// A batch of this many states.
    #[must_use]
    pub fn new(states: usize) -> Self {
        Self {
            states,
            lanes: PhantomData,
        }
    }

    /// The groups, in the order of the states; the last one may be smaller than the others.
    pub fn groups(self) -> impl Iterator<Item = Group<L>> {
        (0..self.states)
            .step_by(L::LANES.max(1))
            .map(move |first| Group {
                first,
                states: (self.states - first).min(L::LANES),
                lanes: PhantomData,
            })
    }

    /// A quantity with this many `rows`, to be read; `argument` is its name in the error.
    ///
    /// # Errors
    /// The slice is not `rows` times as long as there are states.
    pub fn rows<'a>(
        &self,
        argument: &'static str,
        values: &'a [L::Scalar],
        rows: usize,
    ) -> Result<Rows<'a, L::Scalar>, LengthError> {
        self.check(argument, values.len(), rows)?;
        let states = self.states;
        Ok(Rows { values, states })
    }

    /// As [`Self::rows`], to be written.
    ///
    /// # Errors
    /// The slice is not `rows` times as long as there are states.
    pub fn rows_mut<'a>(
        &self,
        argument: &'static str,
        values: &'a mut [L::Scalar],
        rows: usize,
    ) -> Result<RowsMut<'a, L::Scalar>, LengthError> {
        self.check(argument, values.len(), rows)?;
        let states = self.states;
        Ok(RowsMut { values, states })
    }

    fn check(&self, argument: &'static str, found: usize, rows: usize) -> Result<(), LengthError> {
        let states = self.states;
        if rows.checked_mul(states) == Some(found) {
            return Ok(());
        }
        Err(LengthError {
            argument,
            found,
            rows,
            states,
        })
    }

    /// [`System::q_dot`] of every state.
    ///
    /// # Errors
    /// A slice of the wrong length; nothing is written then.
    pub fn q_dot<S: System<L>>(
        &self,
        system: &S,
        q: &[L::Scalar],
        u: &[L::Scalar],
        q_dot: &mut [L::Scalar],
    ) -> Result<(), LengthError> {
        let q_rows = self.rows("q", q, S::Q::LEN)?;
        let u_rows = self.rows("u", u, S::U::LEN)?;
        let mut q_dot_rows = self.rows_mut("q_dot", q_dot, S::Q::LEN)?;
        let mut q = S::Q::filled(L::from_f64(0.0));
        let mut u = S::U::filled(L::from_f64(0.0));
        let mut q_dot = S::Q::filled(L::from_f64(0.0));
        for group in self.groups() {
            group.load(&q_rows, &mut q);
            group.load(&u_rows, &mut u);
            system.q_dot(&q, &u, &mut q_dot);
            group.store(q_dot.as_ref(), &mut q_dot_rows);
        }
        Ok(())
    }

    /// [`MassMatrix::mass_matrix`] of every state, entry `m[r][c]` in row `NU r + c`.
    ///
    /// # Errors
    /// A slice of the wrong length; nothing is written then.
    pub fn mass_matrix<S: MassMatrix<L>>(
        &self,
        system: &S,
        q: &[L::Scalar],
        m: &mut [L::Scalar],
    ) -> Result<(), LengthError> {
        let q_rows = self.rows("q", q, S::Q::LEN)?;
        let mut m_rows = self.rows_mut("m", m, S::U::LEN * S::U::LEN)?;
        let mut q = S::Q::filled(L::from_f64(0.0));
        let mut m = S::Matrix::filled(S::U::filled(L::from_f64(0.0)));
        for group in self.groups() {
            group.load(&q_rows, &mut q);
            system.mass_matrix(&q, &mut m);
            group.store(m.as_ref().iter().flat_map(AsRef::as_ref), &mut m_rows);
        }
        Ok(())
    }

    /// [`Bias::bias`] of every state.
    ///
    /// # Errors
    /// A slice of the wrong length; nothing is written then.
    pub fn bias<S: Bias<L>>(
        &self,
        system: &S,
        q: &[L::Scalar],
        u: &[L::Scalar],
        bias: &mut [L::Scalar],
    ) -> Result<(), LengthError> {
        let q_rows = self.rows("q", q, S::Q::LEN)?;
        let u_rows = self.rows("u", u, S::U::LEN)?;
        let mut bias_rows = self.rows_mut("bias", bias, S::U::LEN)?;
        let mut q = S::Q::filled(L::from_f64(0.0));
        let mut u = S::U::filled(L::from_f64(0.0));
        let mut bias = S::U::filled(L::from_f64(0.0));
        for group in self.groups() {
            group.load(&q_rows, &mut q);
            group.load(&u_rows, &mut u);
            system.bias(&q, &u, &mut bias);
            group.store(bias.as_ref(), &mut bias_rows);
        }
        Ok(())
    }

    /// [`InverseDynamics::inverse_dynamics`] of every state.
    ///
    /// # Errors
    /// A slice of the wrong length; nothing is written then.
    pub fn inverse_dynamics<S: InverseDynamics<L>>(
        &self,
        system: &S,
        q: &[L::Scalar],
        u: &[L::Scalar],
        u_dot: &[L::Scalar],
        tau: &mut [L::Scalar],
    ) -> Result<(), LengthError> {
        let q_rows = self.rows("q", q, S::Q::LEN)?;
        let u_rows = self.rows("u", u, S::U::LEN)?;
        let u_dot_rows = self.rows("u_dot", u_dot, S::U::LEN)?;
        let mut tau_rows = self.rows_mut("tau", tau, S::U::LEN)?;
        let mut q = S::Q::filled(L::from_f64(0.0));
        let mut u = S::U::filled(L::from_f64(0.0));
        let mut u_dot = S::U::filled(L::from_f64(0.0));
        let mut tau = S::U::filled(L::from_f64(0.0));
        for group in self.groups() {
            group.load(&q_rows, &mut q);
            group.load(&u_rows, &mut u);
            group.load(&u_dot_rows, &mut u_dot);
            system.inverse_dynamics(&q, &u, &u_dot, &mut tau);
            group.store(tau.as_ref(), &mut tau_rows);
        }
        Ok(())
    }

    /// [`ForwardDynamics::forward_dynamics`] of every state.
    ///
    /// # Errors
    /// A slice of the wrong length; nothing is written then.
    pub fn forward_dynamics<S: ForwardDynamics<L>>(
        &self,
        system: &S,
        q: &[L::Scalar],
        u: &[L::Scalar],
        tau: &[L::Scalar],
        u_dot: &mut [L::Scalar],
    ) -> Result<(), LengthError> {
        let q_rows = self.rows("q", q, S::Q::LEN)?;
        let u_rows = self.rows("u", u, S::U::LEN)?;
        let tau_rows = self.rows("tau", tau, S::U::LEN)?;
        let mut u_dot_rows = self.rows_mut("u_dot", u_dot, S::U::LEN)?;
        let mut q = S::Q::filled(L::from_f64(0.0));
        let mut u = S::U::filled(L::from_f64(0.0));
        let mut tau = S::U::filled(L::from_f64(0.0));
        let mut u_dot = S::U::filled(L::from_f64(0.0));
        for group in self.groups() {
            group.load(&q_rows, &mut q);
            group.load(&u_rows, &mut u);
            group.load(&tau_rows, &mut tau);
            system.forward_dynamics(&q, &u, &tau, &mut u_dot);
            group.store(u_dot.as_ref(), &mut u_dot_rows);
        }
        Ok(())
    }
}

impl<L: Lanes> Group<L> {
    /// Reads the group's states of the first rows, one a value; values beyond the last row stay as they are. `rows` are
    /// those of the same batch.
    #[inline]
    pub fn load(&self, rows: &Rows<'_, L::Scalar>, values: &mut impl AsMut<[L]>) {
        let values = values.as_mut();
        if self.states < L::LANES {
            return self.load_part(rows, values);
        }
        for (row, value) in values.iter_mut().enumerate() {
            let row = rows.values.get(self.first(row, rows.states)..);
            if let Some(row) = row.and_then(|row| row.get(..L::LANES)) {
                *value = L::load(row);
            }
        }
    }

    /// Writes the group's states of the first rows, one a value; values beyond the last row are dropped.
    #[inline]
    pub fn store<'v>(
        &self,
        values: impl IntoIterator<Item = &'v L>,
        rows: &mut RowsMut<'_, L::Scalar>,
    ) {
        if self.states < L::LANES {
            return self.store_part(values, rows);
        }
        for (row, value) in values.into_iter().enumerate() {
            let row = rows.values.get_mut(self.first(row, rows.states)..);
            if let Some(row) = row.and_then(|row| row.get_mut(..L::LANES)) {
                value.store(row);
            }
        }
    }

    // Groups of fewer states than there are lanes: apart, so that full ones need not look at each row.

    #[cold]
    #[inline(never)]
    fn load_part(&self, rows: &Rows<'_, L::Scalar>, values: &mut [L]) {
        for (row, value) in values.iter_mut().enumerate() {
            let row = rows.values.get(self.first(row, rows.states)..);
            if let Some(row) = row.and_then(|row| row.get(..self.states)) {
                *value = L::load(row);
            }
        }
    }

    #[cold]
    #[inline(never)]
    fn store_part<'v>(
        &self,
        values: impl IntoIterator<Item = &'v L>,
        rows: &mut RowsMut<'_, L::Scalar>,
    ) {
        for (row, value) in values.into_iter().enumerate() {
            let row = rows.values.get_mut(self.first(row, rows.states)..);
            if let Some(row) = row.and_then(|row| row.get_mut(..self.states)) {
                value.store(row);
            }
        }
    }

    /// Where the group stands in a row of the batch's `states`.
    #[inline]
    fn first(&self, row: usize, states: usize) -> usize {
        row.wrapping_mul(states).wrapping_add(self.first)
    }
}
