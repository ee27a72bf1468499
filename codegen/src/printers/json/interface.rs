//! How a module is called through C: names and types that the header declares.

use super::syntax::{object, string};
use crate::{
    listing::Module,
    printers::c::rules::{SCALARS, c_name, symbol},
};

/// An object with the header, C's names of the scalars, and the functions that write what others are given, a line each.
pub(super) fn member(module: &Module, name: &str) -> String {
    let scalars = SCALARS.map(|scalar| (scalar, string(c_name(scalar))));
    let mut members = vec![
        ("header", string(&format!("{name}.h"))),
        ("scalars", object(&scalars)),
    ];
    let others = [&module.nominal, &module.prepare].into_iter();
    members.extend(others.chain(&module.sin_cos).map(|function| {
        let own = function.signature.name.as_str();
        (own, symbols(name, own))
    }));
    let lines = members.into_iter();
    let lines: Vec<String> = lines
        .map(|(key, value)| format!("    {}: {value}", string(key)))
        .collect();
    format!("{{\n{}\n  }}", lines.join(",\n"))
}

/// The names of a function for each scalar.
pub(super) fn symbols(module: &str, function: &str) -> String {
    object(&SCALARS.map(|scalar| (scalar, string(&symbol(module, function, scalar)))))
}
