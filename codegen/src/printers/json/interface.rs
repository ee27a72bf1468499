//! How a module is called through C: names and types that the header declares.

use super::{
    arguments,
    syntax::{inner_records, object, string},
};
use crate::{
    listing::Module,
    options::companion::HEADER,
    printers::c::{
        rules::{SCALARS, scalar_type, symbol},
        runtime,
    },
    words::C_INPUT,
};

/// With `prefix`, the module's name, all names in C begin, and those of files. An object with the header, C's names of the scalars, the functions
/// that write what others are given, and those of the runtime crate, a line each.
pub(super) fn member(module: &Module, prefix: &str) -> String {
    let scalars = SCALARS.map(|scalar| (scalar, string(scalar_type(scalar))));
    let mut members = vec![
        ("header", string(&format!("{prefix}{HEADER}"))),
        (C_INPUT, string(&format!("{prefix}_{C_INPUT}"))),
        ("scalars", object(&scalars)),
    ];
    let others = [&module.nominal, &module.prepare].into_iter();
    members.extend(others.chain(&module.sin_cos).map(|function| {
        let own = function.signature.name.as_str();
        (own, symbols(prefix, own))
    }));
    let runtime = runtime::of(module);
    let runtime = runtime.iter().map(|function| {
        let signature = &function.signature;
        let mut members = vec![
            ("name", string(&signature.name)),
            ("symbols", symbols(prefix, &signature.name)),
        ];
        members.extend(arguments::members(&module.facts, signature));
        object(&members)
    });
    members.push(("runtime", inner_records(runtime)));
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
