//! The plans of values, each searched for once.
//!
//! In: a tree, the techniques that may not be used, functions. Out: the cheapest [`Plan`] of each. A function, its derivatives
//! and products with these share one, on all threads; which of them asks first is of no account.

use std::{
    collections::{BTreeMap, BTreeSet},
    sync::{Arc, Mutex, OnceLock, PoisonError},
};

use crate::{
    functions::Request,
    recursive::{Plan, Technique},
    tree::Tree,
};

use super::search;

/// The plans that were found for a tree without some techniques.
#[derive(Debug)]
pub struct Plans<'a> {
    /// The tree.
    pub tree: &'a Tree,
    /// The techniques that are left out.
    pub without: &'a BTreeSet<Technique>,
    /// By functions as they are asked for. What one thread searches for another waits for.
    found: Mutex<BTreeMap<String, Arc<OnceLock<Plan>>>>,
}

impl<'a> Plans<'a> {
    /// None was found yet.
    pub fn new(tree: &'a Tree, without: &'a BTreeSet<Technique>) -> Self {
        Self {
            tree,
            without,
            found: Mutex::default(),
        }
    }

    /// The cheapest plan of a function that differentiates nothing.
    pub(super) fn of_values(&self, values: &Request) -> Plan {
        let found = {
            let mut found = self.found.lock().unwrap_or_else(PoisonError::into_inner);
            Arc::clone(found.entry(values.sum()).or_default())
        };
        let search = || search::plan(self.tree, values, self.without);
        found.get_or_init(search).clone()
    }
}
