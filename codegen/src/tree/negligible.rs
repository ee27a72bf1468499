//! Masses and inertias that are nothing beside the model's largest: crumbs of rounding, or marks that say "none".
//!
//! In: masses and inertias as written. Out: from where on they count. Afterwards: what is below counts as zero, exactly, in
//! all that follows. Values that are set at run time always count.

use crate::description::{Description, Given, Scalar};
use crate::diagnostic::{Diagnostic, Span};
use crate::tree::names::shown;

/// Part of the model's largest, below which a mass or an inertia counts as zero; and part of an inertia's largest component, below
/// which another does.
const NOTHING: f64 = 1e-14;

/// From where on masses and inertias count.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Negligible {
    mass: f64,
    inertia: f64,
}

impl Negligible {
    /// Measured by the largest mass, and the largest component of an inertia, of those that are baked in.
    pub(crate) fn of(description: &Description) -> Self {
        let bodies = || description.bodies.iter();
        let part = |largest: f64| NOTHING * largest;
        Self {
            mass: part(largest(bodies().map(|body| body.mass))),
            inertia: part(largest(bodies().flat_map(|body| body.inertia))),
        }
    }

    /// A mass, kg.
    pub(crate) fn mass(self, given: Given<Scalar>) -> Given<Scalar> {
        counted(given, self.mass)
    }

    /// Components of an inertia, kg m².
    pub(crate) fn inertia(self, given: [Given<Scalar>; 6]) -> [Given<Scalar>; 6] {
        let at_run_time = |given: &Given<Scalar>| {
            given.is_some_and(|given| matches!(given.value, Scalar::Runtime(_)))
        };
        let own = largest(given.into_iter());
        let least = if own < self.inertia && !given.iter().any(at_run_time) {
            self.inertia
        } else {
            NOTHING * own
        };
        given.map(|component| counted(component, least))
    }

    /// Tells what counts as zero, but for crumbs beside larger components of the same inertia, which are no news.
    pub(crate) fn tell(self, description: &Description, findings: &mut Vec<Diagnostic>) {
        for (index, body) in description.bodies.iter().enumerate() {
            let mut told = |what: &str, place: Span| {
                let name = shown(description, index);
                let fault = format!(
                    "`{what}` of {name} counts as zero: it is below 1e-14 of the model's largest"
                );
                let fault = Diagnostic::warning(fault).at(place, "as zero");
                findings.push(fault.one_of(
                    "masses and inertias below 1e-14 of the model's largest, which count as zero",
                    body.name.as_ref().map_or("", |name| &name.value),
                ));
            };
            if let Some(place) = fallen(&[body.mass], &[self.mass(body.mass)]) {
                told("mass", place);
            }
            if let Some(place) = fallen(&body.inertia, &self.inertia(body.inertia)) {
                told("inertia", place);
            }
        }
    }
}

/// The place of what was not zero and now is, all of it.
fn fallen(written: &[Given<Scalar>], counted: &[Given<Scalar>]) -> Option<Span> {
    let not_zero = |given: &&Given<Scalar>| given.is_some_and(|given| given.value.nominal() != 0.0);
    let place = written.iter().find(not_zero).copied().flatten()?.span;
    counted.iter().find(not_zero).is_none().then_some(place)
}

fn counted(given: Given<Scalar>, least: f64) -> Given<Scalar> {
    let mut given = given?;
    if let Scalar::Baked(number) = &mut given.value
        && number.abs() < least
    {
        *number = 0.0;
    }
    Some(given)
}

fn largest(values: impl Iterator<Item = Given<Scalar>>) -> f64 {
    let numbers = values.flatten().map(|given| match given.value {
        Scalar::Baked(number) => number.abs(),
        Scalar::Runtime(_) => 0.0,
    });
    numbers.fold(0.0, f64::max)
}
