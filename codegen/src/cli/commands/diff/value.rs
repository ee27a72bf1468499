//! What differs, for programs.

use kane_codegen::{
    diagnostic::{Diagnostics, Severity},
    report::{Body, Change, Counted, FormChange, LayoutChange, Meaning, Redeclared, ValueChange},
};
use serde_json::{Value, json};

use super::{report::Report, systems::Systems};
use crate::cli::text::json;

pub(super) fn of_systems(systems: &Systems) -> Value {
    json!({
        "old": systems.names[0],
        "new": systems.names[1],
        "same": systems.is_same(),
        "breaking": systems.is_breaking(),
        "added": systems.added,
        "removed": systems.removed,
        "systems": systems.changed.iter().map(of_report).collect::<Value>(),
        "warnings": systems.warnings().map(warning).collect::<Value>(),
    })
}

pub(super) fn of_report(report: &Report) -> Value {
    let differences = &report.differences;
    let functions = &report.functions;
    let [old, new] = report.fingerprints;
    let fingerprint = |hash: Option<u64>| hash.map(|hash| format!("{hash:016x}"));
    json!({
        "old": report.names[0],
        "new": report.names[1],
        "same": report.is_same(),
        "breaking": report.is_breaking(),
        "fingerprints": { "old": fingerprint(old), "new": fingerprint(new) },
        "layouts": differences.layouts.iter().map(layout).collect::<Value>(),
        "bodies": {
            "added": differences.added.iter().map(body).collect::<Value>(),
            "removed": differences.removed.iter().map(body).collect::<Value>(),
            "renamed": differences.renamed.iter().map(renamed).collect::<Value>(),
        },
        "values": differences.values.iter().map(value_change).collect::<Value>(),
        "functions": {
            "changed": functions.changed.iter().map(change).collect::<Value>(),
            "added": functions.added.iter().map(function).collect::<Value>(),
            "removed": functions.removed.iter().map(function).collect::<Value>(),
            "redeclared": report.redeclared.iter().map(redeclared).collect::<Value>(),
        },
        "options": report.options.iter().map(option).collect::<Value>(),
        "meanings": report.meanings.iter().map(meaning).collect::<Value>(),
        "base_parameters": report.base.as_ref().map(meaning),
        "constants": report.held.iter().map(meaning).collect::<Value>(),
        "forms": report.forms.iter().map(form).collect::<Value>(),
        "warnings": warnings(report),
        "diff": report.diff,
    })
}

/// A warning about a model, of those of all systems.
fn warning([model, message]: [&str; 2]) -> Value {
    json!({ "model": model, "message": message })
}

fn warnings(report: &Report) -> Vec<&str> {
    let all = report.warnings.iter().flat_map(Diagnostics::list);
    let warnings = all.filter(|one| one.severity != Severity::Note);
    warnings.map(|one| one.message.as_str()).collect()
}

fn redeclared(change: &Redeclared) -> Value {
    json!({ "name": change.name, "old": change.old, "new": change.new })
}

fn option((key, [old, new]): (&String, &[Option<String>; 2])) -> Value {
    json!({ "key": key, "old": old, "new": new })
}

fn meaning(change: &Meaning) -> Value {
    json!({ "name": change.name, "old": change.old, "new": change.new })
}

fn form(change: &FormChange) -> Value {
    json!({ "name": change.name, "reasons": change.reasons })
}

fn layout(change: &LayoutChange) -> Value {
    let place = |(name, place): &(String, usize)| json!({ "name": name, "place": place });
    let moved =
        |(name, [old, new]): &(String, [usize; 2])| json!({ "name": name, "old": old, "new": new });
    let renamed = |([old, new], place): &([String; 2], usize)| json!({ "old": old, "new": new, "place": place });
    json!({
        "array": change.layout.name(),
        "added": change.added.iter().map(place).collect::<Value>(),
        "removed": change.removed.iter().map(place).collect::<Value>(),
        "moved": change.moved.iter().map(moved).collect::<Value>(),
        "renamed": change.renamed.iter().map(renamed).collect::<Value>(),
    })
}

fn body(body: &Body) -> Value {
    json!({ "name": body.name, "values": body.values })
}

fn renamed([old, new]: &[String; 2]) -> Value {
    json!({ "old": old, "new": new })
}

fn value_change(change: &ValueChange) -> Value {
    json!({ "body": change.body, "key": change.key, "old": change.old, "new": change.new })
}

fn change(change: &Change) -> Value {
    json!({ "name": change.name, "old": counted(&change.old), "new": counted(&change.new) })
}

fn function((name, operations): &(String, Counted)) -> Value {
    json!({ "name": name, "operations": counted(operations) })
}

fn counted(counted: &Counted) -> Value {
    let mut value = json::operations(&counted.operations);
    value["formulation"] = json!(counted.formulation);
    value
}
