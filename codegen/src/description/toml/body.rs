//! A `[[body]]`: its own properties here, its joint's in [`joint`].

use crate::description::toml::{joint, value};
use crate::description::toml_reader::{Item, Reader, span};
use crate::description::{Given, INERTIA_COMPONENTS, Scalar, WrittenBody, WrittenJoint};

const KEYS: [&str; 5] = ["name", "mass", "mass_center", "inertia", "inertia_rotation"];

/// Reads a body, the `number`-th of the file.
pub(super) fn read(reader: &mut Reader, item: &Item<'_>, number: usize) -> WrittenBody {
    let mut body = WrittenBody {
        span: span(item),
        name: None,
        mass: None,
        mass_center: [None; 3],
        inertia: [None; 6],
        inertia_rotation: None,
        joint: WrittenJoint::unknown(),
    };
    let name = item
        .get_ref()
        .as_table()
        .and_then(|table| table.get("name"))
        .and_then(|name| name.get_ref().as_str());
    let owner = match name {
        Some(name) if !name.is_empty() => format!("body `{}`", name.escape_debug()),
        _ => format!("body {number}"),
    };
    let keys = [&KEYS[..], &joint::KEYS].concat();
    let Some(table) = reader.table(item, &owner, &keys) else {
        return body;
    };
    let name = reader.required(&table, "name", "name = \"rod\"");
    body.name = name.and_then(|item| reader.string(item, &table.what("name")));
    let mass = reader.required(&table, "mass", "mass = 1.0");
    body.mass = mass.and_then(|item| value::scalar(reader, item, &table.what("mass")));
    if let Some(item) = reader.required(&table, "mass_center", "mass_center = [0.0, 0.0, 0.0]") {
        body.mass_center = value::vector(reader, item, &table.what("mass_center"));
    }
    if let Some(item) = reader.required(
        &table,
        "inertia",
        "inertia = { xx = 1.0, yy = 1.0, zz = 1.0, xy = 0.0, xz = 0.0, yz = 0.0 }",
    ) {
        body.inertia = inertia(reader, item, &table.what("inertia"));
    }
    body.inertia_rotation = value::rotation(reader, &table, "inertia_rotation");
    body.joint = joint::read(reader, &table);
    body
}

fn inertia(reader: &mut Reader, item: &Item<'_>, what: &str) -> [Given<Scalar>; 6] {
    let Some(table) = reader.table(item, what, &INERTIA_COMPONENTS) else {
        return [None; 6];
    };
    INERTIA_COMPONENTS.map(|component| {
        let item = reader.required(&table, component, &format!("{component} = 0.0"))?;
        value::scalar(reader, item, &table.what(component))
    })
}
