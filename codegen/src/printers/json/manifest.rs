//! The manifest: what a module holds and how it is called through C, as JSON for programs that do not read Rust.
//!
//! What is known only of a compiled function, its stack and its size, is not here.

use super::{
    arguments, constants, geometry, interface,
    syntax::{number, object, records, string, strings},
};
use crate::{
    functions::{N_BODIES, N_COORDINATES, N_SPEEDS},
    listing::{Facts, Function, Module},
    origin::OUTPUT_FORMAT,
    program::Operations,
    tree::Parameter,
};

/// The manifest of a module; `prefix` is what its names begin with in C, if its functions can be called from there.
///
/// A key a line, and a joint, frame, parameter, constant and function a line.
pub(crate) fn text(module: &Module, prefix: Option<&str>) -> String {
    let facts = &module.facts;
    let mut members = identity(facts);
    members.extend(system(facts));
    let parameters = facts.parameters.iter().map(parameter);
    let joints = facts.joints.iter().map(geometry::joint);
    let frames = facts.frames.iter().chain(&facts.markers);
    members.extend([
        ("joints", records(joints)),
        ("frames", records(frames.map(geometry::frame))),
        ("parameters", records(parameters)),
        ("prepared", facts.fields.len().to_string()),
        ("preparation", operations(module.prepare.operations)),
        ("constants", constants::member(facts)),
    ]);
    members.extend(prefix.map(|prefix| ("c", interface::member(module, prefix))));
    let functions = module.functions.iter();
    let functions = functions.map(|one| function(facts, one, prefix));
    members.push(("functions", records(functions)));
    let members = members.into_iter();
    let members: Vec<String> = members
        .map(|(key, value)| format!("  {}: {value}", string(key)))
        .collect();
    format!("{{\n{}\n}}\n", members.join(",\n"))
}

/// Where the module comes from.
fn identity(facts: &Facts) -> Vec<(&'static str, String)> {
    let origin = &facts.origin;
    vec![
        // The sign of the format.
        ("generated_by", string("kane generate")),
        ("model", string(&origin.model)),
        ("input", string(&origin.input_text())),
        (
            "fingerprint",
            string(&format!("{:016x}", origin.fingerprint)),
        ),
        ("format", OUTPUT_FORMAT.to_string()),
        ("options", string(&origin.options)),
        ("name", string(&facts.name)),
    ]
}

/// Sizes, names and units.
fn system(facts: &Facts) -> Vec<(&'static str, String)> {
    let bodies = facts.bodies.iter().map(|body| &body.name);
    let units = &facts.units;
    let mut members = vec![
        (N_BODIES, facts.bodies.len().to_string()),
        (N_COORDINATES, facts.coordinates.len().to_string()),
        (N_SPEEDS, facts.speeds.len().to_string()),
        ("bodies", strings(bodies)),
        ("coordinates", strings(&facts.coordinates)),
        ("coordinate_units", strings(&units.coordinates)),
        ("speeds", strings(&facts.speeds)),
        ("speed_units", strings(&units.speeds)),
        ("force_units", strings(&units.forces)),
    ];
    if let Some(prescribed) = &facts.prescribed {
        let speeds = facts.speeds.iter().zip(prescribed);
        let speeds = speeds.filter_map(|(speed, is_prescribed)| is_prescribed.then_some(speed));
        members.push(("prescribed", strings(speeds)));
    }
    members
}

fn parameter(parameter: &Parameter) -> String {
    object(&[
        ("name", string(&parameter.name)),
        ("nominal", number(parameter.nominal)),
        ("unit", string(parameter.unit)),
    ])
}

fn function(facts: &Facts, function: &Function, prefix: Option<&str>) -> String {
    let signature = &function.signature;
    let mut members = vec![("name", string(&signature.name))];
    let request = function.request.as_deref();
    members.extend(request.map(|request| ("request", string(request))));
    members.extend(prefix.map(|prefix| ("symbols", interface::symbols(prefix, &signature.name))));
    members.extend(arguments::members(facts, signature));
    members.extend([
        ("formulation", string(function.formulation.name())),
        ("operations", operations(function.operations)),
        ("fused", function.fused.to_string()),
    ]);
    object(&members)
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
