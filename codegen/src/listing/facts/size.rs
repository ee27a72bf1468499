//! Lengths of arrays that have names.

use crate::functions::Length;

/// The size that counts the angles among the coordinates.
pub(crate) const N_ANGLES: &str = "NA";

/// A size with a name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Size {
    /// The name: `NQ`.
    pub name: String,
    /// The size.
    pub value: usize,
    /// What it is, beside the functions that have it.
    pub doc: String,
    /// What it is, where these are not in sight.
    pub brief: &'static str,
}

/// The sizes of a module.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Sizes(pub Vec<Size>);

impl Sizes {
    /// The size with this name.
    pub fn named(&self, name: &str) -> Option<&Size> {
        self.0.iter().find(|size| size.name == name)
    }

    /// The number of elements of an array of this length.
    ///
    /// # Panics
    /// Where no size has the name: signatures and sizes are made from the same functions.
    pub fn length(&self, length: &Length) -> usize {
        match length {
            Length::Number(number) => *number,
            Length::Constant(name) => {
                let size = self.named(name);
                size.unwrap_or_else(|| unreachable!("listing: no size `{name}`"))
                    .value
            }
        }
    }
}
