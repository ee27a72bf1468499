//! Quaternions are of length one.

use std::collections::BTreeMap;

use crate::{expr::Input, tree::Tree};

/// The same numbers, with quaternions of length one.
pub(crate) fn with_unit_quaternions(
    tree: &Tree,
    mut numbers: BTreeMap<Input, f64>,
) -> BTreeMap<Input, f64> {
    for (_, parameters) in tree.quaternions() {
        let given = parameters.map(|parameter| numbers[&Input::Q(parameter)]);
        let square: f64 = given.iter().map(|number| number * number).sum();
        let length = libm::sqrt(square);
        let units = parameters.into_iter().zip(given);
        numbers.extend(units.map(|(parameter, number)| (Input::Q(parameter), number / length)));
    }
    numbers
}
