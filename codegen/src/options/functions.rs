//! Which functions are asked for.

use std::collections::BTreeSet;

use crate::{
    diagnostic::NearNames,
    functions::{ALL, DEFAULT, Function, Parsed, Request, RequestError, is_set},
    tree::Tree,
};

/// The functions to generate.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Functions {
    /// The default set, and these.
    Default(Vec<String>),
    /// All of the system, and these: of frames, or joined.
    All(Vec<String>),
    /// These, in the order written.
    Named(Vec<String>),
}

impl Default for Functions {
    fn default() -> Self {
        Self::Default(Vec::new())
    }
}

impl Functions {
    /// Those of these names, among which `all` and `default` may be.
    pub fn of(names: impl IntoIterator<Item = String>) -> Self {
        let (sets, others): (Vec<String>, Vec<String>) =
            names.into_iter().partition(|name| is_set(name));
        let has = |set: &str| sets.iter().any(|name| name == set);
        if has(ALL) {
            Self::All(others)
        } else if has(DEFAULT) {
            let is_more = |name: &String| {
                !catalogue_function(name).is_some_and(|function| function.is_default)
            };
            Self::Default(others.into_iter().filter(is_more).collect())
        } else {
            Self::Named(others)
        }
    }

    /// The names, but for `all` and `default`.
    pub fn named(&self) -> &[String] {
        match self {
            Self::Default(names) | Self::All(names) | Self::Named(names) => names,
        }
    }

    /// True where the set that is asked for, if one is, has the function.
    pub fn set_has(&self, function: &Function) -> bool {
        match self {
            Self::Default(_) => function.is_default,
            Self::All(_) => true,
            Self::Named(_) => false,
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

    /// The same on the tree of a model; what writes one frame in several ways is one request.
    ///
    /// # Errors
    /// All that the model lacks.
    pub fn on(&self, tree: &Tree) -> Result<Vec<Request>, Vec<RequestError>> {
        let (mut requests, mut faults) = (Vec::new(), Vec::new());
        let mut known = BTreeSet::new();
        let mut near = NearNames::default();
        for named in self.requests() {
            match named.on_with(tree, &mut near) {
                Ok(request) if known.insert(request.text()) => requests.push(request),
                Ok(_) => {}
                Err(more) => faults.extend(more),
            }
        }
        if faults.is_empty() {
            Ok(requests)
        } else {
            Err(faults)
        }
    }

    /// True where the function is among them.
    pub fn names(&self, function: &Function) -> bool {
        let is_named = |name: &String| {
            catalogue_function(name).is_some_and(|named| named.name == function.name)
        };
        self.set_has(function) || self.named().iter().any(is_named)
    }
}

/// True for what `all` has: whoever names both has mistaken one of them.
pub fn is_in_all(name: &str) -> bool {
    name == DEFAULT || catalogue_function(name).is_some()
}

/// The function that a name asks for, if it asks for one alone.
fn catalogue_function(name: &str) -> Option<&'static Function> {
    Parsed::read(name)
        .ok()
        .and_then(|named| named.catalogue_function())
}
