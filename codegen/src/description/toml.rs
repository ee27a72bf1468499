//! Our own format, TOML.
//!
//! `name`, `lower_bodies` and of every `[[body]]` the `name`, `mass`, `mass_center`, `inertia`, `attachment` and
//! `joint` must be written, also where they are zero: physics has no hidden defaults. `gravity` (zero), `order`
//! (`"body"`) and `locked` (zero) may be absent.

use crate::description::read::{Item, Reader, Table, list, span};
use crate::description::{
    Axis, Body, Description, Given, INERTIA_COMPONENTS, Joint, JointKind, Scalar,
};
use crate::diagnostic::{Diagnostic, Source, Span, Spanned, nearest};
use crate::tree::Order;

const ROOT_KEYS: [&str; 5] = ["name", "gravity", "lower_bodies", "order", "body"];
const BODY_KEYS: [&str; 7] = [
    "name",
    "mass",
    "mass_center",
    "inertia",
    "attachment",
    "joint",
    "locked",
];
const ORDERS: [(&str, Order); 2] = [("body", Order::Body), ("notes", Order::Notes)];

/// Reads a description; what is wrong stands in [`Description::faults`].
pub fn parse(source: &Source) -> Description {
    let mut reader = Reader::default();
    let document = reader.document(source);
    let start = Span { start: 0, end: 0 };
    let mut description = Description {
        source: source.clone(),
        name: None,
        gravity: [Some(Spanned::new(Scalar::Baked(0.0), start)); 3],
        lower_bodies: None,
        order: Some(Spanned::new(Order::Body, start)),
        bodies: Vec::new(),
        faults: Vec::new(),
    };
    // A file that is not TOML has lost its keys; that they are missing would be no news.
    if !(document.is_empty() && reader.has_faults()) {
        read(&mut reader, &document, &mut description);
    }
    description.faults = reader.faults;
    description
}

fn read(reader: &mut Reader, document: &::toml::de::DeTable<'_>, description: &mut Description) {
    let root = reader.root(document, &ROOT_KEYS);
    let name = reader.required(&root, "name", "name = \"pendulum\"");
    description.name = name.and_then(|item| reader.string(item, "`name`"));
    if let Some(item) = root.get("gravity") {
        description.gravity = vector(reader, item, "`gravity`");
    }
    let lower = reader.required(&root, "lower_bodies", "lower_bodies = [0, 1, 1]");
    description.lower_bodies = lower.and_then(|item| lower_bodies(reader, item));
    if let Some(item) = root.get("order") {
        description.order = order(reader, item);
    }
    if let Some(item) = reader.required(&root, "body", "[[body]]") {
        let items = reader
            .list(item, "`body`", "tables, `[[body]]`")
            .unwrap_or_default();
        description.bodies = items
            .iter()
            .enumerate()
            .map(|(index, item)| body(reader, item, index + 1))
            .collect();
    }
}

fn lower_bodies(reader: &mut Reader, item: &Item<'_>) -> Given<Vec<Given<i64>>> {
    let entries = reader.list(item, "`lower_bodies`", "whole numbers")?;
    let numbers = entries.iter().enumerate();
    let numbers = numbers.map(|(index, entry)| {
        reader.integer(entry, &format!("entry {} of `lower_bodies`", index + 1))
    });
    Some(Spanned::new(numbers.collect(), span(item)))
}

fn order(reader: &mut Reader, item: &Item<'_>) -> Given<Order> {
    let text = reader.string(item, "`order`")?;
    let found = ORDERS.iter().find(|(name, _)| *name == text.value);
    if found.is_none() {
        let fault = format!(
            "`order` is `{}`; expected `body` or `notes`",
            text.value.escape_debug()
        );
        reader
            .faults
            .push(Diagnostic::error(fault).at(text.span, "unknown order"));
    }
    found.map(|(_, order)| Spanned::new(*order, text.span))
}

fn body(reader: &mut Reader, item: &Item<'_>, number: usize) -> Body {
    let mut body = Body {
        span: span(item),
        name: None,
        mass: None,
        mass_center: [None; 3],
        inertia: [None; 6],
        inertia_rotation: None,
        joint: Joint::unknown(),
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
    let Some(table) = reader.table(item, &owner, &BODY_KEYS) else {
        return body;
    };
    let name = reader.required(&table, "name", "name = \"rod\"");
    body.name = name.and_then(|item| reader.string(item, &table.what("name")));
    let mass = reader.required(&table, "mass", "mass = 1.0");
    body.mass = mass.and_then(|item| scalar(reader, item, &table.what("mass")));
    if let Some(item) = reader.required(&table, "mass_center", "mass_center = [0.0, 0.0, 0.0]") {
        body.mass_center = vector(reader, item, &table.what("mass_center"));
    }
    if let Some(item) = reader.required(
        &table,
        "inertia",
        "inertia = { xx = 1.0, yy = 1.0, zz = 1.0, xy = 0.0, xz = 0.0, yz = 0.0 }",
    ) {
        body.inertia = inertia(reader, item, &table.what("inertia"));
    }
    if let Some(item) = reader.required(&table, "attachment", "attachment = [0.0, 0.0, 0.0]") {
        body.joint.attachment = vector(reader, item, &table.what("attachment"));
    }
    let joint_item = reader.required(&table, "joint", "joint = [\"theta1\"]");
    body.joint.kind = joint_item.and_then(|item| joint(reader, item, &table.what("joint")));
    body.joint.locked = locked(reader, &table);
    body
}

fn vector(reader: &mut Reader, item: &Item<'_>, what: &str) -> [Given<Scalar>; 3] {
    let Some(entries) = reader.list(item, what, "3 numbers") else {
        return [None; 3];
    };
    if entries.len() != 3 {
        let n = entries.len();
        let fault = format!(
            "{what} has {n} {}; expected 3",
            if n == 1 { "entry" } else { "entries" }
        );
        reader
            .faults
            .push(Diagnostic::error(fault).at(span(item), "expected 3 numbers"));
    }
    let mut vector = [None; 3];
    for (index, entry) in entries.iter().enumerate() {
        let value = scalar(reader, entry, &format!("entry {} of {what}", index + 1));
        if let Some(place) = vector.get_mut(index) {
            *place = value;
        }
    }
    vector
}

fn inertia(reader: &mut Reader, item: &Item<'_>, what: &str) -> [Given<Scalar>; 6] {
    let Some(table) = reader.table(item, what, &INERTIA_COMPONENTS) else {
        return [None; 6];
    };
    INERTIA_COMPONENTS.map(|component| {
        let item = reader.required(&table, component, &format!("{component} = 0.0"))?;
        scalar(reader, item, &table.what(component))
    })
}

/// A number, or `{ runtime = number }`.
fn scalar(reader: &mut Reader, item: &Item<'_>, what: &str) -> Given<Scalar> {
    if item.get_ref().as_table().is_none() {
        return reader
            .number(item, what)
            .map(|number| Spanned::new(Scalar::Baked(number.value), number.span));
    }
    let table = reader.table(item, what, &["runtime"])?;
    let nominal = reader.required(&table, "runtime", "{ runtime = 1.0 }")?;
    let number = reader.number(nominal, &table.what("runtime"))?;
    Some(Spanned::new(Scalar::Runtime(number.value), number.span))
}

fn joint(reader: &mut Reader, item: &Item<'_>, what: &str) -> Given<JointKind> {
    let help = format!(
        "a joint is \"free\", or a list of those of {} that are free to move",
        list(&Axis::NAMES)
    );
    if let Some(text) = item.get_ref().as_str() {
        if text == "free" {
            return Some(Spanned::new(JointKind::Free, span(item)));
        }
        let fault = Diagnostic::error(format!(
            "{what} is `{}`, which is no joint",
            text.escape_debug()
        ));
        reader
            .faults
            .push(fault.at(span(item), "unknown joint").help(help));
        return None;
    }
    let entries = reader.list(item, what, "coordinates, or \"free\"")?;
    let before = reader.faults.len();
    let mut axes: Vec<Spanned<Axis>> = Vec::new();
    for (index, entry) in entries.iter().enumerate() {
        let Some(name) = reader.string(entry, &format!("entry {} of {what}", index + 1)) else {
            continue;
        };
        let Some(axis) = axis(reader, &name.value, name.span, what) else {
            continue;
        };
        if let Some(first) = axes.iter().find(|other| other.value == axis) {
            let fault = Diagnostic::error(format!("{what} lists `{}` twice", axis.name()));
            reader.faults.push(
                fault
                    .at(name.span, "the second one")
                    .at(first.span, "the first one"),
            );
        } else {
            axes.push(Spanned::new(axis, name.span));
        }
    }
    // With an entry lost, what moves and what does not is unknown, and judging it would mislead.
    (reader.faults.len() == before).then(|| Spanned::new(JointKind::List(axes), span(item)))
}

fn axis(reader: &mut Reader, name: &str, span: Span, what: &str) -> Option<Axis> {
    let axis = Axis::named(name);
    if axis.is_none() {
        let fault = Diagnostic::error(format!(
            "{what} names `{}`, which is no coordinate",
            name.escape_debug()
        ));
        let help = match nearest(name, &Axis::NAMES) {
            Some(near) => format!("did you mean `{near}`?"),
            None => format!("the coordinates are {}", list(&Axis::NAMES)),
        };
        reader
            .faults
            .push(fault.at(span, "unknown coordinate").help(help));
    }
    axis
}

fn locked(reader: &mut Reader, body: &Table<'_, '_>) -> Vec<(Spanned<Axis>, Given<f64>)> {
    let Some(item) = body.get("locked") else {
        return Vec::new();
    };
    let what = body.what("locked");
    // The keys are looked at one by one below: an unknown one is an unknown coordinate.
    let Some(table) = reader.any_table(item, &what) else {
        return Vec::new();
    };
    let mut locked = Vec::new();
    for (key, value) in table.entries() {
        let Some(axis) = axis(reader, key.value, key.span, &what) else {
            continue;
        };
        let number = if value.get_ref().as_table().is_some() {
            let fault = format!(
                "{} is a table; a locked value must be a number, it cannot be set at run time",
                table.what(key.value)
            );
            reader
                .faults
                .push(Diagnostic::error(fault).at(span(value), "expected a number"));
            None
        } else {
            reader.number(value, &table.what(key.value))
        };
        locked.push((Spanned::new(axis, key.span), number));
    }
    locked
}
