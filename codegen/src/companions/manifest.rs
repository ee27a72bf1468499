//! The manifest: what a module holds, as JSON for programs that do not read Rust.
//!
//! What is known only of a compiled function, its stack and its size, is not here.

use super::json::{list, object, string, strings};
use crate::{
    emit::{Emittable, Module},
    functions::{Argument, Request},
    origin::OUTPUT_FORMAT,
    program::Operations,
};

/// A key a line, and a function a line.
pub(super) fn text(module: &Module<'_>) -> String {
    let (tree, origin) = (module.tree, &module.origin);
    let hash = |hash: u64| string(&format!("{hash:016x}"));
    let functions = module.functions.iter();
    let functions: Vec<String> = functions
        .map(|emittable| format!("    {}", function(module, emittable)))
        .collect();
    let members = [
        // The sign of the format.
        ("generated_by", string("kane generate")),
        ("model", string(&origin.model)),
        ("input", hash(origin.input)),
        ("fingerprint", hash(origin.fingerprint)),
        ("format", OUTPUT_FORMAT.to_string()),
        ("options", string(&origin.options)),
        ("name", string(&tree.name)),
        ("NB", tree.bodies.len().to_string()),
        ("NQ", tree.n_coordinates.to_string()),
        ("NU", tree.n_speeds.to_string()),
        ("bodies", strings(tree.bodies.iter().map(|body| &body.name))),
        ("coordinates", strings(tree.coordinate_names())),
        ("speeds", strings(tree.speed_names())),
        ("preparation", operations(module.preparation.operations())),
        ("functions", format!("[\n{}\n  ]", functions.join(",\n"))),
    ];
    let members = members.map(|(key, value)| format!("  {}: {value}", string(key)));
    format!("{{\n{}\n}}\n", members.join(",\n"))
}

fn function(module: &Module<'_>, emittable: &Emittable) -> String {
    let function = &emittable.function;
    let n_columns = emittable.program.stores.len() / 3;
    let outputs = function.outputs().into_iter().map(|output| {
        let shape = list(output.shape.lengths(module.tree, n_columns));
        object(&[("name", string(&output.name)), ("shape", shape)])
    });
    object(&[
        ("name", string(&function.name())),
        ("arguments", strings(arguments(function))),
        ("outputs", list(outputs)),
        ("formulation", string(emittable.formulation.name())),
        ("operations", operations(emittable.operations)),
        ("fused", emittable.program.fused().to_string()),
    ])
}

/// The inputs, in the order of the call.
fn arguments(function: &Request) -> Vec<&'static str> {
    let mut names = vec!["p"];
    for argument in function.arguments() {
        names.push(argument.name());
        if argument == Argument::Q && function.is_at_sin_cos() {
            names.push("sin_cos");
        }
    }
    names
}

fn operations(operations: Operations) -> String {
    let Operations {
        mul,
        add,
        div,
        trig,
    } = operations;
    let counts = [
        ("total", operations.total()),
        ("mul", mul),
        ("add", add),
        ("div", div),
        ("trig", trig),
    ];
    object(&counts.map(|(kind, count)| (kind, count.to_string())))
}
