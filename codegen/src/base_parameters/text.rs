//! A base parameter for people to read.

use std::fmt::Write as _;

use crate::tree::{BaseParameter, InertialParameter, Tree};

/// Factors beyond these are written with a power of ten.
const LEAST: f64 = 1e-4;
const MOST: f64 = 1e7;

/// The sum as text, its factors to six digits: `mcx(upper) + 0.32 m(fore)`.
pub fn text(tree: &Tree, parameter: &BaseParameter) -> String {
    let mut text = String::new();
    for (place, (own, factor)) in parameter.terms.iter().enumerate() {
        let sign = match (place, *factor < 0.0) {
            (0, false) => "",
            (0, true) => "-",
            (_, false) => " + ",
            (_, true) => " - ",
        };
        text.push_str(sign);
        let rounded: f64 = format!("{:.5e}", factor.abs()).parse().unwrap_or(*factor);
        if !(LEAST..MOST).contains(&rounded) {
            let _ = write!(text, "{rounded:e} ");
        } else if rounded != 1.0 {
            let _ = write!(text, "{rounded} ");
        }
        let body = &tree.body(own.body).name;
        let _ = write!(text, "{}({body})", InertialParameter::NAMES[own.place]);
    }
    text
}
