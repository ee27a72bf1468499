//! Numbers of a column that go four at a time.

use crate::expr::{Expr, ExprGraph, Input, LANES};

/// The first of four with sides in the place of its numbers, but for those that are known and the same in all; and for each side the
/// numbers of the four.
pub(super) fn on_sides<T: Copy>(
    graph: &mut ExprGraph,
    all: &[T; LANES],
    parts_mut: impl Fn(&mut T) -> Vec<&mut Expr>,
) -> (T, Vec<Vec<Expr>>) {
    let parts = all.map(|mut own| {
        let parts = parts_mut(&mut own).into_iter();
        parts.map(|part| *part).collect::<Vec<Expr>>()
    });
    let mut one = all[0];
    let mut sides = Vec::new();
    for (place, part) in parts_mut(&mut one).into_iter().enumerate() {
        let lanes = parts.each_ref().map(|own| own[place]);
        let is_known = graph.as_number(lanes[0]).is_some();
        if !is_known || lanes.iter().any(|own| *own != lanes[0]) {
            *part = graph.input(Input::Side(sides.len()));
            sides.push(lanes.to_vec());
        }
    }
    (one, sides)
}
