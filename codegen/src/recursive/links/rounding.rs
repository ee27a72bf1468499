//! Numbers that rounding alone keeps from being zero, one or a right angle.

use std::f64::consts::FRAC_PI_2;

use crate::expr::{Expr, ExprGraph, Vector};

/// What a few roundings leave of numbers near one.
const CRUMB: f64 = 4.0 * f64::EPSILON;

/// A difference with those numbers made zero that rounding alone has left.
pub(super) fn without_crumbs(graph: &mut ExprGraph, difference: Vector, of: Vector) -> Vector {
    let numbers = of.map(|component| graph.as_number(component));
    let [Some(x), Some(y), Some(z)] = numbers else {
        return difference;
    };
    let scale = x.abs().max(y.abs()).max(z.abs());
    difference.map(|component| match graph.as_number(component) {
        Some(rest) if rest.abs() <= CRUMB * scale => graph.zero(),
        _ => component,
    })
}

/// A row of a rotation with those entries made zero that rounding alone has left, and one that then stands alone.
pub(super) fn exact(row: [f64; 3]) -> [f64; 3] {
    let rest = row.map(|entry| if entry.abs() <= CRUMB { 0.0 } else { entry });
    let n_left = rest.iter().filter(|entry| **entry != 0.0).count();
    if n_left == 1 {
        rest.map(|entry| if entry == 0.0 { 0.0 } else { entry.signum() })
    } else {
        rest
    }
}

/// The same of expressions, where all of them are numbers.
pub(super) fn exact_row(graph: &mut ExprGraph, row: Vector) -> Vector {
    match row.map(|entry| graph.as_number(entry)) {
        [Some(x), Some(y), Some(z)] => exact([x, y, z]).map(|entry| graph.number(entry)),
        _ => row,
    }
}

/// Sine and cosine of an angle with a phase, of which right angles cost nothing.
pub(in crate::recursive) fn phased(graph: &mut ExprGraph, angle: Expr, phase: f64) -> (Expr, Expr) {
    let quarters = libm::round(phase / FRAC_PI_2);
    if (phase - quarters * FRAC_PI_2).abs() > CRUMB {
        let phase = graph.number(phase);
        let angle = graph.add(angle, phase);
        return (graph.sin(angle), graph.cos(angle));
    }
    let (sine, cosine) = (graph.sin(angle), graph.cos(angle));
    // Phases lie between minus and plus one turn.
    match quarters.rem_euclid(4.0) {
        0.0 => (sine, cosine),
        1.0 => (cosine, -sine),
        2.0 => (-sine, -cosine),
        _ => (-cosine, sine),
    }
}
