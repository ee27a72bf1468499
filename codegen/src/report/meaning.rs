//! What `meanings` and `places` tell: a place that both modules have, under one name.

/// A place that means something else.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Meaning {
    /// What it is called.
    pub name: String,
    /// What it means in the old module.
    pub old: String,
    /// What it means in the new module.
    pub new: String,
}
