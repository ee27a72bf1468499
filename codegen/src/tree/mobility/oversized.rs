//! Numbers whose products do not fit a float: what they move then looks as if it had no mass.

use crate::description::{Description, Given, Scalar, WrittenBody};
use crate::diagnostic::Diagnostic;
use crate::tree::names::shown;

/// A larger one is told: an energy is a mass times the square of a distance.
const LARGEST: f64 = 1e150;

/// A fault for each quantity of a body that has such a number.
pub(super) fn oversized(description: &Description) -> Vec<Diagnostic> {
    let bodies = description.bodies.iter().enumerate();
    let faults = bodies.flat_map(|(place, body)| {
        let name = shown(description, place);
        quantities(body)
            .into_iter()
            .filter_map(move |(quantity, numbers)| of(&format!("{quantity} of {name}"), &numbers))
    });
    faults.collect()
}

fn quantities(body: &WrittenBody) -> [(&'static str, Vec<Given<Scalar>>); 5] {
    let at_body = body.joint.body_attachment.unwrap_or_default();
    [
        ("the mass", vec![body.mass]),
        ("the mass centre", body.mass_center.to_vec()),
        ("the inertia", body.inertia.to_vec()),
        ("the attachment", body.joint.attachment.to_vec()),
        ("the attachment in its own axes", at_body.to_vec()),
    ]
}

fn of(what: &str, numbers: &[Given<Scalar>]) -> Option<Diagnostic> {
    let mut numbers = numbers.iter().flatten();
    let large = numbers.find(|number| number.value.nominal().abs() > LARGEST)?;
    let fault = format!(
        "{what} has the number {:e}; expected at most {LARGEST:e}: products of larger ones do not fit a 64-bit float",
        large.value.nominal()
    );
    Some(Diagnostic::error(fault).at(large.span, "too large"))
}
