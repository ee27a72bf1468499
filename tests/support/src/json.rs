//! The numbers of reference files.

use serde_json::Value;

/// The numbers of a nested list, row-major.
///
/// # Panics
/// If anything in it is no number.
pub fn flat(value: &Value) -> Vec<f64> {
    match value {
        Value::Array(items) => items.iter().flat_map(flat).collect(),
        number => vec![number.as_f64().expect("a number")],
    }
}
