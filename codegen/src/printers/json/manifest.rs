//! The manifest: what a module holds, as JSON for programs that do not read Rust.
//!
//! What is known only of a compiled function, its stack and its size, is not here.

use super::{
    constants,
    syntax::{list, object, string, strings},
};
use crate::{
    functions::{N_BODIES, N_COORDINATES, N_SPEEDS},
    generate::OUTPUT_FORMAT,
    listing::{Facts, Function, Module},
    program::Operations,
};

/// A key a line, and a function a line.
pub(crate) fn text(module: &Module) -> String {
    let facts = &module.facts;
    let origin = &facts.origin;
    let hash = |hash: u64| string(&format!("{hash:016x}"));
    let functions = module.functions.iter();
    let functions: Vec<String> = functions
        .map(|one| format!("    {}", function(facts, one)))
        .collect();
    let mut members = vec![
        // The sign of the format.
        ("generated_by", string("kane generate")),
        ("model", string(&origin.model)),
        ("input", hash(origin.input)),
        ("fingerprint", hash(origin.fingerprint)),
        ("format", OUTPUT_FORMAT.to_string()),
        ("options", string(&origin.options)),
        ("name", string(&facts.name)),
        (N_BODIES, facts.bodies.len().to_string()),
        (N_COORDINATES, facts.coordinates.len().to_string()),
        (N_SPEEDS, facts.speeds.len().to_string()),
        (
            "bodies",
            strings(facts.bodies.iter().map(|body| &body.name)),
        ),
        ("coordinates", strings(&facts.coordinates)),
        ("speeds", strings(&facts.speeds)),
        ("preparation", operations(module.prepare.operations)),
        ("functions", format!("[\n{}\n  ]", functions.join(",\n"))),
    ];
    if let Some(prescribed) = &facts.prescribed {
        let speeds = facts.speeds.iter().zip(prescribed);
        let speeds = speeds.filter_map(|(speed, is_prescribed)| is_prescribed.then_some(speed));
        members.insert(members.len() - 1, ("prescribed", strings(speeds)));
    }
    let constants = constants::member(facts).map(|member| ("constants", member));
    if let Some(constants) = constants {
        members.insert(members.len() - 1, constants);
    }
    let members = members.into_iter();
    let members: Vec<String> = members
        .map(|(key, value)| format!("  {}: {value}", string(key)))
        .collect();
    format!("{{\n{}\n}}\n", members.join(",\n"))
}

fn function(facts: &Facts, function: &Function) -> String {
    let outputs = function.outputs().map(|output| {
        let shape = list(facts.extent(output).lengths());
        object(&[("name", string(&output.name)), ("shape", shape)])
    });
    let arguments = function.inputs().map(|input| &input.name);
    object(&[
        ("name", string(&function.signature.name)),
        ("arguments", strings(arguments)),
        ("outputs", list(outputs)),
        ("formulation", string(function.formulation.name())),
        ("operations", operations(function.operations)),
        ("fused", function.fused.to_string()),
    ])
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
