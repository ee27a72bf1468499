//! A `[[body]]`: its own properties here, its joint's in [`joint`].

use crate::description::toml::{joint, value};
use crate::description::toml_reader::{Item, Reader, span};
use crate::description::{Given, INERTIA_COMPONENTS, Scalar, WrittenBody, WrittenJoint};
use crate::diagnostic::{Span, shown_name};

const KEYS: [&str; 6] = [
    "name",
    "mass",
    "mass_center",
    "inertia",
    "inertia_rotation",
    "gravity_compensation",
];

/// A line that would do.
const INERTIA: &str = "inertia = { xx = 1.0, yy = 1.0, zz = 1.0, xy = 0.0, xz = 0.0, yz = 0.0 }";

/// Reads a body, the `number`-th of the file.
pub(super) fn read(reader: &mut Reader, item: &Item<'_>, number: usize) -> WrittenBody {
    let name = item
        .get_ref()
        .as_table()
        .and_then(|table| table.get("name"))
        .and_then(|name| name.get_ref().as_str());
    let owner = match name {
        Some(name) if !name.is_empty() => format!("body `{}`", shown_name(name)),
        _ => format!("body {number}"),
    };
    let keys = [&KEYS[..], &joint::KEYS].concat();
    let Some(table) = reader.table(item, &owner, &keys) else {
        return nothing(span(item));
    };
    let name = reader.required(&table, "name", "name = \"rod\"");
    let name = name.and_then(|item| reader.string(item, &table.what("name")));
    let mass = reader.required(&table, "mass", "mass = 1.0");
    let mass = mass.and_then(|item| value::scalar(reader, item, &table.what("mass")));
    let center = reader.required(&table, "mass_center", "mass_center = [0.0, 0.0, 0.0]");
    let mass_center = center.map_or([None; 3], |item| {
        value::vector(reader, item, &table.what("mass_center"))
    });
    let inertia_item = reader.required(&table, "inertia", INERTIA);
    let lifted = table.get("gravity_compensation");
    WrittenBody {
        span: span(item),
        name,
        mass,
        mass_center,
        inertia: inertia_item.map_or([None; 6], |item| {
            inertia(reader, item, &table.what("inertia"))
        }),
        inertia_rotation: value::rotation(reader, &table, "inertia_rotation"),
        gravity_compensation: lifted
            .and_then(|item| value::scalar(reader, item, &table.what("gravity_compensation"))),
        joint: joint::read(reader, &table),
    }
}

/// A body of which nothing can be read.
fn nothing(span: Span) -> WrittenBody {
    WrittenBody {
        span,
        name: None,
        mass: None,
        mass_center: [None; 3],
        inertia: [None; 6],
        inertia_rotation: None,
        gravity_compensation: None,
        joint: WrittenJoint::new(None, [None; 3]),
    }
}

fn inertia(reader: &mut Reader, item: &Item<'_>, what: &str) -> [Given<Scalar>; 6] {
    let Some(table) = reader.table_such_as(item, what, &INERTIA_COMPONENTS, INERTIA) else {
        return [None; 6];
    };
    reader.complete(
        &table,
        &INERTIA_COMPONENTS,
        "write 0.0 for those that are zero",
    );
    INERTIA_COMPONENTS.map(|component| {
        let item = table.get(component)?;
        value::scalar(reader, item, &table.what(component))
    })
}
