//! The outline of a module, read from its constants.

use syn::{Attribute, Expr, File, Item, Meta, ext::IdentExt};

use crate::{
    listing::{JointChart, constants, read_nominal},
    report::constants::{constant, entries, field, integer, list, some, string},
    tree::CoordinateKind,
};

use super::system::{Body, INERTIAL, LOWER, Layout, Outline, Values};

/// The outline of a generated module, of any age; or what it lacks that each of these has.
pub(in crate::report) fn outline(file: &File) -> Result<Outline, &'static str> {
    let body_names = strings(file, constants::BODY_NAMES)?;
    let (lower_bodies, joints) = (
        list(file, constants::LOWER_BODIES),
        list(file, constants::JOINTS),
    );
    let mut bodies = Vec::new();
    for (place, name) in body_names.iter().enumerate() {
        let mut values = Values::new();
        let lower = lower_bodies.get(place).copied().and_then(integer);
        let lower = lower.map(|number| below(number.checked_sub(1), &body_names));
        values.extend(lower.map(|lower| (LOWER.to_owned(), lower)));
        if let Some(joint) = joints.get(place) {
            let own = field(joint, "name").and_then(string);
            let own = own.filter(|own| own != name);
            values.extend(own.map(|own| ("joint_name".to_owned(), own)));
            values.insert("joint".to_owned(), kinds(joint));
        }
        let name = name.clone();
        bodies.push(Body {
            name,
            values,
            motions: None,
        });
    }
    for frame in list(file, constants::FRAMES) {
        let place = field(frame, "body").and_then(some).and_then(integer);
        let values = [
            (LOWER.to_owned(), below(place, &body_names)),
            ("joint".to_owned(), "fixed".to_owned()),
        ];
        bodies.extend(field(frame, "name").and_then(string).map(|name| Body {
            name,
            values: values.into(),
            motions: None,
        }));
    }
    let mut values = nominal_values(file);
    let name = constant(file, constants::NAME).and_then(string);
    values.extend(name.map(|name| ("name".to_owned(), name)));
    Ok(Outline {
        fingerprint: constant(file, constants::FINGERPRINT).and_then(integer),
        values,
        bodies,
        layouts: vec![
            (Layout::Bodies, body_names),
            (
                Layout::Coordinates,
                strings(file, constants::COORDINATE_NAMES)?,
            ),
            (Layout::Speeds, strings(file, constants::SPEED_NAMES)?),
            (Layout::Parameters, fields(file, "Parameters")),
        ],
    })
}

/// The name of the body at a place of an array; none is the inertial frame.
fn below(place: Option<u64>, names: &[String]) -> String {
    let place = place.and_then(|place| usize::try_from(place).ok());
    let name = place.and_then(|place| names.get(place));
    name.map_or_else(|| INERTIAL.to_owned(), Clone::clone)
}

/// The names of a type's fields; none where it is not there.
fn fields(file: &File, name: &str) -> Vec<String> {
    let fields = file.items.iter().find_map(|item| match item {
        Item::Struct(item) if item.ident == name => Some(&item.fields),
        _ => None,
    });
    let names = fields.into_iter().flatten();
    let names = names.filter_map(|field| field.ident.as_ref());
    names.map(|name| name.unraw().to_string()).collect()
}

fn strings(file: &File, name: &'static str) -> Result<Vec<String>, &'static str> {
    let value = constant(file, name).ok_or(name)?;
    Ok(entries(value).into_iter().filter_map(string).collect())
}

/// The kinds of a joint's coordinates, of an entry of `JOINTS`.
fn kinds(joint: &Expr) -> String {
    let coordinates = coordinates(joint).into_iter();
    let names: Vec<&str> = coordinates.map(|(_, kind)| kind.name()).collect();
    names.join(" ")
}

/// The places in `q` of a joint's coordinates and what they are, of an entry of `JOINTS`.
pub(in crate::report) fn coordinates(joint: &Expr) -> Vec<(usize, CoordinateKind)> {
    let name = |chart: &Expr| match chart {
        Expr::Path(path) => path.path.segments.last().map(|last| last.ident.to_string()),
        _ => None,
    };
    let chart = field(joint, "chart").and_then(name);
    let chart = chart.and_then(|name| JointChart::named(&name));
    let chart = chart.unwrap_or(JointChart::Angles);
    let entries = field(joint, "q").map_or_else(Vec::new, entries);
    let entries = entries.into_iter().take(7).enumerate();
    let free = entries.filter_map(|(kind, entry)| {
        let place = some(entry).and_then(integer)?;
        Some((usize::try_from(place).ok()?, chart.coordinate(kind)?))
    });
    free.collect()
}

/// The fields of `Parameters` with their nominal values, which stand in their documentation.
fn nominal_values(file: &File) -> Values {
    let parameters = file.items.iter().find_map(|item| match item {
        Item::Struct(item) if item.ident == "Parameters" => Some(item),
        _ => None,
    });
    let fields = parameters.into_iter().flat_map(|item| &item.fields);
    let documented = fields.filter_map(|field| {
        let mut lines = field.attrs.iter().filter_map(doc);
        let nominal = lines.find_map(|line| read_nominal(&line).map(str::to_owned));
        let name = field.ident.as_ref()?;
        Some((format!("parameter {name}"), nominal?))
    });
    documented.collect()
}

fn doc(attribute: &Attribute) -> Option<String> {
    match &attribute.meta {
        Meta::NameValue(pair) if pair.path.is_ident("doc") => string(&pair.value),
        _ => None,
    }
}
