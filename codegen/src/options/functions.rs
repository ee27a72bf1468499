//! Which functions are asked for.

use crate::functions::{Function, Parsed};

/// The functions to generate.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum Functions {
    /// The default set.
    #[default]
    Default,
    /// All of the system, and these: of frames, or joined.
    All(Vec<String>),
    /// These, in the order written.
    Named(Vec<String>),
}

/// What stands for all functions of the system.
pub const ALL: &str = "all";

impl Functions {
    /// Those of these names, among which `all` may be.
    pub fn of(names: impl IntoIterator<Item = String>) -> Self {
        let (all, others): (Vec<String>, Vec<String>) =
            names.into_iter().partition(|name| name == ALL);
        if all.is_empty() {
            Self::Named(others)
        } else {
            Self::All(others)
        }
    }

    /// The names, but for `all`.
    pub fn named(&self) -> &[String] {
        match self {
            Self::Default => &[],
            Self::All(names) | Self::Named(names) => names,
        }
    }

    /// Those that are named, in the order in which a module holds them, each once; names that are none are left out.
    pub fn requests(&self) -> Vec<Parsed> {
        let requests = self
            .named()
            .iter()
            .filter_map(|name| Parsed::read(name).ok());
        let mut requests: Vec<Parsed> = requests.collect();
        requests.sort_by_key(Parsed::place);
        requests.dedup_by_key(|request| request.place());
        requests
    }

    /// True where the function is among them.
    pub fn names(&self, function: &Function) -> bool {
        match self {
            Self::Default => function.is_default,
            Self::All(_) => true,
            Self::Named(names) => names.iter().any(|name| {
                let named = Parsed::read(name).ok();
                let named = named.and_then(|named| named.alone());
                named.is_some_and(|named| named.name == function.name)
            }),
        }
    }
}
