//! A `[[frame]]`.

use crate::description::toml::value;
use crate::description::toml_reader::{Item, Reader, Table, span};
use crate::description::{Carrier, FrameRotation, Given, WrittenFrame};
use crate::diagnostic::{Diagnostic, Escaped, Spanned};

const KEYS: [&str; 4] = ["name", "body", "position", "rotation"];

/// Reads a frame, the `number`-th of the file.
pub(super) fn read(reader: &mut Reader, item: &Item<'_>, number: usize) -> WrittenFrame {
    let name = item.get_ref().as_table();
    let name = name.and_then(|table| table.get("name"));
    let owner = match name.and_then(|name| name.get_ref().as_str()) {
        Some(name) if !name.is_empty() => format!("frame `{}`", name.escaped()),
        _ => format!("frame {number}"),
    };
    let nothing = WrittenFrame::new(span(item), None);
    let Some(table) = reader.table(item, &owner, &KEYS) else {
        return nothing;
    };
    let name = reader.required(&table, "name", "name = \"tool0\"");
    let body = table.get("body");
    let position = table.get("position");
    WrittenFrame {
        name: name.and_then(|item| reader.string(item, &table.what("name"))),
        body: body.map_or(Carrier::Inertial, |item| {
            Carrier::Body(reader.string(item, &table.what("body")))
        }),
        position: position.map_or(nothing.position, |item| {
            value::vector(reader, item, &table.what("position"))
        }),
        rotation: match table.get("rotation") {
            Some(item) => rotation(reader, &table, item),
            None => nothing.rotation,
        },
        ..nothing
    }
}

/// A rotation matrix by rows, or `{ runtime = [[..], [..], [..]] }`.
fn rotation(reader: &mut Reader, frame: &Table<'_, '_>, item: &Item<'_>) -> Given<FrameRotation> {
    let what = frame.what("rotation");
    let example = "{ runtime = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] }";
    if item.get_ref().as_table().is_none() {
        if let Some(entry) = entries(item).find(|entry| value::is_at_run_time(entry)) {
            let fault = format!(
                "{what} has an entry that is set at run time; all of it can be: expected `{example}`"
            );
            let fault = Diagnostic::error(fault).at(span(entry), "expected a number");
            reader.faults.push(fault);
            return None;
        }
        let rotation = value::rotation(reader, frame, "rotation")?;
        return Some(Spanned::new(
            FrameRotation::Baked(rotation.value),
            rotation.span,
        ));
    }
    let table = reader.table(item, &what, &["runtime"])?;
    reader.required(&table, "runtime", example)?;
    let nominal = value::rotation(reader, &table, "runtime")?;
    let rows = FrameRotation::Runtime(nominal.value);
    Some(Spanned::new(rows, nominal.span))
}

/// The entries of lists in a list.
fn entries<'i, 'd>(rows: &'i Item<'d>) -> impl Iterator<Item = &'i Item<'d>> {
    let of = |item: &'i Item<'d>| item.get_ref().as_array().into_iter().flatten();
    of(rows).flat_map(of)
}
