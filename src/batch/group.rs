//! One vector of states.

use core::marker::PhantomData;
use core::ops::Range;

use super::rows::{LengthError, Rows, RowsMut};
use crate::Lanes;

/// Up to [`Lanes::LANES`] neighbouring states of a [`Batch`](super::Batch).
#[derive(Clone, Copy, Debug)]
pub struct Group<L> {
    first: usize,
    states: usize,
    /// The states of the whole batch.
    batch: usize,
    lanes: PhantomData<L>,
}

/// Groups of some of a batch's states.
pub(super) fn groups<L: Lanes>(
    states: Range<usize>,
    batch: usize,
) -> impl Iterator<Item = Group<L>> {
    let end = states.end;
    let groups = states.step_by(L::LANES.max(1));
    groups.map(move |first| Group {
        first,
        states: (end - first).min(L::LANES),
        batch,
        lanes: PhantomData,
    })
}

impl<L: Lanes> Group<L> {
    /// Reads the group's states from the first rows, one row per value; values beyond the last row do not change.
    ///
    /// # Errors
    /// The rows belong to a batch with another number of states; nothing is read then.
    #[inline]
    pub fn load(
        &self,
        rows: &Rows<'_, L::Scalar>,
        values: &mut impl AsMut<[L]>,
    ) -> Result<(), LengthError> {
        rows.shape.check_states(self.batch, rows.values.len())?;
        self.read(rows, values.as_mut());
        Ok(())
    }

    /// Writes the group's states to the first rows, one row per value; values beyond the last row are dropped.
    ///
    /// # Errors
    /// The rows belong to a batch with another number of states; nothing is written then.
    #[inline]
    pub fn store<'v>(
        &self,
        values: impl IntoIterator<Item = &'v L>,
        rows: &mut RowsMut<'_, L::Scalar>,
    ) -> Result<(), LengthError> {
        rows.shape.check_states(self.batch, rows.values.len())?;
        self.write(values, rows);
        Ok(())
    }

    /// Like [`Self::load`], for rows of the same batch.
    #[inline]
    pub(super) fn read(&self, rows: &Rows<'_, L::Scalar>, values: &mut [L]) {
        if self.states < L::LANES {
            return self.read_part(rows, values);
        }
        for (row, value) in values.iter_mut().enumerate() {
            let row = rows.values.get(self.first(row)..);
            if let Some(row) = row.and_then(|row| row.get(..L::LANES)) {
                *value = L::load(row);
            }
        }
    }

    /// Like [`Self::store`], for rows of the same batch.
    #[inline]
    pub(super) fn write<'v>(
        &self,
        values: impl IntoIterator<Item = &'v L>,
        rows: &mut RowsMut<'_, L::Scalar>,
    ) {
        if self.states < L::LANES {
            return self.write_part(values, rows);
        }
        for (row, value) in values.into_iter().enumerate() {
            let row = rows.values.get_mut(self.first(row)..);
            if let Some(row) = row.and_then(|row| row.get_mut(..L::LANES)) {
                value.store(row);
            }
        }
    }

    // Groups of fewer states than there are lanes: apart, so that full ones need not look at each row.

    #[cold]
    #[inline(never)]
    fn read_part(&self, rows: &Rows<'_, L::Scalar>, values: &mut [L]) {
        for (row, value) in values.iter_mut().enumerate() {
            let row = rows.values.get(self.first(row)..);
            if let Some(row) = row.and_then(|row| row.get(..self.states)) {
                *value = L::load(row);
            }
        }
    }

    #[cold]
    #[inline(never)]
    fn write_part<'v>(
        &self,
        values: impl IntoIterator<Item = &'v L>,
        rows: &mut RowsMut<'_, L::Scalar>,
    ) {
        for (row, value) in values.into_iter().enumerate() {
            let row = rows.values.get_mut(self.first(row)..);
            if let Some(row) = row.and_then(|row| row.get_mut(..self.states)) {
                value.store(row);
            }
        }
    }

    /// The place of the group in a row.
    #[inline]
    fn first(&self, row: usize) -> usize {
        row.wrapping_mul(self.batch).wrapping_add(self.first)
    }
}
