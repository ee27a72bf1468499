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
use core::ops::Range;

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

/// How many groups a [`Tile`] has: their states fill whole cache lines of a row, at least.
const GROUPS: usize = 8;

/// Neighbouring groups, which are read and written row by row.
///
/// Rows are often a power of two apart, and then their lines compete for one place in the cache: it is faster to take
/// several groups from each than to come back to it for each group.
struct Tile<L> {
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
        groups(0..self.states)
    }

    /// The tiles, in the order of the states; the last one may be smaller than the others.
    fn tiles(self) -> impl Iterator<Item = Tile<L>> {
        let size = GROUPS * L::LANES.max(1);
        (0..self.states).step_by(size).map(move |first| Tile {
            first,
            states: (self.states - first).min(size),
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
        let mut q = [S::Q::filled(L::from_f64(0.0)); GROUPS];
        let mut u = [S::U::filled(L::from_f64(0.0)); GROUPS];
        let mut q_dot = [S::Q::filled(L::from_f64(0.0)); GROUPS];
        for tile in self.tiles() {
            tile.load(&q_rows, &mut q);
            tile.load(&u_rows, &mut u);
            for (((_, q), u), q_dot) in tile.groups().zip(&q).zip(&u).zip(&mut q_dot) {
                system.q_dot(q, u, q_dot);
            }
            tile.store(&q_dot, &mut q_dot_rows);
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
        let mut q = [S::Q::filled(L::from_f64(0.0)); GROUPS];
        let mut m = S::Matrix::filled(S::U::filled(L::from_f64(0.0)));
        for tile in self.tiles() {
            tile.load(&q_rows, &mut q);
            for (group, q) in tile.groups().zip(&q) {
                system.mass_matrix(q, &mut m);
                let entries = m.as_ref().iter().flat_map(AsRef::as_ref);
                group.store(entries, &mut m_rows);
            }
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
        let mut q = [S::Q::filled(L::from_f64(0.0)); GROUPS];
        let mut u = [S::U::filled(L::from_f64(0.0)); GROUPS];
        let mut bias = [S::U::filled(L::from_f64(0.0)); GROUPS];
        for tile in self.tiles() {
            tile.load(&q_rows, &mut q);
            tile.load(&u_rows, &mut u);
            for (((_, q), u), bias) in tile.groups().zip(&q).zip(&u).zip(&mut bias) {
                system.bias(q, u, bias);
            }
            tile.store(&bias, &mut bias_rows);
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
        let mut q = [S::Q::filled(L::from_f64(0.0)); GROUPS];
        let mut u = [S::U::filled(L::from_f64(0.0)); GROUPS];
        let mut u_dot = [S::U::filled(L::from_f64(0.0)); GROUPS];
        let mut tau = [S::U::filled(L::from_f64(0.0)); GROUPS];
        for tile in self.tiles() {
            tile.load(&q_rows, &mut q);
            tile.load(&u_rows, &mut u);
            tile.load(&u_dot_rows, &mut u_dot);
            for ((((_, q), u), u_dot), tau) in
                tile.groups().zip(&q).zip(&u).zip(&u_dot).zip(&mut tau)
            {
                system.inverse_dynamics(q, u, u_dot, tau);
            }
            tile.store(&tau, &mut tau_rows);
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
        let mut q = [S::Q::filled(L::from_f64(0.0)); GROUPS];
        let mut u = [S::U::filled(L::from_f64(0.0)); GROUPS];
        let mut tau = [S::U::filled(L::from_f64(0.0)); GROUPS];
        let mut u_dot = [S::U::filled(L::from_f64(0.0)); GROUPS];
        for tile in self.tiles() {
            tile.load(&q_rows, &mut q);
            tile.load(&u_rows, &mut u);
            tile.load(&tau_rows, &mut tau);
            for ((((_, q), u), tau), u_dot) in
                tile.groups().zip(&q).zip(&u).zip(&tau).zip(&mut u_dot)
            {
                system.forward_dynamics(q, u, tau, u_dot);
            }
            tile.store(&u_dot, &mut u_dot_rows);
        }
        Ok(())
    }
}

/// Groups of these states.
fn groups<L: Lanes>(states: Range<usize>) -> impl Iterator<Item = Group<L>> {
    let end = states.end;
    let groups = states.step_by(L::LANES.max(1));
    groups.map(move |first| Group {
        first,
        states: (end - first).min(L::LANES),
        lanes: PhantomData,
    })
}

impl<L: Lanes> Tile<L> {
    fn groups(&self) -> impl Iterator<Item = Group<L>> + use<L> {
        groups(self.first..self.first + self.states)
    }

    /// As [`Group::load`], one array a group.
    fn load<A: Array<L>>(&self, rows: &Rows<'_, L::Scalar>, values: &mut [A; GROUPS]) {
        if self.states < GROUPS * L::LANES {
            for (group, values) in self.groups().zip(values) {
                group.load(rows, values);
            }
            return;
        }
        let rows = rows.values.chunks_exact(rows.states);
        for (row, states) in rows.enumerate().take(A::LEN) {
            let states = states.get(self.first..).unwrap_or_default();
            for (values, states) in values.iter_mut().zip(states.chunks_exact(L::LANES)) {
                values[row] = L::load(states);
            }
        }
    }

    /// As [`Group::store`], one array a group.
    fn store<A: Array<L>>(&self, values: &[A; GROUPS], rows: &mut RowsMut<'_, L::Scalar>) {
        if self.states < GROUPS * L::LANES {
            for (group, values) in self.groups().zip(values) {
                group.store(values.as_ref(), rows);
            }
            return;
        }
        let rows = rows.values.chunks_exact_mut(rows.states);
        for (row, states) in rows.enumerate().take(A::LEN) {
            let states = states.get_mut(self.first..).unwrap_or_default();
            for (values, states) in values.iter().zip(states.chunks_exact_mut(L::LANES)) {
                values[row].store(states);
            }
        }
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
