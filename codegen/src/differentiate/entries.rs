//! Entries of what is turned, that depend on an angle alone: sines, cosines, and these times constants.
//!
//! Where an entry `e` is a factor of `e x` and the root changes by `r` with that product, the root changes by `r x e'` with the
//! angle. Where `r e'` is there, for `e'` is an entry that the same `r` met, one product with `x` does; to gather how the root
//! changes with `e` takes one operation more.

use super::{
    row::{Row, added},
    turned::{Turned, slope_of_entry},
};
use crate::expr::{Expr, ExprGraph, NodeId};

/// That the roots change with an entry by `factor` times a row.
#[derive(Clone, Debug)]
pub(super) struct Use {
    pub(super) factor: Expr,
    pub(super) of: Row,
}

/// For each node its angle, and how it changes with it, where it is an entry and the function computes how it changes.
pub(super) fn entries(
    graph: &ExprGraph,
    turned: &[Option<Turned>],
    varies: impl Fn(NodeId) -> bool,
) -> Vec<Option<(NodeId, Expr)>> {
    let entry = |(id, turned): (NodeId, &Option<Turned>)| {
        let found = match turned {
            None => slope_of_entry(graph, id),
            Some(turned) => {
                let mut others = turned.by_others.iter();
                let is_entry = turned.holds(&varies) && !others.any(|(other, _)| varies(*other));
                is_entry.then_some(turned.by_angle)
            }
        };
        found.filter(|(angle, _)| varies(*angle))
    };
    graph.ids().zip(turned).map(entry).collect()
}

/// How the roots change with the angle of an entry by its uses; `None` where to gather them is as cheap.
pub(super) fn by_angle(graph: &mut ExprGraph, slope: Expr, uses: &[Use]) -> Option<Row> {
    let mut sum = Row::new();
    for Use { factor, of } in uses {
        let mut row = Row::with_capacity(of.len());
        for &(place, root) in of {
            if graph.known_product(root, *factor).is_some() {
                return None;
            }
            row.push((place, graph.known_product(root, slope)?));
        }
        for (_, entry) in &mut row {
            *entry = graph.mul(*entry, *factor);
        }
        sum = added(graph, sum, row);
    }
    (!sum.is_empty()).then_some(sum)
}
