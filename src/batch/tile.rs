//! Several groups, read and written row by row.
//!
//! Rows are often a power of two apart, and then their lines compete for one cache set: it is faster to take
//! several groups from each row than to return to it for each group.

use core::marker::PhantomData;
use core::ops::Range;

use super::group::{self, Group};
use super::rows::{Rows, RowsMut};
use crate::{Array, Lanes};

/// The usual number of groups of a [`Tile`]: their states fill at least whole cache lines of a row.
pub(super) const USUAL_GROUPS: usize = 8;

/// Neighbouring groups of a batch.
pub(super) struct Tile<L, const GROUPS: usize> {
    first: usize,
    states: usize,
    /// The states of the whole batch.
    batch: usize,
    lanes: PhantomData<L>,
}

/// An input: its rows, and its numbers in the groups of a tile.
pub(super) struct Input<'a, L: Lanes, A, const GROUPS: usize> {
    rows: Rows<'a, L::Scalar>,
    pub(super) groups: [A; GROUPS],
}

/// An output: its rows, and its numbers in the groups of a tile.
pub(super) struct Output<'a, L: Lanes, A, const GROUPS: usize> {
    rows: RowsMut<'a, L::Scalar>,
    pub(super) groups: [A; GROUPS],
}

/// The tiles of a batch, in the order of the states; the last one may be smaller than the others.
pub(super) fn tiles<L: Lanes, const GROUPS: usize>(
    batch: usize,
) -> impl Iterator<Item = Tile<L, GROUPS>> {
    let size = GROUPS * L::LANES.max(1);
    (0..batch).step_by(size).map(move |first| Tile {
        first,
        states: (batch - first).min(size),
        batch,
        lanes: PhantomData,
    })
}

impl<L: Lanes, const GROUPS: usize> Tile<L, GROUPS> {
    pub(super) fn groups(&self) -> impl Iterator<Item = Group<L>> + use<L, GROUPS> {
        group::groups(self.first..self.first + self.states, self.batch)
    }

    /// The places of the groups in the arrays of [`Input`] and [`Output`].
    pub(super) fn places(&self) -> Range<usize> {
        // The smaller of both lets the optimizer see that no place is beyond the end.
        0..self.states.div_ceil(L::LANES.max(1)).min(GROUPS)
    }

    /// True where all groups are there, and full.
    fn is_full(&self) -> bool {
        self.states == GROUPS * L::LANES
    }
}

impl<'a, L: Lanes, A: Array<L>, const GROUPS: usize> Input<'a, L, A, GROUPS> {
    pub(super) fn new(rows: Rows<'a, L::Scalar>) -> Self {
        let groups = [A::filled(L::from_f64(0.0)); GROUPS];
        Self { rows, groups }
    }

    /// Like [`Group::load`], one array per group.
    pub(super) fn load(&mut self, tile: &Tile<L, GROUPS>) {
        if !tile.is_full() {
            for (group, values) in tile.groups().zip(&mut self.groups) {
                group.read(&self.rows, values.as_mut());
            }
            return;
        }
        let rows = self.rows.values.chunks_exact(tile.batch);
        for (row, states) in rows.enumerate().take(A::LEN) {
            let states = states.get(tile.first..).unwrap_or_default();
            for (values, states) in self.groups.iter_mut().zip(states.chunks_exact(L::LANES)) {
                values[row] = L::load(states);
            }
        }
    }
}

impl<'a, L: Lanes, A: Copy, const GROUPS: usize> Output<'a, L, A, GROUPS> {
    pub(super) fn new(rows: RowsMut<'a, L::Scalar>, zero: A) -> Self {
        let groups = [zero; GROUPS];
        Self { rows, groups }
    }

    /// Like [`Group::store`], one output per group; `entry` gives the value for each row.
    pub(super) fn store(&mut self, tile: &Tile<L, GROUPS>, entry: impl Fn(&A, usize) -> &L) {
        if !tile.is_full() {
            let n_rows = self.rows.shape.rows;
            for (group, values) in tile.groups().zip(&self.groups) {
                let entries = (0..n_rows).map(|row| entry(values, row));
                group.write(entries, &mut self.rows);
            }
            return;
        }
        let rows = self.rows.values.chunks_exact_mut(tile.batch);
        for (row, states) in rows.enumerate() {
            let states = states.get_mut(tile.first..).unwrap_or_default();
            for (values, states) in self.groups.iter().zip(states.chunks_exact_mut(L::LANES)) {
                entry(values, row).store(states);
            }
        }
    }
}
