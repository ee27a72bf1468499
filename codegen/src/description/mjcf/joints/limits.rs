//! The limits of a hinge or a slide that are in force.

use crate::description::mjcf::model::angles::AngleUnit;
use crate::description::mjcf::model::attributes::Attributes;
use crate::description::mjcf::model::settings::{Settings, Switch};
use crate::description::xml::Reader;
use crate::description::{Limits, PerCoordinate};
use crate::diagnostic::{Diagnostic, Spanned};

/// The limits of a joint whose coordinate is written in this unit.
pub(in crate::description::mjcf) fn limits(
    reader: &mut Reader,
    given: &Attributes<'_>,
    settings: &Settings,
    angle: AngleUnit,
) -> PerCoordinate<Limits> {
    let range = limited(reader, given, settings, "limited", "range");
    let effort = limited(
        reader,
        given,
        settings,
        "actuatorfrclimited",
        "actuatorfrcrange",
    );
    let limits = Limits {
        lower: range.map(|[lower, _]| Spanned::new(angle.radians(lower.value), lower.span)),
        upper: range.map(|[_, upper]| Spanned::new(angle.radians(upper.value), upper.span)),
        velocity: None,
        effort: effort.map(|[lower, upper]| {
            // Where the two differ, what holds in both directions.
            let least = upper.value.abs().min(lower.value.abs());
            Spanned::new(least, upper.span)
        }),
    };
    if limits == Limits::default() {
        return PerCoordinate::Absent;
    }
    PerCoordinate::Same(Spanned::new(limits, given.span))
}

/// A range that is in force.
fn limited(
    reader: &mut Reader,
    given: &Attributes<'_>,
    settings: &Settings,
    switch: &str,
    name: &str,
) -> Option<[Spanned<f64>; 2]> {
    let words = [
        ("true", Some(Switch::On)),
        ("false", Some(Switch::Off)),
        ("auto", None),
    ];
    let found = given.keyword(reader, switch, &words);
    let found = found.and_then(|found| found.value);
    let range: Option<[_; 2]> = given.numbers(reader, name);
    let is_zero = range.is_some_and(|range| range.iter().all(|end| end.value == 0.0));
    let is_open = found.is_none() && settings.auto_limits == Switch::Off;
    if is_open && given.has(name) && !is_zero {
        let message = format!(
            "{} has `{name}`, but does not say whether it is in force",
            given.owner
        );
        let fault = Diagnostic::error(message).at(given.place(name), "in force or not");
        reader.faults.push(fault.help(format!(
            "write `{switch}=\"true\"`, or `autolimits=\"true\"` at `compiler`"
        )));
        return None;
    }
    if found == Some(Switch::Off) || is_open {
        return None;
    }
    let [lower, upper] = match range {
        Some(range) => range,
        None if found == Some(Switch::On) && !given.has(name) => {
            let message = format!("{} is limited, but has no `{name}`", given.owner);
            let fault = Diagnostic::error(message).at(given.place(switch), "no range");
            reader.faults.push(fault);
            return None;
        }
        None => return None,
    };
    if lower.value < upper.value {
        return Some([lower, upper]);
    }
    // Without a word about it, MuJoCo takes a range that is none for no limit.
    if found == Some(Switch::On) {
        let message = format!(
            "{} is from {} to {}; expected the second to be the larger",
            given.what(name),
            lower.value,
            upper.value
        );
        let fault = Diagnostic::error(message).at(given.place(name), "empty range");
        reader.faults.push(fault);
    }
    None
}
