//! Names and units of what can be identified.

use kane::BaseTerm;

use crate::{Arm, Identifiable, drive::COEFFICIENTS, stack::base_parameters};

/// The coefficients of a drive, in their order, and their units.
const DRIVE: [(&str, &str); COEFFICIENTS] =
    [("viscous", "N m s"), ("coulomb", "N m"), ("rotor", "kg m²")];

/// Factors below are rounding's.
const NONE: f64 = 1e-6;

/// The name of a column of the regressors.
fn name<A: Arm>(column: usize) -> String {
    match column.checked_sub(base_parameters::<A>()) {
        None => A::NAMES[column].to_owned(),
        Some(place) => {
            let (coefficient, _) = DRIVE[place % COEFFICIENTS];
            let body = A::SPEED_BODIES[place / COEFFICIENTS];
            format!("{coefficient}({})", A::JOINTS[body].name)
        }
    }
}

/// Names of all that can be identified: where a rotor is felt as something else is, it is part of its sum.
pub(crate) fn names<A: Arm>(identifiable: &Identifiable) -> Vec<String> {
    let (columns, sums) = (&identifiable.columns, &identifiable.sums);
    let named = columns.iter().enumerate().map(|(i, &column)| {
        let mut text = name::<A>(column);
        let others = (0..sums.ncols()).filter(|j| !columns.contains(j));
        for j in others.filter(|&j| sums[(i, j)].abs() > NONE) {
            let (factor, other) = (sums[(i, j)], name::<A>(j));
            text = if (factor - 1.0).abs() < NONE {
                format!("{text} + {other}")
            } else {
                format!("{text} + {factor:.6} {other}")
            };
        }
        text
    });
    named.collect()
}

/// Their units.
pub(crate) fn units<A: Arm>(identifiable: &Identifiable) -> Vec<&'static str> {
    let unit = |&column: &usize| match column.checked_sub(base_parameters::<A>()) {
        Some(place) => DRIVE[place % COEFFICIENTS].1,
        None => match first::<A>(column).parameter {
            0 => "kg",
            1..4 => "kg m",
            _ => "kg m²",
        },
    };
    identifiable.columns.iter().map(unit).collect()
}

/// The first term of a base parameter: it has the base parameter's unit.
fn first<A: Arm>(base: usize) -> BaseTerm {
    let mut terms = A::TERMS.iter();
    *terms
        .find(|term| term.base == base)
        .expect("a base parameter has a term")
}
