//! `L^T D L`, speed by speed. Where branches are on carriers, what is eliminated beyond one is left to it as an inertia along the
//! root's motions, of which every speed on the way there takes its part.

use std::collections::BTreeMap;

use super::{
    BodySpeed, Factors, SpeedMatrix,
    carriers::{Carriers, Derived, dot},
    elimination_order, inverse,
};
use crate::{
    expr::{Expr, ExprGraph, Purpose},
    id::BodyId,
    tree::Tree,
};

/// An inertia along the six motions of a root.
type RootInertia = [[Expr; 6]; 6];

/// Factorises a mass matrix.
pub fn factorise(graph: &mut ExprGraph, tree: &Tree, a: SpeedMatrix) -> Factors {
    factorise_on_carriers(graph, tree, a, &Carriers::default())
}

/// Factorises a mass matrix along a tree with carriers.
pub fn factorise_on_carriers(
    graph: &mut ExprGraph,
    tree: &Tree,
    a: SpeedMatrix,
    carriers: &Carriers,
) -> Factors {
    factorised(graph, tree, a, elimination_order(tree), carriers)
}

/// Factorises the rows and columns of a mass matrix that belong to the speeds in this order; the pivots of others are zero.
pub(super) fn factorised(
    graph: &mut ExprGraph,
    tree: &Tree,
    a: SpeedMatrix,
    order: Vec<BodySpeed>,
    carriers: &Carriers,
) -> Factors {
    graph.begin(Purpose::Factors);
    let mut elimination = Elimination {
        tree,
        carriers,
        a,
        left: BTreeMap::new(),
    };
    let mut pivots = vec![graph.zero(); tree.n_speeds];
    let mut couplings = Vec::with_capacity(order.len());
    for (place, &k) in order.iter().enumerate() {
        graph.enter(k.body);
        elimination.take(graph, k.body);
        let pivot = elimination.a[k.index()][k.index()];
        graph.name(pivot, format!("pivot_{}", k.coordinate));
        pivots[k.index()] = pivot;
        couplings.push(elimination.eliminate(graph, k, &order[place + 1..]));
    }
    Factors {
        order,
        couplings,
        pivots,
    }
}

struct Elimination<'a> {
    tree: &'a Tree,
    carriers: &'a Carriers,
    a: SpeedMatrix,
    /// What was eliminated beyond each carrier, but for roots, whose entries have it.
    left: BTreeMap<BodyId, RootInertia>,
}

impl Elimination<'_> {
    /// Takes what was left to a carrier into the rows of its speed, and hands it to the lower one.
    fn take(&mut self, graph: &mut ExprGraph, body: BodyId) {
        let Some(left) = self.left.remove(&body) else {
            return;
        };
        let Some((speed, motion)) = self.carriers.own(body) else {
            return;
        };
        let of_motion = left.map(|row| dot(graph, &row, &motion));
        let own = speed.index();
        for (root, share) in self.carriers.root(body).into_iter().zip(of_motion) {
            let entry = graph.add(self.a[own][root.index()], share);
            self.set(own, root.index(), entry);
        }
        let share = dot(graph, &of_motion, &motion);
        self.a[own][own] = graph.add(self.a[own][own], share);
        if let Some(lower) = self.tree.lower(body) {
            graph.enter(lower);
            for (i, row) in left.iter().enumerate() {
                for (j, &share) in row.iter().enumerate().take(i + 1) {
                    self.leave(graph, lower, [i, j], share);
                }
            }
            graph.enter(body);
        }
    }

    fn set(&mut self, row: usize, column: usize, entry: Expr) {
        self.a[row][column] = entry;
        self.a[column][row] = entry;
    }

    /// Adds to what is left to a carrier along two motions of its root.
    fn leave(&mut self, graph: &mut ExprGraph, carrier: BodyId, [i, j]: [usize; 2], share: Expr) {
        if self.carriers.own(carrier).is_none() {
            let [row, column] = [i, j].map(|k| self.carriers.root(carrier)[k].index());
            let entry = graph.add(self.a[row][column], share);
            self.set(row, column, entry);
            return;
        }
        let zero = graph.zero();
        let left = self.left.entry(carrier).or_insert([[zero; 6]; 6]);
        let entry = graph.add(left[i][j], share);
        (left[i][j], left[j][i]) = (entry, entry);
    }

    /// Eliminates a speed; the row of L, with the entries of all speeds on the way to its carrier.
    fn eliminate(
        &mut self,
        graph: &mut ExprGraph,
        k: BodySpeed,
        farther: &[BodySpeed],
    ) -> Vec<(BodySpeed, Expr)> {
        let carrier = self.carriers.toward(self.tree, self.tree.lower(k.body));
        let places = carrier.map(|own| self.carriers.root(own));
        let at_root = |other: BodySpeed| {
            let mut places = places.iter().flatten();
            places.position(|root| *root == other.speed)
        };
        let is_met = |other: &BodySpeed| {
            carrier.is_none() || !self.carriers.contains(other.body) || at_root(*other).is_some()
        };
        let inverse = inverse(graph, k, self.a[k.index()][k.index()]);
        let coupled = farther.iter().copied().filter(is_met);
        let coupled: Vec<BodySpeed> = coupled
            .filter(|other| !graph.is_zero(self.a[k.index()][other.index()]))
            .collect();
        let mut row = Vec::with_capacity(coupled.len());
        let mut of_root = [graph.zero(); 6];
        for (i, &speed) in coupled.iter().enumerate() {
            graph.enter(k.body);
            let factor = graph.mul(self.a[k.index()][speed.index()], inverse);
            let at = &self.tree.body(speed.body).identifier;
            let name = format!("l_{}_{at}_{}", k.coordinate, speed.coordinate);
            graph.name(factor, name);
            for &other in &coupled[..=i] {
                // The entry is there because of the outer of its two bodies.
                graph.enter(other.body);
                let update = graph.mul(factor, self.a[k.index()][other.index()]);
                if let (Some(carrier), Some(i), Some(j)) = (carrier, at_root(speed), at_root(other))
                {
                    self.leave(graph, carrier, [i, j], -update);
                } else {
                    let entry = graph.sub(self.a[speed.index()][other.index()], update);
                    self.set(speed.index(), other.index(), entry);
                }
            }
            if let Some(place) = at_root(speed) {
                of_root[place] = factor;
            }
            row.push((speed, factor));
        }
        if let Some(carrier) = carrier {
            row.extend(self.derived(graph, carrier, &of_root, farther));
        }
        row
    }

    /// The entries of a row of L for the speeds on the way to a carrier.
    fn derived(
        &self,
        graph: &mut ExprGraph,
        carrier: BodyId,
        of_root: &[Expr; 6],
        farther: &[BodySpeed],
    ) -> Vec<(BodySpeed, Expr)> {
        let entries = self.carriers.entries(graph, self.tree, carrier, of_root);
        let entries = entries
            .into_iter()
            .filter_map(|Derived { speed, entry, .. }| {
                let own = farther.iter().find(|own| own.speed == speed)?;
                Some((*own, entry))
            });
        entries
            .filter(|(_, entry)| !graph.is_zero(*entry))
            .collect()
    }
}
