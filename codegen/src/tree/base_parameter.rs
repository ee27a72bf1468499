//! Combinations of inertial parameters.

use std::sync::OnceLock;

use super::inertial::InertialParameter;

/// A combination of inertial parameters: the sum of each times its factor.
///
/// The first one is the combination's own: it has the factor one and stands in no other, and its column of the regressor is the
/// combination's.
#[derive(Clone, Debug, PartialEq)]
pub struct BaseParameter {
    /// Its own parameter, then the others by body and place, each with its factor.
    pub terms: Vec<(InertialParameter, f64)>,
}

/// The base parameters of a tree, once they are asked for. A tree that is copied may be changed, and finds its own.
#[derive(Debug, Default)]
pub struct BaseParameters(OnceLock<Vec<BaseParameter>>);

impl BaseParameters {
    /// Those that are known, or what `find` finds.
    pub(crate) fn get_or_find(
        &self,
        find: impl FnOnce() -> Vec<BaseParameter>,
    ) -> &[BaseParameter] {
        self.0.get_or_init(find)
    }

    /// The same for a tree with other numbers, whose columns are to be those of this one.
    pub(crate) fn kept(&self) -> Self {
        Self(self.0.clone())
    }
}

impl Clone for BaseParameters {
    fn clone(&self) -> Self {
        Self::default()
    }
}
