//! JSON for people and for programs: a list or object of plain values stands on one line, all else is indented.

use std::io::{self, Write};

use kane_codegen::program::Operations;
use serde_json::{Value, json};

/// Writes the value and a line end.
pub(crate) fn write(out: &mut dyn Write, value: &Value) -> io::Result<()> {
    nested(out, value, 0)?;
    writeln!(out)
}

/// The numbers, row-major, as nested lists of these lengths; what is not finite becomes `null`, and zero has no sign.
pub(crate) fn array(numbers: &[f64], lengths: &[usize]) -> Value {
    match lengths {
        [] => numbers.first().map(|number| number + 0.0).into(),
        [_] => numbers.iter().map(|number| number + 0.0).collect(),
        [rows, inner @ ..] => {
            let size: usize = inner.iter().product();
            let rows = (0..*rows).map(|row| &numbers[row * size..][..size]);
            rows.map(|row| array(row, inner)).collect()
        }
    }
}

/// The operations of a function: all, then by kind.
pub(crate) fn operations(operations: &Operations) -> Value {
    let Operations {
        mul,
        add,
        div,
        trig,
    } = operations;
    json!({ "total": operations.total(), "mul": mul, "add": add, "div": div, "trig": trig })
}

fn nested(out: &mut dyn Write, value: &Value, depth: usize) -> io::Result<()> {
    let indent = |depth: usize| "  ".repeat(depth);
    let is_plain = |value: &Value| !value.is_array() && !value.is_object();
    match value {
        Value::Array(items) if !items.iter().all(is_plain) => {
            writeln!(out, "[")?;
            for (index, item) in items.iter().enumerate() {
                write!(out, "{}", indent(depth + 1))?;
                nested(out, item, depth + 1)?;
                writeln!(out, "{}", if index + 1 < items.len() { "," } else { "" })?;
            }
            write!(out, "{}]", indent(depth))
        }
        Value::Object(items) if !items.values().all(is_plain) => {
            writeln!(out, "{{")?;
            for (index, (key, item)) in items.iter().enumerate() {
                write!(out, "{}{}: ", indent(depth + 1), Value::from(key.as_str()))?;
                nested(out, item, depth + 1)?;
                writeln!(out, "{}", if index + 1 < items.len() { "," } else { "" })?;
            }
            write!(out, "{}}}", indent(depth))
        }
        Value::Array(items) => {
            let items: Vec<String> = items.iter().map(Value::to_string).collect();
            write!(out, "[{}]", items.join(", "))
        }
        Value::Object(items) => {
            let items = items.iter();
            let items: Vec<String> = items
                .map(|(key, item)| format!("{}: {item}", Value::from(key.as_str())))
                .collect();
            write!(out, "{{{}}}", items.join(", "))
        }
        plain => write!(out, "{plain}"),
    }
}
