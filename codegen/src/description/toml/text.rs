//! Values as text of our own format, `None` for what cannot be written.

use std::fmt::Write as _;

use crate::description::{CoordinateName, Given, JointKind, Limits, Mimic, Rotation, Scalar};
use crate::diagnostic::{Spanned, is_unprintable};

/// A table that holds nothing.
pub(super) const EMPTY: &str = "{}";

/// The name of one of these choices.
pub(super) fn name<T: PartialEq>(value: &T, choices: &[(&str, T)]) -> Option<String> {
    let found = choices.iter().find(|(_, choice)| choice == value);
    found.map(|(name, _)| quoted(name))
}

pub(super) fn joint_kind(kind: &JointKind) -> Option<String> {
    match kind {
        JointKind::List(coordinates) => list(
            coordinates
                .iter()
                .map(|coordinate| Some(quoted(coordinate.value.name()))),
        ),
        named => name(named, &JointKind::NAMED),
    }
}

pub(super) fn limits(limits: &Limits) -> Option<String> {
    let Limits {
        lower,
        upper,
        velocity,
        effort,
    } = limits;
    let limits = [
        ("lower", lower),
        ("upper", upper),
        ("velocity", velocity),
        ("effort", effort),
    ];
    table(
        limits
            .into_iter()
            .filter_map(|(key, limit)| Some((key, number(limit.as_ref()?.value)))),
    )
}

pub(super) fn mimic_table(mimic: &Mimic) -> Option<String> {
    let factor = (mimic.multiplier != 1.0).then(|| ("multiplier", number(mimic.multiplier)));
    let offset = (mimic.offset != 0.0).then(|| ("offset", number(mimic.offset)));
    let joint = ("joint", Some(string(&mimic.joint)));
    table([joint].into_iter().chain(factor).chain(offset))
}

/// A table by coordinate, in the order of [`CoordinateName::ALL`].
pub(super) fn by_coordinate(
    values: impl Iterator<Item = Option<(CoordinateName, String)>>,
) -> Option<String> {
    let mut values: Vec<(CoordinateName, String)> = values.collect::<Option<_>>()?;
    values.sort_by_key(|(coordinate, _)| *coordinate);
    table(
        values
            .into_iter()
            .map(|(coordinate, value)| (coordinate.name(), Some(value))),
    )
}

pub(super) fn scalar(scalar: Given<Scalar>) -> Option<String> {
    binding(&scalar?.value)
}

/// A number in its binding time.
pub(super) fn binding(scalar: &Scalar) -> Option<String> {
    match *scalar {
        Scalar::Baked(value) => number(value),
        Scalar::Runtime(value) => table([("runtime", number(value))]),
    }
}

pub(super) fn vector(vector: &[Given<Scalar>; 3]) -> Option<String> {
    list(vector.map(scalar))
}

/// A rotation by rows, its columns aligned.
pub(super) fn matrix(rotation: &Rotation) -> Option<String> {
    let mut rows = Vec::with_capacity(3);
    for row in rotation {
        let [x, y, z] = row.map(number);
        rows.push([x?, y?, z?]);
    }
    let width = |column: usize| rows.iter().map(|row| row[column].len()).max().unwrap_or(0);
    let widths = [width(0), width(1), width(2)];
    let mut text = String::from("[\n");
    for [x, y, z] in &rows {
        let [first, second, third] = widths;
        writeln!(text, "    [{x:>first$}, {y:>second$}, {z:>third$}],")
            .expect("a string takes any text");
    }
    text.push(']');
    Some(text)
}

/// A finite number in its shortest text that reads back bit for bit; zero has no sign.
pub(super) fn number(number: f64) -> Option<String> {
    number.is_finite().then(|| format!("{:?}", number + 0.0))
}

pub(super) fn list(values: impl IntoIterator<Item = Option<String>>) -> Option<String> {
    let values: Vec<String> = values.into_iter().collect::<Option<_>>()?;
    Some(format!("[{}]", values.join(", ")))
}

pub(super) fn table<'k>(
    values: impl IntoIterator<Item = (&'k str, Option<String>)>,
) -> Option<String> {
    let values = values.into_iter();
    let values = values.map(|(key, value)| Some(format!("{key} = {}", value?)));
    let values: Vec<String> = values.collect::<Option<_>>()?;
    Some(if values.is_empty() {
        EMPTY.to_owned()
    } else {
        format!("{{ {} }}", values.join(", "))
    })
}

pub(super) fn string(text: &Spanned<String>) -> String {
    quoted(&text.value)
}

/// A basic string of TOML.
pub fn quoted(text: &str) -> String {
    let mut quoted = String::from('"');
    for character in text.chars() {
        match character {
            '"' => quoted.push_str("\\\""),
            '\\' => quoted.push_str("\\\\"),
            '\n' => quoted.push_str("\\n"),
            '\r' => quoted.push_str("\\r"),
            '\t' => quoted.push_str("\\t"),
            // What TOML forbids, and what an editor would not show.
            _ if is_unprintable(character) => {
                write!(quoted, "\\u{:04X}", u32::from(character)).expect("a string takes any text");
            }
            _ => quoted.push(character),
        }
    }
    quoted.push('"');
    quoted
}
