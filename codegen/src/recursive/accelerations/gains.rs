//! The factors of the mass matrix from articulated bodies.
//!
//! What a motion takes from the acceleration of its lower link is its row of `L`, as a wrench is a row of forces: carried inward
//! it is read off at each motion farther in. No mass matrix is formed.

use std::collections::BTreeMap;

use super::articulated;
use crate::{
    expr::{Expr, ExprGraph, Purpose, Vector},
    id::{BodyId, BodyMap, SpeedId},
    recursive::links::{
        linkage::Linkage,
        passage::{Drive, Passenger},
        rotation::Turn,
        wrench::Wrench,
    },
    solve::{FactorRow, Factors},
    tree::{Motion, Tree},
};

/// `M = L^T D L`, from articulated bodies.
pub(in crate::recursive) fn factors(graph: &mut ExprGraph, linkage: &Linkage<'_>) -> Factors {
    let Linkage { tree, passages, .. } = linkage;
    let gains = articulated::gains(graph, linkage);
    graph.begin(Purpose::Factors);
    let mut gained = BodyMap::outward(tree.bodies.len(), |_, _| Vec::<Gained>::new());
    let mut order = Vec::new();
    let mut rows = BTreeMap::new();
    for body in tree.body_ids().rev() {
        let mut gaining = Gaining {
            tree,
            body,
            gains: &gains,
            carried: std::mem::take(&mut gained[body]),
            order: &mut order,
            rows: &mut rows,
        };
        passages[body].inward(graph, &mut gaining);
        let carried = gaining.carried;
        if let Some(lower) = tree.lower(body) {
            gained[lower].extend(carried);
        }
    }
    let rows = order.into_iter().map(|speed| FactorRow {
        speed,
        pivot: gains[&speed].0,
        entries: rows.remove(&speed).unwrap_or_default(),
    });
    Factors::of_rows(tree, &rows.collect::<Vec<_>>())
}

/// A row on its way inward.
struct Gained {
    body: BodyId,
    speed: SpeedId,
    row: Wrench,
}

/// Rows that pass a joint, at whose motions their entries are read off.
struct Gaining<'a> {
    tree: &'a Tree,
    body: BodyId,
    gains: &'a BTreeMap<SpeedId, (Expr, [Expr; 6])>,
    carried: Vec<Gained>,
    order: &'a mut Vec<SpeedId>,
    rows: &'a mut BTreeMap<SpeedId, Vec<(SpeedId, Expr)>>,
}

impl Gaining<'_> {
    /// Motions enter, the last first: the rows on their way have an entry for each, and its own begins.
    fn meet(&mut self, graph: &mut ExprGraph, motions: [Option<Motion>; 3], first: usize) {
        for (axis, motion) in motions.into_iter().enumerate().rev() {
            let Some(Motion { speed, .. }) = motion else {
                continue;
            };
            for own in &self.carried {
                let entry = own.row.parts()[first + axis];
                if !graph.is_zero(entry) {
                    self.rows.entry(own.speed).or_default().push((speed, entry));
                }
            }
            let (_, factors) = self.gains[&speed];
            self.order.push(speed);
            self.carried.push(Gained {
                body: self.body,
                speed,
                row: Wrench::of_parts(factors),
            });
        }
    }

    fn each(&mut self, graph: &mut ExprGraph, change: impl Fn(&mut ExprGraph, &Wrench) -> Wrench) {
        for own in &mut self.carried {
            graph.enter(own.body);
            own.row = change(graph, &own.row);
        }
    }
}

impl Passenger for Gaining<'_> {
    fn shift(&mut self, graph: &mut ExprGraph, lower: BodyId, offset: Vector) {
        self.each(graph, |graph, row| row.moved(graph, offset));
        let at = &self.tree.body(lower).identifier;
        for own in &self.carried {
            graph.name_vector(own.row.moment, &format!("l_n_{at}"));
            graph.name_vector(own.row.force, &format!("l_f_{at}"));
        }
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive) {
        self.meet(graph, drive.motions(), 0);
        self.each(graph, |graph, row| row.map(|v| rotation.backward(graph, v)));
    }

    fn along(&mut self, graph: &mut ExprGraph, motions: [Option<Motion>; 3]) {
        self.meet(graph, motions, 3);
    }
}
