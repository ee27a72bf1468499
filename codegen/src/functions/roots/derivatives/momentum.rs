//! Derivatives of the momentum matrix about the mass centre: how each column changes by the motion of another one.
//!
//! A motion has the axis `s`, passes the mass centre with `r` relative to it, changes the inertia there by `D`, and has the column `p`, `h`; `m` is the
//! mass of all. If it carries another motion, `p'`, `h'`, it changes these by `s × p'` and `s × h' + r × p'`. If the other one carries it, `s'`, `r'`,
//! by `s' × p` and `D s' - r' × p`; and if neither does, `h'` by `p' × p / m`.

use super::{carrying, swept::by_motions_or_swept};
use crate::{
    expr::ExprGraph,
    functions::{argument::Argument, entries::Entries as _, function::ByArguments},
    given,
    id::SpeedId,
    kane::center::Momentum,
    recursive::{
        Plan,
        totals::{changes::Change, momentum_matrix as columns},
    },
    solve::SpeedMatrix,
    tree::Tree,
};

pub(in crate::functions) fn momentum_matrix(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> ByArguments {
    let (entries, [by_q]) = by_motions_or_swept(
        graph,
        tree,
        [Argument::Q],
        |graph| columns::momentum_matrix(graph, tree, plan).entries(),
        |graph| {
            let (columns, changes) = columns::momentum_matrix_with_changes(graph, tree, plan);
            let by_q = by_motions(graph, tree, &columns, &changes);
            (columns.entries(), [by_q])
        },
    );
    ByArguments {
        by: vec![(Argument::Q, by_q)],
        values: Some(entries),
        mass: None,
    }
}

/// By coordinates, linear rows before angular ones.
fn by_motions(
    graph: &mut ExprGraph,
    tree: &Tree,
    columns: &[Momentum],
    changes: &[Change],
) -> SpeedMatrix {
    carrying::changes(graph, tree, 6, |graph, carrying, [own, by]| {
        let changed = if carrying.carries(by, own) {
            carried(graph, &changes[by.index()], &columns[own.index()])
        } else if carrying.carries(own, by) {
            let [inner, outer] = [own, by].map(SpeedId::index);
            carrying_others(graph, &changes[inner], &changes[outer], &columns[outer])
        } else {
            beside(graph, tree, columns, [own, by])
        };
        changed.entries()
    })
}

/// A column that turns with the motion, and passes the mass centre.
fn carried(graph: &mut ExprGraph, inner: &Change, outer: &Momentum) -> Momentum {
    let turned = graph.cross(inner.axis, outer.angular);
    let passing = graph.cross(inner.past_center, outer.linear);
    Momentum {
        linear: graph.cross(inner.axis, outer.linear),
        angular: graph.add_vectors(turned, passing),
    }
}

/// A column of which a part is moved farther out.
fn carrying_others(
    graph: &mut ExprGraph,
    inner: &Change,
    outer: &Change,
    moved: &Momentum,
) -> Momentum {
    let turned = graph.mul_symmetric(&outer.inertia, inner.axis);
    let passing = graph.cross(inner.past_center, moved.linear);
    Momentum {
        linear: graph.cross(inner.axis, moved.linear),
        angular: graph.sub_vectors(turned, passing),
    }
}

/// A column that the motion leaves as it is, about a mass centre that it moves. One product serves both of a pair.
fn beside(
    graph: &mut ExprGraph,
    tree: &Tree,
    columns: &[Momentum],
    [own, by]: [SpeedId; 2],
) -> Momentum {
    let [first, last] = [own.min(by), own.max(by)].map(|speed| columns[speed.index()].linear);
    let of_center = given::over_total_mass(graph, tree, first);
    let product = graph.cross(of_center, last);
    Momentum {
        linear: graph.zero_vector(),
        angular: if own < by {
            product
        } else {
            product.map(|entry| -entry)
        },
    }
}
