//! Many states at once: each input and output is an array of one quantity for all states, and each lane of a vector holds one state.
//!
//! A quantity of a batch of `n` states is a slice of rows: `q[0]` of every state, then `q[1]` of every state, and so on. So `q` has
//! `NQ n` numbers, `tau` has `NU n`, and a mass matrix has `NU NU n`, with the entry `m[r][c]` in row `NU r + c`. States need no order and
//! no padding. If the last group of lanes is not full, it is computed with repeated states, and the repeated results are not stored.
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
//! If a program keeps its states for long, keep them in groups: a slice of the arrays that the functions take, `[[L; NQ]]`, each with
//! [`Lanes::LANES`] states. The methods `.._of_groups` use these in place, without reading and writing rows,
//! which takes about half of a batch's time. [`Batch::to_groups`] and [`Batch::from_groups`] convert. Use rows if other code
//! (`NumPy`, a recorder, a GPU) wants each number of all states side by side.
//!
//! ```
//! # #[cfg(all(feature = "eight_body", feature = "wide"))] {
//! use kane::batch::{Batch, Widest};
//! use kane::eight_body::{NQ, NU, Prepared};
//!
//! const N: usize = 10;
//! let (batch, system) = (Batch::<Widest>::new(N), Prepared::<Widest>::nominal());
//! let zero = <Widest as kane::Real>::from_f64(0.0);
//! let mut q = vec![[zero; NQ]; batch.n_groups()];
//! batch.to_groups(&vec![0.1; NQ * N], &mut q)?;
//! let (u, u_dot) = (vec![[zero; NU]; q.len()], vec![[zero; NU]; q.len()]);
//! let mut tau = vec![[zero; NU]; q.len()];
//! batch.inverse_dynamics_of_groups(&system, &q, &u, &u_dot, &mut tau)?;
//! # }
//! # Ok::<(), kane::batch::LengthError>(())
//! ```
//!
//! Every lane has the bits that the same function gives for that state alone. The usual functions are methods of
//! [`Batch`]; for any other, loop over its groups:
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
//!     group.load(&q, &mut one_q)?;
//!     group.load(&u, &mut one_u)?;
//!     system.kinetic_energy(&one_q, &one_u, &mut energy);
//!     group.store([&energy], &mut energies)?;
//! }
//! # }
//! # Ok::<(), kane::batch::LengthError>(())
//! ```

mod group;
mod grouped;
mod rows;
mod tile;

use core::marker::PhantomData;

use rows::Size;
use tile::{Input, Output, USUAL_GROUPS};

use crate::functions::{Bias, ForwardDynamics, InverseDynamics, MassMatrix, MassMatrixPacked};
use crate::{Array, Lanes, System};

pub use group::Group;
pub use rows::{LengthError, Rows, RowsMut};

/// The most bytes of a tile's matrices, which are on the stack.
const MOST_ON_STACK: usize = 1 << 18;

/// The vector of `f64` that the target of the program has: eight lanes with AVX-512, four with AVX, else two (SSE2, Neon).
#[cfg(all(feature = "wide", target_feature = "avx512f"))]
pub type Widest = ::wide::f64x8;
/// The vector of `f64` that the target of the program has: eight lanes with AVX-512, four with AVX, else two (SSE2, Neon).
#[cfg(all(
    feature = "wide",
    target_feature = "avx",
    not(target_feature = "avx512f")
))]
pub type Widest = ::wide::f64x4;
/// The vector of `f64` that the target of the program has: eight lanes with AVX-512, four with AVX, else two (SSE2, Neon).
#[cfg(all(feature = "wide", not(target_feature = "avx")))]
pub type Widest = ::wide::f64x2;

/// A batch of states, computed [`Lanes::LANES`] at a time.
#[derive(Clone, Copy, Debug)]
pub struct Batch<L> {
    states: usize,
    lanes: PhantomData<L>,
}

impl<L: Lanes> Batch<L> {
    /// A batch with this number of states.
    #[must_use]
    pub fn new(states: usize) -> Self {
        Self {
            states,
            lanes: PhantomData,
        }
    }

    /// The groups, in the order of the states; the last one may be smaller than the others.
    pub fn groups(self) -> impl Iterator<Item = Group<L>> {
        group::groups(0..self.states, self.states)
    }

    /// A quantity with this many `rows`, for reading; `argument` is its name in the error.
    ///
    /// # Errors
    /// The slice is not `rows` times as long as there are states.
    pub fn rows<'a>(
        &self,
        argument: &'static str,
        values: &'a [L::Scalar],
        rows: usize,
    ) -> Result<Rows<'a, L::Scalar>, LengthError> {
        let shape = self.shape(argument, rows);
        shape.check(values.len())?;
        Ok(Rows { values, shape })
    }

    /// Like [`Self::rows`], for writing.
    ///
    /// # Errors
    /// The slice is not `rows` times as long as there are states.
    pub fn rows_mut<'a>(
        &self,
        argument: &'static str,
        values: &'a mut [L::Scalar],
        rows: usize,
    ) -> Result<RowsMut<'a, L::Scalar>, LengthError> {
        let shape = self.shape(argument, rows);
        shape.check(values.len())?;
        Ok(RowsMut { values, shape })
    }

    fn shape(&self, argument: &'static str, rows: usize) -> Size {
        Size {
            argument,
            rows,
            states: self.states,
        }
    }

    /// [`MassMatrix::mass_matrix`] of every state, entry `m[r][c]` in row `NU r + c`.
    ///
    /// For many states these matrices do not fit in the cache: [`Self::mass_matrix_packed`] writes half of them or less.
    ///
    /// # Errors
    /// A slice of the wrong length; nothing is written then.
    pub fn mass_matrix<S: MassMatrix<L>>(
        &self,
        system: &S,
        q: &[L::Scalar],
        m: &mut [L::Scalar],
    ) -> Result<(), LengthError> {
        let q = self.rows("q", q, S::Q::LEN)?;
        let m = self.rows_mut("m", m, S::U::LEN * S::U::LEN)?;
        let zero = S::Matrix::filled(S::U::filled(L::from_f64(0.0)));
        let function = |q: &S::Q, m: &mut S::Matrix| system.mass_matrix(q, m);
        self.matrices(q, m, zero, function, |m, row| {
            &m[row / S::U::LEN][row % S::U::LEN]
        });
        Ok(())
    }

    /// [`MassMatrixPacked::mass_matrix_packed`] of every state, one row for each of [`MassMatrixPacked::PLACES`].
    ///
    /// # Errors
    /// A slice of the wrong length; nothing is written then.
    pub fn mass_matrix_packed<S: MassMatrixPacked<L>>(
        &self,
        system: &S,
        q: &[L::Scalar],
        entries: &mut [L::Scalar],
    ) -> Result<(), LengthError> {
        let q = self.rows("q", q, S::Q::LEN)?;
        let entries = self.rows_mut("entries", entries, S::Entries::LEN)?;
        let zero = S::Entries::filled(L::from_f64(0.0));
        let function = |q: &S::Q, m: &mut S::Entries| system.mass_matrix_packed(q, m);
        self.matrices(q, entries, zero, function, |entries, row| &entries[row]);
        Ok(())
    }

    /// Reads the coordinates tile by tile; a tile has as many groups as there is room for their matrices.
    fn matrices<Q: Array<L>, M: Copy>(
        &self,
        q: Rows<'_, L::Scalar>,
        m: RowsMut<'_, L::Scalar>,
        zero: M,
        function: impl Fn(&Q, &mut M),
        entry: impl Fn(&M, usize) -> &L,
    ) {
        match MOST_ON_STACK / size_of::<M>().max(1) {
            0..2 => self.tiled::<Q, M, 1>(q, m, zero, function, entry),
            2..4 => self.tiled::<Q, M, 2>(q, m, zero, function, entry),
            4..8 => self.tiled::<Q, M, 4>(q, m, zero, function, entry),
            _ => self.tiled::<Q, M, USUAL_GROUPS>(q, m, zero, function, entry),
        }
    }

    fn tiled<Q: Array<L>, M: Copy, const GROUPS: usize>(
        &self,
        q: Rows<'_, L::Scalar>,
        m: RowsMut<'_, L::Scalar>,
        zero: M,
        function: impl Fn(&Q, &mut M),
        entry: impl Fn(&M, usize) -> &L,
    ) {
        let mut q = Input::<L, Q, GROUPS>::new(q);
        let mut m = Output::<L, M, GROUPS>::new(m, zero);
        for tile in tile::tiles(self.states) {
            q.load(&tile);
            for group in tile.places() {
                function(&q.groups[group], &mut m.groups[group]);
            }
            m.store(&tile, &entry);
        }
    }
}

/// Methods that take a function's arguments tile by tile, and write its output, an array as these.
macro_rules! methods {
    ($(
        $(#[$documentation:meta])*
        $function:ident: $trait:ident($($argument:ident: $given:ident),+) -> $output:ident: $written:ident;
    )+) => {
        impl<L: Lanes> Batch<L> {$(
            $(#[$documentation])*
            ///
            /// # Errors
            /// A slice of the wrong length; nothing is written then.
            pub fn $function<S: $trait<L>>(
                &self,
                system: &S,
                $($argument: &[L::Scalar],)+
                $output: &mut [L::Scalar],
            ) -> Result<(), LengthError> {
                $(let rows = self.rows(stringify!($argument), $argument, S::$given::LEN)?;
                let mut $argument = Input::<L, S::$given, USUAL_GROUPS>::new(rows);)+
                let rows = self.rows_mut(stringify!($output), $output, S::$written::LEN)?;
                let zero = S::$written::filled(L::from_f64(0.0));
                let mut $output = Output::<L, S::$written, USUAL_GROUPS>::new(rows, zero);
                for tile in tile::tiles(self.states) {
                    $($argument.load(&tile);)+
                    for group in tile.places() {
                        let output = &mut $output.groups[group];
                        system.$function($(&$argument.groups[group],)+ output);
                    }
                    $output.store(&tile, |values, row| &values[row]);
                }
                Ok(())
            }
        )+}
    };
}

methods! {
    /// [`System::q_dot`] of every state.
    q_dot: System(q: Q, u: U) -> q_dot: Q;
    /// [`Bias::bias`] of every state.
    bias: Bias(q: Q, u: U) -> bias: U;
    /// [`InverseDynamics::inverse_dynamics`] of every state.
    inverse_dynamics: InverseDynamics(q: Q, u: U, u_dot: U) -> tau: U;
    /// [`ForwardDynamics::forward_dynamics`] of every state.
    forward_dynamics: ForwardDynamics(q: Q, u: U, tau: U) -> u_dot: U;
}
