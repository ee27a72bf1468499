//! How a module is called through C: names and types that the header declares.

use super::syntax::{object, string};
use crate::{
    listing::Module,
    options::companion::HEADER,
    printers::c::rules::{SCALARS, scalar_type, symbol},
};

/// With `prefix`, the module's name, all names in C begin, and those of files. An object with the header, C's names of the scalars, and the functions that write what others are given, a line each.
pub(super) fn member(module: &Module, prefix: &str) -> String {
    let scalars = SCALARS.map(|scalar| (scalar, string(scalar_type(scalar))));
    let mut members = vec![
        ("header", string(&format!("{prefix}{HEADER}"))),
        ("scalars", object(&scalars)),
    ];
    let others = [&module.nominal, &module.prepare].into_iter();
    members.extend(others.chain(&module.sin_cos).map(|function| {
        let own = function.signature.name.as_str();
        (own, symbols(prefix, own))
    }));
    let lines = members.into_iter();
    let lines: Vec<String> = lines
        .map(|(key, value)| format!("    {}: {value}", string(key)))
        .collect();
    format!("{{\n{}\n  }}", lines.join(",\n"))
}

/// The names of a function for each scalar.
pub(super) fn symbols(prefix: &str, function: &str) -> String {
    object(&SCALARS.map(|scalar| (scalar, string(&symbol(prefix, function, scalar)))))
}
