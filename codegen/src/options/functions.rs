//! Which functions are asked for.

use crate::functions::{Function, Parsed};

/// The functions to generate.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum Functions {
    /// The default set.
    #[default]
    Default,
    /// All there are.
    All,
    /// These, in the order written.
    Named(Vec<String>),
}

impl Functions {
    /// Those that are named, in the order in which a module holds them, each once; names that are none are left out.
    pub fn requests(&self) -> Vec<Parsed> {
        let names: &[String] = match self {
            Self::Default | Self::All => &[],
            Self::Named(names) => names,
        };
        let requests = names.iter().filter_map(|name| Parsed::read(name).ok());
        let mut requests: Vec<Parsed> = requests.collect();
        requests.sort_by_key(Parsed::place);
        requests.dedup_by_key(|request| request.place());
        requests
    }

    /// True where the function is among them.
    pub fn names(&self, function: &Function) -> bool {
        match self {
            Self::Default => function.is_default,
            Self::All => true,
            Self::Named(names) => names.iter().any(|name| {
                let named = Parsed::read(name).ok();
                let named = named.and_then(|named| named.alone());
                named.is_some_and(|named| named.name == function.name)
            }),
        }
    }
}
