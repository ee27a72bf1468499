//! What is asked for, of one system: everything that decides what is written, but for the model itself.
//!
//! In: what a user said, in `kane.toml`, on the command line or in a build script. Out: [`Options`], whole when they exist.
//! Does not: read any of these, or judge what no type rules out; `compile` refuses that.
//!
//! A new option is a field here, and the compiler then asks for it wherever options are taken apart or put together: in
//! `words`, for it stands in the banner; in [`config`](crate::config), where its key is read; among the flags of the command
//! (`cli/arguments/options.rs`). What it does not ask for is a method of [`Build`](crate::build_script::Build), and the use.

pub mod companion;
mod formulation;
mod functions;
mod names;
mod words;

use std::{collections::BTreeSet, ops::Range};

pub use formulation::Formulation;
pub use functions::{Functions, is_in_all};

use crate::{
    description::Reading,
    functions::{CATALOGUE, Function, Request, RequestError},
    recursive::Technique,
    tree::{Changes, Tree},
};

/// The tolerances to which constant rotations may be snapped: beyond, a joint would be another one.
pub const SNAP_TOLERANCES: Range<f64> = 0.0..1e-2;

/// How a model is read, what is changed of it, and what is generated.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Options {
    /// What a URDF or MJCF leaves to the user.
    pub reading: Reading,
    /// What is changed of the description.
    pub changes: Changes,
    /// The joints whose accelerations are given, where forces of the others are, by their names or those of their bodies.
    pub prescribed: Vec<String>,
    /// Which functions. `q_dot` is always among them, and with quaternions `normalize`: the runtime's trait `System` needs
    /// them.
    pub functions: Functions,
    /// In which formulation.
    pub formulation: Formulation,
    /// Whether functions fuse products into sums, `Real::mul_add`: faster where the hardware has that, but the last bits
    /// then depend on the machine. `Prepared::new` does not.
    pub fma: bool,
    /// The techniques to leave out.
    pub without: BTreeSet<Technique>,
    /// What else is written, beside the module.
    pub companions: BTreeSet<companion::CompanionKind>,
    /// The module's name, that of its file without the ending, for what is beside it and speaks of it. Where nothing is, it
    /// says nothing.
    pub module: String,
}

impl Options {
    /// True where the function is to be generated.
    pub fn selects(&self, tree: &Tree, function: &Function) -> bool {
        function.is_always_generated(tree.has_quaternions()) || self.functions.names(function)
    }

    /// What is to be generated, in the order of a module.
    ///
    /// # Errors
    /// All that the model lacks; else two functions, outputs or constants of one name.
    pub fn requests(&self, tree: &Tree) -> Result<Vec<Request>, Vec<RequestError>> {
        let catalogue = CATALOGUE.iter();
        let selected = catalogue.filter(|function| self.selects(tree, function));
        let mut requests: Vec<Request> = selected.map(Request::from).collect();
        let is_selected = |request: &Request| {
            let part = request.catalogue_part();
            part.is_some_and(|part| part.subject.is_none())
        };
        let named = self.functions.on(tree)?.into_iter();
        requests.extend(named.filter(|request| !is_selected(request)));
        let faults = names::faults(&requests);
        if faults.is_empty() {
            Ok(requests)
        } else {
            Err(faults)
        }
    }
}
