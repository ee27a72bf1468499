//! What a function gives names to.

use crate::id::BodyId;

/// A number with a name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Local {
    /// Its name: unique in the function, lower snake case.
    pub name: String,
    /// The body that it belongs to.
    pub body: Option<BodyId>,
}

/// Several numbers with one name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Array {
    /// Its name, as that of a local.
    pub name: String,
    /// How many.
    pub length: usize,
    /// How many stand in a row, where it is made of rows.
    pub row: Option<usize>,
}

/// A local, by its place among [`Code::locals`](super::Code::locals).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct LocalId(u32);

/// A local array, by its place among [`Code::arrays`](super::Code::arrays).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct ArrayId(u32);

impl Array {
    /// A name for an element.
    pub(in crate::listing) fn element(&self, place: usize) -> String {
        let Self { name, row, .. } = self;
        match row {
            Some(row) => format!("{name}_{}_{}", place / row, place % row),
            None => format!("{name}_{place}"),
        }
    }
}

impl LocalId {
    /// The local at this place.
    ///
    /// # Panics
    /// If `place` exceeds `u32::MAX`; no function comes near.
    pub fn new(place: usize) -> Self {
        Self(u32::try_from(place).expect("listing: fewer than 2^32 locals"))
    }

    /// Its place.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

impl ArrayId {
    /// The array at this place.
    ///
    /// # Panics
    /// If `place` exceeds `u32::MAX`; no function comes near.
    pub fn new(place: usize) -> Self {
        Self(u32::try_from(place).expect("listing: fewer than 2^32 arrays"))
    }

    /// Its place.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}
