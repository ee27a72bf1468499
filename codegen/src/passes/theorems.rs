//! Sines and cosines of angles and, by the addition theorems, of their sums.

use crate::expr::{Expr, ExprGraph};

/// Sine and cosine of an angle.
pub(super) fn of_angle(graph: &mut ExprGraph, angle: Expr) -> [Expr; 2] {
    [graph.sin(angle), graph.cos(angle)]
}

/// `sin(a + b) = sin a cos b + cos a sin b`, `cos(a + b) = cos a cos b - sin a sin b`.
pub(super) fn of_sum(graph: &mut ExprGraph, [s, c]: [Expr; 2], [t, d]: [Expr; 2]) -> [Expr; 2] {
    let [first, second, third, fourth] =
        [(s, d), (c, t), (c, d), (s, t)].map(|(a, b)| graph.mul(a, b));
    [graph.add(first, second), graph.sub(third, fourth)]
}

/// A sine or cosine, zero where it is so but for rounding, as that of a right angle is.
pub(super) fn without_crumb(graph: &mut ExprGraph, entry: Expr) -> Expr {
    match graph.as_number(entry) {
        Some(number) if number.abs() < f64::EPSILON => graph.zero(),
        _ => entry,
    }
}
