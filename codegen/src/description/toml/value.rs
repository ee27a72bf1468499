//! Values of our own format: numbers, vectors, rotations, coordinates, and what is given for each coordinate.

use toml::de::DeValue;

use crate::description::elsewhere;
use crate::description::toml_reader::{Item, Reader, Table, span};
use crate::description::{CoordinateName, Given, Optional, PerCoordinate, Rotation, Scalar};
use crate::diagnostic::{Diagnostic, Escaped, Span, Spanned, backquoted, nearest};

/// How far the rows of a rotation matrix may be from unit length and from right angles.
const ORTHONORMAL: f64 = 1e-6;

/// A number, or `{ runtime = number }`.
pub(super) fn scalar(reader: &mut Reader, item: &Item<'_>, what: &str) -> Given<Scalar> {
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

/// True for `{ runtime = .. }`.
pub(super) fn is_at_run_time(item: &Item<'_>) -> bool {
    let table = item.get_ref().as_table();
    table.is_some_and(|table| table.contains_key("runtime"))
}

/// True for this number, which may be infinite.
pub(super) fn is_number(item: &Item<'_>, number: f64) -> bool {
    let float = item.get_ref().as_float();
    float.is_some_and(|float| float.as_str().parse() == Ok(number))
}

/// A number that is the same at every run.
pub(super) fn constant(reader: &mut Reader, item: &Item<'_>, what: &str) -> Optional<f64> {
    if is_at_run_time(item) {
        let fault =
            format!("{what} is a table; it must be a number, for it cannot be set at run time");
        let fault = Diagnostic::error(fault).at(span(item), "expected a number");
        reader.faults.push(fault);
        return None;
    }
    reader.number(item, what)
}

/// Three scalars.
pub(super) fn vector(reader: &mut Reader, item: &Item<'_>, what: &str) -> [Given<Scalar>; 3] {
    if is_at_run_time(item) {
        let fault = format!(
            "{what} is a table; expected a list, in which any number may be `{{ runtime = 0.0 }}`"
        );
        let fault = Diagnostic::error(fault).at(span(item), "expected a list of 3 numbers");
        reader.faults.push(fault);
        return [None; 3];
    }
    let three = three(reader, item, what, "numbers", scalar);
    three.unwrap_or([None; 3])
}

/// Three constants, not all of them zero.
pub(super) fn direction(reader: &mut Reader, item: &Item<'_>, what: &str) -> Optional<[f64; 3]> {
    let direction = constants(reader, item, what)?;
    if direction == [0.0; 3] {
        let fault = Diagnostic::error(format!("{what} is zero; expected a direction"));
        reader.faults.push(fault.at(span(item), "no direction"));
        return None;
    }
    Some(Spanned::new(direction, span(item)))
}

fn constants(reader: &mut Reader, item: &Item<'_>, what: &str) -> Option<[f64; 3]> {
    let [x, y, z] = three(reader, item, what, "numbers", constant)?;
    Some([x?.value, y?.value, z?.value])
}

/// The entries of a list of three, `None` where one is missing or faulty.
fn three<T>(
    reader: &mut Reader,
    item: &Item<'_>,
    what: &str,
    of: &str,
    one: impl Fn(&mut Reader, &Item<'_>, &str) -> Option<T>,
) -> Option<[Option<T>; 3]> {
    let entries = reader.list(item, what, &format!("3 {of}"))?;
    if entries.len() != 3 {
        let n = entries.len();
        let fault = format!(
            "{what} has {n} {}; expected 3",
            if n == 1 { "entry" } else { "entries" }
        );
        reader
            .faults
            .push(Diagnostic::error(fault).at(span(item), format!("expected 3 {of}")));
    }
    let mut three = [None, None, None];
    for (index, entry) in entries.iter().enumerate() {
        let value = one(reader, entry, &format!("entry {} of {what}", index + 1));
        if let Some(place) = three.get_mut(index) {
            *place = value;
        }
    }
    Some(three)
}

/// A matrix by rows.
pub(super) fn matrix(reader: &mut Reader, item: &Item<'_>, what: &str) -> Option<[[f64; 3]; 3]> {
    let is_number =
        |entry: &Item<'_>| matches!(entry.get_ref(), DeValue::Integer(_) | DeValue::Float(_));
    if let DeValue::Array(entries) = item.get_ref()
        && !entries.is_empty()
        && entries.iter().all(is_number)
    {
        let message = format!("{what} is a list of numbers; expected 3 rows of 3 numbers");
        let fault = Diagnostic::error(message).at(span(item), "expected a rotation matrix");
        reader.faults.push(fault.help(
            "a quarter turn about z is `[[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]`: each row is an axis of the frame to which it leads",
        ));
        return None;
    }
    let [x, y, z] = three(reader, item, what, "lists of 3 numbers", constants)?;
    Some([x?, y?, z?])
}

/// A rotation matrix by rows, where the key is there.
pub(super) fn rotation(reader: &mut Reader, body: &Table<'_, '_>, key: &str) -> Optional<Rotation> {
    let item = body.get(key)?;
    let what = body.what(key);
    let rotation = matrix(reader, item, &what)?;
    if let Err(reason) = check_rotation(&rotation) {
        let fault = Diagnostic::error(format!("{what} is no rotation: {reason}"));
        reader.faults.push(fault.at(span(item), "no rotation").help(
            "each row is an axis of the frame to which the rotation leads, in components of the frame from which it leads",
        ));
        return None;
    }
    Some(Spanned::new(rotation, span(item)))
}

/// Rows that are of unit length, at right angles and right-handed; otherwise the worst that they are not.
fn check_rotation(rows: &Rotation) -> Result<(), String> {
    let product = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let mut worst = (ORTHONORMAL, None);
    for i in 0..3 {
        for j in i..3 {
            let expected = if i == j { 1.0 } else { 0.0 };
            let distance = (product(rows[i], rows[j]) - expected).abs();
            // Numbers so large that their products are not finite are far from everything.
            let distance = if distance.is_nan() {
                f64::INFINITY
            } else {
                distance
            };
            if distance > worst.0 {
                worst = (distance, Some((i, j)));
            }
        }
    }
    match worst.1 {
        Some((i, j)) if i == j => Err(format!(
            "the length of row {} is {}; expected 1 within {ORTHONORMAL:e}",
            i + 1,
            rounded(product(rows[i], rows[i]).sqrt())
        )),
        Some((i, j)) => Err(format!(
            "rows {} and {} are not at right angles, their scalar product is {}; expected 0 within {ORTHONORMAL:e}",
            i + 1,
            j + 1,
            rounded(product(rows[i], rows[j]))
        )),
        None => {
            let [x, y, z] = *rows;
            let cross = [
                x[1] * y[2] - x[2] * y[1],
                x[2] * y[0] - x[0] * y[2],
                x[0] * y[1] - x[1] * y[0],
            ];
            if product(cross, z) < 0.0 {
                return Err("it is a reflection, its rows are left-handed; expected row 3 to be the vector product of rows 1 and 2".to_owned());
            }
            Ok(())
        }
    }
}

/// Enough digits to see how far off a number is.
fn rounded(number: f64) -> String {
    if (1e-3..1e3).contains(&number.abs()) {
        let text = format!("{number:.8}");
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        format!("{number:.3e}")
    }
}

/// A coordinate by its name; `beside` are the other keys that could stand there.
pub(super) fn coordinate(
    reader: &mut Reader,
    name: &str,
    span: Span,
    what: &str,
    beside: &[&str],
) -> Option<CoordinateName> {
    let coordinate = CoordinateName::named(name);
    if coordinate.is_none() {
        let fault = Diagnostic::error(format!(
            "{what} names `{}`, which is no coordinate",
            name.escaped()
        ));
        let names = backquoted(&CoordinateName::NAMES);
        let help = match nearest(name, &CoordinateName::NAMES) {
            Some(near) => format!("did you mean `{near}`? The coordinates are {names}"),
            None if beside.is_empty() => format!("the coordinates are {names}"),
            None => format!(
                "the keys are {} for all coordinates, or the coordinates {names}",
                backquoted(beside)
            ),
        };
        reader
            .faults
            .push(fault.at(span, "unknown coordinate").help(help));
    }
    coordinate
}

/// One value for every free coordinate, or a table of values by coordinate; `keys` are those of one value that is itself
/// a table. A table that holds nothing says nothing.
pub(super) fn per_coordinate<T>(
    reader: &mut Reader,
    body: &Table<'_, '_>,
    key: &str,
    keys: &[&str],
    one: impl Fn(&mut Reader, &Item<'_>, &str) -> Optional<T>,
) -> PerCoordinate<T> {
    let Some(item) = body.get(key) else {
        return PerCoordinate::Absent;
    };
    let what = body.what(key);
    let names = item.get_ref().as_table().map(|table| {
        let names = table.keys();
        names
            .map(|name| name.get_ref().as_ref())
            .collect::<Vec<&str>>()
    });
    match names {
        Some(names) if names.is_empty() => PerCoordinate::Absent,
        Some(names) if is_by_coordinate(&names, keys) => {
            let Some(table) = reader.any_table(item, &what) else {
                return PerCoordinate::Absent;
            };
            let mut each = Vec::new();
            for (name, item) in table.entries() {
                let coordinate = coordinate(reader, name.value, name.span, &what, keys);
                let value = one(reader, item, &table.what(name.value));
                each.extend(
                    coordinate
                        .zip(value)
                        .map(|(coordinate, value)| (Spanned::new(coordinate, name.span), value)),
                );
            }
            each.sort_by_key(|(coordinate, _)| coordinate.value);
            PerCoordinate::Each(each)
        }
        _ => one(reader, item, &what).map_or(PerCoordinate::Absent, PerCoordinate::Same),
    }
}

/// True for a table of coordinates, as far as its keys are right; false for the table that is one value.
fn is_by_coordinate(names: &[&str], keys: &[&str]) -> bool {
    if names == ["runtime"] {
        return false;
    }
    let names_coordinate = |name: &&str| CoordinateName::named(name).is_some();
    let is_near_key =
        |name: &&str| elsewhere::key(name, keys).is_some() || nearest(name, keys).is_some();
    names.iter().any(names_coordinate) || !names.iter().any(is_near_key)
}
