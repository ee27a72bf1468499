//! Masses and inertias: are they those of a real body.
//!
//! An inertia tensor about the mass centre has principal moments that are not negative and of which none exceeds
//! the sum of the two others. A breach of the first, beyond 1e-9 of the largest moment, which covers the rounding of
//! the test itself, or of the second, beyond 1e-6, which covers data of six digits, is a warning: it is computed as given.
//! Whether there is a state in which the mass matrix is positive definite all the same, `mobility` judges.

use crate::description::{Description, Given, Scalar};
use crate::diagnostic::{Diagnostic, Span};
use crate::principal::principal;
use crate::tree::names::shown;
use crate::tree::negligible::Negligible;

/// How far below zero, relative to the largest, a principal moment may be.
const NEGATIVE: f64 = 1e-9;
/// By how much, relative to the largest, a principal moment may exceed the sum of the others.
const TRIANGLE: f64 = 1e-6;

/// Reports what no real body has, and what counts as zero; true where nothing is an error.
pub(crate) fn check(description: &Description, findings: &mut Vec<Diagnostic>) -> bool {
    let mut stands = true;
    let negligible = Negligible::of(description);
    negligible.tell(description, findings);
    for (index, body) in description.bodies.iter().enumerate() {
        let name = shown(description, index);
        let mass = negligible.mass(body.mass);
        if let Some(mass) = mass.filter(|mass| mass.value.nominal() < 0.0) {
            let fault = format!(
                "`mass` of {name} is {:?}; expected zero or more",
                mass.value.nominal()
            );
            findings.push(Diagnostic::error(fault).at(mass.span, "negative mass"));
            stands = false;
        }
        let Some((components, span)) = components(negligible.inertia(body.inertia)) else {
            continue;
        };
        let mut moments = principal(components).0;
        moments.sort_by(f64::total_cmp);
        let [small, middle, large] = moments;
        // Rounding leaves little of what is zero.
        let shown = |moment: f64| {
            let is_rounding = moment.abs() < 1e-14 * large.abs().max(small.abs());
            short(if is_rounding { 0.0 } else { moment })
        };
        let shown_moments = format!(
            "principal moments {}, {} and {}",
            shown(small),
            shown(middle),
            shown(large)
        );
        if small < -NEGATIVE * large.abs().max(small.abs()) {
            let fault = Diagnostic::warning(format!(
                "`inertia` of {name} has the {shown_moments}: no rigid body has one below zero; it is computed as given"
            ));
            let help = "xy, xz and yz are components of the tensor: minus the products of inertia";
            let fault = fault.at(span, "not positive semidefinite").help(help);
            findings.push(fault.one_of(
                "inertias with a principal moment below zero, which no rigid body has; they are computed as given",
                body.name.as_ref().map_or("", |name| &name.value),
            ));
        } else if large - middle - small > TRIANGLE * large {
            let fault = Diagnostic::warning(format!(
                "`inertia` of {name} has the {shown_moments}, which no rigid body has; it is computed as given"
            ));
            let help = "no principal moment can exceed the sum of the two others; is it taken about the mass centre?";
            findings.push(
                fault
                    .at(span, "the largest exceeds the sum of the others")
                    .help(help)
                    .one_of("bodies have principal moments that no rigid body has", name),
            );
        }
    }
    stands
}

/// The nominal components, and the place of all of them.
fn components(inertia: [Given<Scalar>; 6]) -> Option<([f64; 6], Span)> {
    let mut components = [0.0; 6];
    let mut place: Option<Span> = None;
    for (component, given) in components.iter_mut().zip(inertia) {
        let given = given?;
        *component = Scalar::nominal(given.value);
        let start = place.map_or(given.span.start, |place| place.start.min(given.span.start));
        let end = place.map_or(given.span.end, |place| place.end.max(given.span.end));
        place = Some(Span { start, end });
    }
    Some((components, place?))
}

/// Four digits are enough to see what is wrong.
fn short(number: f64) -> String {
    let rounded: f64 = format!("{number:.3e}").parse().unwrap_or(number);
    format!("{rounded:?}")
}
