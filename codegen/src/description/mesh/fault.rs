//! What is wrong with a mesh.

/// What to do with a mesh that is too large.
pub(super) const SIMPLIFY: &str = "simplify the mesh, or give the body an `inertial`";

/// What is wrong with a mesh, in words that stand after its name, and what to do.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Fault {
    /// "has 3 points; expected at least 4".
    pub(crate) found: String,
    /// What to do, where that is more than to mend the file.
    pub(crate) advice: Option<&'static str>,
}

impl Fault {
    /// A fault of the file.
    pub(super) fn new(found: impl Into<String>) -> Self {
        Self {
            found: found.into(),
            advice: None,
        }
    }

    /// The same with advice.
    pub(super) fn help(mut self, advice: &'static str) -> Self {
        self.advice = Some(advice);
        self
    }
}
