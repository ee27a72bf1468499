//! Quantities of a batch in memory: row by row, each row one number of every state.

use core::error::Error;
use core::fmt;

/// A quantity of every state of a batch, row by row, for reading: [`Batch::rows`](super::Batch::rows).
#[derive(Clone, Copy, Debug)]
pub struct Rows<'a, T> {
    pub(super) values: &'a [T],
    pub(super) shape: Size,
}

/// Like [`Rows`], for writing: [`Batch::rows_mut`](super::Batch::rows_mut).
#[derive(Debug)]
pub struct RowsMut<'a, T> {
    pub(super) values: &'a mut [T],
    pub(super) shape: Size,
}

/// How many rows a quantity has, and for which batch.
#[derive(Clone, Copy, Debug)]
pub(super) struct Size {
    pub(super) argument: &'static str,
    pub(super) rows: usize,
    pub(super) states: usize,
}

/// A slice has the wrong length: not its rows times the batch's states, or for groups not the number of groups.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LengthError {
    /// The name of the argument.
    pub argument: &'static str,
    /// Its length.
    pub found: usize,
    /// The number of rows that it should have; for groups one.
    pub rows: usize,
    /// The number of states, or groups, in a row.
    pub states: usize,
}

impl Size {
    /// Refuses a slice of another length.
    pub(super) fn check(self, found: usize) -> Result<(), LengthError> {
        if self.rows.checked_mul(self.states) == Some(found) {
            Ok(())
        } else {
            Err(self.error(found))
        }
    }

    /// Refuses a slice for another batch.
    #[inline]
    pub(super) fn check_states(self, states: usize, found: usize) -> Result<(), LengthError> {
        if self.states == states {
            Ok(())
        } else {
            Err(Self { states, ..self }.error(found))
        }
    }

    #[cold]
    fn error(self, found: usize) -> LengthError {
        let Self {
            argument,
            rows,
            states,
        } = self;
        LengthError {
            argument,
            found,
            rows,
            states,
        }
    }
}

impl fmt::Display for LengthError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            argument,
            found,
            rows,
            states,
        } = self;
        write!(f, "`{argument}` has a length of {found}; expected ")?;
        match rows {
            1 => write!(f, "{states}"),
            _ => write!(f, "{rows} rows of {states}"),
        }
    }
}

impl Error for LengthError {}
