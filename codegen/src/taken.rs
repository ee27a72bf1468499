//! Names that are taken: another thing gets a name like it.

use std::collections::BTreeSet;

/// Names that are taken.
#[derive(Clone, Debug, Default)]
pub(crate) struct Taken(BTreeSet<String>);

impl Taken {
    /// The name, with as many `_` behind it as make it a free one.
    pub(crate) fn free(&self, mut name: String) -> String {
        while self.0.contains(&name) {
            name.push('_');
        }
        name
    }

    /// The same, which is taken from now on.
    pub(crate) fn take(&mut self, name: String) -> String {
        let name = self.free(name);
        self.0.insert(name.clone());
        name
    }
}

impl<'a> FromIterator<&'a str> for Taken {
    fn from_iter<I: IntoIterator<Item = &'a str>>(names: I) -> Self {
        Self(names.into_iter().map(str::to_owned).collect())
    }
}
