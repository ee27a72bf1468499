//! Names of a module as C knows them: documentation speaks of constants, functions and structures by those of Rust.

use std::collections::{BTreeMap, BTreeSet};

use super::rules::{SCALARS, symbol};
use crate::{
    functions::{CATALOGUE, Declared, NOMINAL, PREPARE, SIN_COS, Signature},
    listing::Facts,
    words::{C_STRUCTURES, is_c_runtime},
};

/// The structures in Rust, in the order of [`C_STRUCTURES`].
const STRUCTURES: [&str; 3] = ["Parameters", "Prepared", "SinCos"];

/// The name in C of each name in Rust.
pub(super) struct Names {
    /// Of constants and structures.
    constants: BTreeMap<String, String>,
    /// Of functions, in double precision.
    functions: BTreeMap<String, String>,
}

/// True of functions of which texts speak: those of the catalogue, and what each module has. Other names are the user's.
fn is_told(name: &str) -> bool {
    let is_of_catalogue = CATALOGUE.iter().any(|function| function.name == name);
    is_of_catalogue || [NOMINAL, PREPARE, SIN_COS].contains(&name) || is_c_runtime(name)
}

impl Names {
    /// Those of the module `name`, with these functions.
    pub(super) fn of(facts: &Facts, name: &str, functions: &[&Signature]) -> Self {
        // A user's name may be spelt like one of ours: what is meant is then not known.
        let bodies = facts.bodies.iter().map(|body| &body.name);
        let frames = facts.frames.iter().map(|frame| &frame.name);
        let users: BTreeSet<&String> = bodies.chain(frames).collect();
        let is_ours = |(own, _): &(String, String)| !users.contains(own);
        let tables = facts.all_constants().into_iter();
        let tables = tables.chain(facts.prescribed_constant());
        let tables = tables.map(|constant| constant.name.to_owned());
        let sizes = facts.sizes.0.iter().map(|size| size.name.clone());
        let prefix = name.to_uppercase();
        let constants = sizes.chain(tables).map(|own| {
            let in_c = format!("{prefix}_{own}");
            (own, in_c)
        });
        let in_c = |own: &str| symbol(name, own, SCALARS[0]);
        let structures = STRUCTURES.into_iter().zip(C_STRUCTURES);
        let structures = structures.map(|(own, kind)| (own.to_owned(), in_c(kind)));
        let functions = functions.iter().map(|signature| &signature.name);
        let functions = functions.filter(|name| is_told(name));
        let functions = functions.map(|own| (own.clone(), in_c(own)));
        Self {
            constants: constants.chain(structures).filter(is_ours).collect(),
            functions: functions.filter(is_ours).collect(),
        }
    }

    /// A text of a function with these arguments. A name that is also an argument's means the function only directly behind the
    /// word `function`; behind `request` it is what is asked for.
    pub(super) fn renamed(&self, text: &str, arguments: &[Declared]) -> String {
        let mut renamed = String::new();
        for (place, piece) in text.split('`').enumerate() {
            if place > 0 {
                renamed.push('`');
            }
            let is_argument = arguments.iter().any(|argument| argument.name == piece);
            let is_function = !is_argument || renamed.ends_with("function `");
            let is_function = is_function && !renamed.ends_with("request `");
            let function = self.functions.get(piece).filter(|_| is_function);
            let own = self.constants.get(piece).or(function);
            // Every second piece stands between two backquotes.
            let own = own.filter(|_| place % 2 == 1);
            renamed.push_str(own.map_or(piece, String::as_str));
        }
        renamed
    }
}
