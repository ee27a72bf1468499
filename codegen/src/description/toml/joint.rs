//! The joint of a `[[body]]` with its lower body.

use crate::description::elsewhere;
use crate::description::toml::value;
use crate::description::toml_reader::{Item, Reader, Table, span};
use crate::description::{
    Chart, CoordinateName, Given, JointKind, Limits, Mimic, Optional, PerCoordinate, Scalar,
    Speeds, WrittenJoint,
};
use crate::diagnostic::{Diagnostic, Escaped, Spanned, backquoted, nearest};

/// The keys of a body that are about its joint.
pub(super) const KEYS: [&str; 17] = [
    "attachment",
    "attachment_rotation",
    "body_attachment",
    "body_rotation",
    "joint",
    "joint_name",
    "axis",
    "locked",
    "chart",
    "speeds",
    "stiffness",
    "rest",
    "damping",
    "armature",
    "friction",
    "limits",
    "mimic",
];
const LIMIT_KEYS: [&str; 4] = ["lower", "upper", "velocity", "effort"];
const MIMIC_KEYS: [&str; 3] = ["joint", "multiplier", "offset"];

/// Reads what a body's table says of its joint.
pub(super) fn read(reader: &mut Reader, body: &Table<'_, '_>) -> WrittenJoint {
    let attachment = reader.required(body, "attachment", "attachment = [0.0, 0.0, 0.0]");
    let attachment = attachment.map_or([None; 3], |item| {
        value::vector(reader, item, &body.what("attachment"))
    });
    let kind_item = reader.required(body, "joint", "joint = [\"theta1\"]");
    let kind = kind_item.and_then(|item| kind(reader, item, &body.what("joint")));
    let axis = axis(reader, body, kind.as_ref());
    let name = body.get("joint_name");
    let name = name.and_then(|item| reader.string(item, &body.what("joint_name")));
    let attachment_rotation = value::rotation(reader, body, "attachment_rotation");
    let body_attachment = body.get("body_attachment");
    let body_attachment =
        body_attachment.map(|item| value::vector(reader, item, &body.what("body_attachment")));
    WrittenJoint {
        kind,
        name,
        axis,
        attachment,
        attachment_rotation,
        body_attachment,
        body_rotation: value::rotation(reader, body, "body_rotation"),
        locked: locked(reader, body),
        chart: choice(reader, body, "chart", &Chart::NAMED),
        speeds: choice(reader, body, "speeds", &Speeds::NAMED),
        stiffness: scalars(reader, body, "stiffness"),
        rest: scalars(reader, body, "rest"),
        damping: scalars(reader, body, "damping"),
        armature: scalars(reader, body, "armature"),
        friction: value::per_coordinate(reader, body, "friction", &[], value::constant),
        limits: value::per_coordinate(reader, body, "limits", &LIMIT_KEYS, limits),
        mimic: body
            .get("mimic")
            .and_then(|item| mimic(reader, item, &body.what("mimic"))),
    }
}

fn scalars(reader: &mut Reader, body: &Table<'_, '_>, key: &str) -> PerCoordinate<Scalar> {
    value::per_coordinate(reader, body, key, &["runtime"], value::scalar)
}

fn choice<T: Copy>(
    reader: &mut Reader,
    body: &Table<'_, '_>,
    key: &str,
    choices: &[(&str, T)],
) -> Optional<T> {
    let item = body.get(key)?;
    reader.choice(item, &body.what(key), choices, "unknown value")
}

fn kind(reader: &mut Reader, item: &Item<'_>, what: &str) -> Given<JointKind> {
    if let Some(text) = item.get_ref().as_str() {
        return named_kind(reader, item, text, what);
    }
    let entries = reader.list(item, what, "coordinates, or a name such as \"free\"")?;
    let before = reader.faults.count();
    let mut coordinates: Vec<Spanned<CoordinateName>> = Vec::new();
    for (index, entry) in entries.iter().enumerate() {
        let Some(name) = reader.string(entry, &format!("entry {} of {what}", index + 1)) else {
            continue;
        };
        let Some(coordinate) = value::coordinate(reader, &name.value, name.span, what, &[]) else {
            continue;
        };
        if let Some(first) = coordinates.iter().find(|other| other.value == coordinate) {
            let fault = Diagnostic::error(format!("{what} lists `{}` twice", coordinate.name()));
            reader.faults.push(
                fault
                    .at(name.span, "the second one")
                    .at(first.span, "the first one"),
            );
        } else {
            coordinates.push(Spanned::new(coordinate, name.span));
        }
    }
    // With an entry lost, what moves and what does not is unknown, and judging it would mislead.
    (reader.faults.count() == before)
        .then(|| Spanned::new(JointKind::List(coordinates), span(item)))
}

fn named_kind(reader: &mut Reader, item: &Item<'_>, text: &str, what: &str) -> Given<JointKind> {
    let found = JointKind::NAMED.into_iter().find(|(name, _)| *name == text);
    if found.is_none() {
        let fault = Diagnostic::error(format!("{what} is `{}`, which is no joint", text.escaped()));
        let names = JointKind::NAMED.map(|(name, _)| name);
        let help = match elsewhere::joint(text).or_else(|| nearest(text, &names)) {
            _ if CoordinateName::NAMES.contains(&text) => {
                format!("a motion stands in a list: `[\"{text}\"]`")
            }
            _ if ["screw", "helical"].contains(&text) => {
                "a screw is a `revolute` joint of a body without mass, and on it a `prismatic` one with `mimic`, its `multiplier` the pitch in m/rad"
                    .to_owned()
            }
            Some(near) => format!("did you mean `{near}`?"),
            None => format!(
                "a joint is one of {}, or a list of those of {} that are free to move",
                backquoted(&names),
                backquoted(&CoordinateName::NAMES)
            ),
        };
        let fault = fault.at(span(item), "unknown joint").help(help);
        reader.faults.push(fault);
    }
    found.map(|(_, kind)| Spanned::new(kind, span(item)))
}

/// The axis of a joint that has one; of a joint that has none, it is an error.
fn axis(
    reader: &mut Reader,
    body: &Table<'_, '_>,
    kind: Option<&Spanned<JointKind>>,
) -> Optional<[f64; 3]> {
    let what = body.what("axis");
    let item = body.get("axis");
    let axis = item.and_then(|item| value::direction(reader, item, &what));
    // Which joint it is was said wrongly, and so it may or may not have an axis.
    let kind = kind?;
    match item {
        Some(item) if !kind.value.has_axis() => {
            let with_axis = JointKind::NAMED
                .iter()
                .filter(|(_, kind)| kind.has_axis())
                .map(|(name, _)| *name);
            let with_axis: Vec<&str> = with_axis.collect();
            let fault = format!("{what} is given, but its joint has no axis of its own");
            let fault = Diagnostic::error(fault)
                .at(span(item), "not expected")
                .at(kind.span, "this joint has none");
            reader.faults.push(fault.help(format!(
                "the joints with an axis are {}; the axes of others are turned by `attachment_rotation`",
                backquoted(&with_axis)
            )));
            None
        }
        None if kind.value.has_axis() && !body.is_misspelt("axis") => {
            let fault = Diagnostic::error(format!("{what} is missing, which its joint needs"));
            reader.faults.push(
                fault
                    .at(kind.span, "about or along which axis?")
                    .help("write for example `axis = [0.0, 0.0, 1.0]`"),
            );
            None
        }
        _ => axis,
    }
}

fn locked(reader: &mut Reader, body: &Table<'_, '_>) -> Vec<(Spanned<CoordinateName>, Given<f64>)> {
    let Some(item) = body.get("locked") else {
        return Vec::new();
    };
    let what = body.what("locked");
    // The keys are looked at one by one below: an unknown one is an unknown coordinate.
    let Some(table) = reader.any_table(item, &what) else {
        return Vec::new();
    };
    let mut locked = Vec::new();
    for (key, item) in table.entries() {
        if let Some(coordinate) = value::coordinate(reader, key.value, key.span, &what, &[]) {
            let number = value::constant(reader, item, &table.what(key.value));
            locked.push((Spanned::new(coordinate, key.span), number));
        }
    }
    locked.sort_by_key(|(coordinate, _)| coordinate.value);
    locked
}

fn limits(reader: &mut Reader, item: &Item<'_>, what: &str) -> Optional<Limits> {
    let example = "limits = { lower = -1.0, upper = 1.0 }";
    let table = reader.table_such_as(item, what, &LIMIT_KEYS, example)?;
    let [lower, upper, velocity, effort] = LIMIT_KEYS.map(|key| {
        let item = table.get(key)?;
        let none = match key {
            "lower" => f64::NEG_INFINITY,
            _ => f64::INFINITY,
        };
        let limit = (!value::is_number(item, none)).then_some(item)?;
        value::constant(reader, limit, &table.what(key))
    });
    let limits = Limits {
        lower,
        upper,
        velocity,
        effort,
    };
    Some(Spanned::new(limits, span(item)))
}

fn mimic(reader: &mut Reader, item: &Item<'_>, what: &str) -> Optional<Mimic> {
    let example = "mimic = { joint = \"finger_1\" }";
    let table = reader.table_such_as(item, what, &MIMIC_KEYS, example)?;
    let joint = reader.required(&table, "joint", "joint = \"finger_1\"");
    let joint = joint.and_then(|item| reader.string(item, &table.what("joint")));
    let mut number = |key: &str, absent: f64| {
        let number = table
            .get(key)
            .and_then(|item| value::constant(reader, item, &table.what(key)));
        number.map_or(absent, |number| number.value)
    };
    let (multiplier, offset) = (number("multiplier", 1.0), number("offset", 0.0));
    let mimic = Mimic {
        joint: joint?,
        multiplier,
        offset,
    };
    Some(Spanned::new(mimic, span(item)))
}
