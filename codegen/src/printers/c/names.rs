//! Names of a module as C knows them: documentation speaks of constants, functions and structures by those of Rust.

use std::collections::BTreeMap;

use super::rules::{SCALARS, symbol};
use crate::{
    functions::{Declared, Signature},
    listing::Facts,
    words::C_STRUCTURES,
};

/// The structures in Rust, in the order of [`C_STRUCTURES`].
const STRUCTURES: [&str; 3] = ["Parameters", "Prepared", "SinCos"];

/// By each name in Rust that in C.
pub(super) struct Names {
    constants: BTreeMap<String, String>,
    functions: BTreeMap<String, String>,
}

impl Names {
    /// Those of the module `name`, with these functions.
    pub(super) fn of(facts: &Facts, name: &str, functions: &[&Signature]) -> Self {
        let prefix = name.to_uppercase();
        let tables = facts.all_constants().into_iter();
        let tables = tables.chain(facts.prescribed_constant());
        let tables = tables.map(|constant| constant.name.to_owned());
        let sizes = facts.sizes.0.iter().map(|size| size.name.clone());
        let constants = sizes.chain(tables).map(|constant| {
            let in_c = format!("{prefix}_{constant}");
            (constant, in_c)
        });
        let of_structures = STRUCTURES.into_iter().zip(C_STRUCTURES);
        let of_structures =
            of_structures.map(|(own, kind)| (own.to_owned(), symbol(name, kind, SCALARS[0])));
        let functions = functions.iter().map(|signature| {
            let own = signature.name.clone();
            let in_c = symbol(name, &own, SCALARS[0]);
            (own, in_c)
        });
        Self {
            constants: constants.chain(of_structures).collect(),
            functions: functions.collect(),
        }
    }

    /// A text of a function with these arguments; the name of an argument is a function's only behind that word.
    pub(super) fn renamed(&self, text: &str, arguments: &[Declared]) -> String {
        let mut renamed = String::new();
        for (place, piece) in text.split('`').enumerate() {
            if place > 0 {
                renamed.push('`');
            }
            let is_argument = arguments.iter().any(|argument| argument.name == piece);
            let is_function = !is_argument || renamed.ends_with("function `");
            let function = self.functions.get(piece).filter(|_| is_function);
            let own = self.constants.get(piece).or(function);
            // Every second piece stands between two backquotes.
            let own = own.filter(|_| place % 2 == 1);
            renamed.push_str(own.map_or(piece, String::as_str));
        }
        renamed
    }
}
