//! JSON for people and for programs: a list or object of plain values, or a list of places, stands on one line, all else is indented.

use std::io::{self, Write};

use kane_codegen::program::Operations;
use serde_json::{Value, json};

/// Writes the value and a line end.
pub(crate) fn write(out: &mut dyn Write, value: &Value) -> io::Result<()> {
    nested(out, value, 0)?;
    writeln!(out)
}

/// Writes an object of several values, whose keys keep this order, and a line end.
pub(crate) fn write_object(out: &mut dyn Write, items: &[(String, Value)]) -> io::Result<()> {
    object(out, items.iter().map(|(key, item)| (key.as_str(), item)), 0)?;
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
    match value {
        Value::Array(items) if !items.iter().all(|item| is_plain(item) || is_pair(item)) => {
            writeln!(out, "[")?;
            for (index, item) in items.iter().enumerate() {
                write!(out, "{}", indent(depth + 1))?;
                nested(out, item, depth + 1)?;
                writeln!(out, "{}", if index + 1 < items.len() { "," } else { "" })?;
            }
            write!(out, "{}]", indent(depth))
        }
        Value::Array(items) => {
            write!(out, "[")?;
            for (index, item) in items.iter().enumerate() {
                nested(out, item, depth)?;
                write!(out, "{}", if index + 1 < items.len() { ", " } else { "" })?;
            }
            write!(out, "]")
        }
        Value::Object(items) if !items.values().all(is_plain) => {
            let items = items.iter();
            object(out, items.map(|(key, item)| (key.as_str(), item)), depth)
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

/// An object, a line or more for each item.
fn object<'v>(
    out: &mut dyn Write,
    items: impl ExactSizeIterator<Item = (&'v str, &'v Value)>,
    depth: usize,
) -> io::Result<()> {
    writeln!(out, "{{")?;
    let last = items.len();
    for (place, (key, item)) in (1..).zip(items) {
        write!(out, "{}{}: ", indent(depth + 1), Value::from(key))?;
        nested(out, item, depth + 1)?;
        writeln!(out, "{}", if place < last { "," } else { "" })?;
    }
    write!(out, "{}}}", indent(depth))
}

fn indent(depth: usize) -> String {
    "  ".repeat(depth)
}

fn is_plain(value: &Value) -> bool {
    !value.is_array() && !value.is_object()
}

/// True for a row and a column.
fn is_pair(value: &Value) -> bool {
    let places = value.as_array();
    places.is_some_and(|own| own.len() == 2 && own.iter().all(Value::is_u64))
}
