//! Rows of a Jacobian: an entry for each variable on which something depends.

use std::{cmp::Ordering, collections::BTreeMap};

use crate::expr::{Expr, ExprGraph, Input};

/// Entries by their places, which ascend; what is not there is zero.
pub type Row = Vec<(usize, Expr)>;

/// How inputs change with variables.
pub type Seeds = BTreeMap<Input, Row>;

/// A row times a factor; what becomes zero is left out.
pub(super) fn scaled(graph: &mut ExprGraph, factor: Expr, row: &Row) -> Row {
    let scaled = row
        .iter()
        .map(|&(place, entry)| (place, graph.mul(factor, entry)));
    let scaled: Row = scaled.collect();
    without_zeros(graph, scaled)
}

/// The sum of two rows.
pub(super) fn added(graph: &mut ExprGraph, a: Row, b: Row) -> Row {
    if a.is_empty() {
        return b;
    }
    let sum = merged(a, b, |x, y| graph.add(x, y));
    without_zeros(graph, sum)
}

/// Entries of both by their places, which ascend; of a place that both have, what `both` makes of them.
pub(super) fn merged<T>(
    a: Vec<(usize, T)>,
    b: Vec<(usize, T)>,
    mut both: impl FnMut(T, T) -> T,
) -> Vec<(usize, T)> {
    let mut merged = Vec::with_capacity(a.len().max(b.len()));
    let (mut a, mut b) = (a.into_iter().peekable(), b.into_iter().peekable());
    loop {
        let order = match (a.peek(), b.peek()) {
            (Some((of_a, _)), Some((of_b, _))) => of_a.cmp(of_b),
            (Some(_), None) => Ordering::Less,
            (None, Some(_)) => Ordering::Greater,
            (None, None) => return merged,
        };
        let (first, second) = match order {
            Ordering::Less => (a.next(), None),
            Ordering::Greater => (None, b.next()),
            Ordering::Equal => (a.next(), b.next()),
        };
        merged.extend(match (first, second) {
            (Some((place, x)), Some((_, y))) => Some((place, both(x, y))),
            (one, other) => one.or(other),
        });
    }
}

fn without_zeros(graph: &ExprGraph, mut row: Row) -> Row {
    row.retain(|&(_, entry)| !graph.is_zero(entry));
    row
}
