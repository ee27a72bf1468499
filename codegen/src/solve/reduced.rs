//! Rows of the factors with what lies between a speed and a body farther in eliminated, once for many right-hand sides.

use std::collections::{BTreeMap, BTreeSet};

use super::{BodySpeed, Carriers, Factors};
use crate::{
    expr::{Expr, ExprGraph},
    id::BodyId,
    tree::Tree,
};

/// Entries of a row by their places in the order of elimination.
pub(super) type Row = Vec<(usize, Expr)>;

/// Rows of `-L`, with what was eliminated from them. Speeds are their places in the order of elimination: what is farther in
/// has a higher one.
#[derive(Debug)]
pub(super) struct Reduced<'a> {
    carriers: &'a Carriers,
    order: Vec<BodySpeed>,
    /// Whatever a speed is coupled with, and that one, and so on.
    reached: Vec<BTreeSet<usize>>,
    /// The first one on the next body farther in.
    foot: Vec<Option<usize>>,
    /// By speed, and by the place below which all was eliminated.
    known: BTreeMap<(usize, usize), Row>,
}

impl<'a> Reduced<'a> {
    pub(super) fn new(factors: &Factors, carriers: &'a Carriers) -> Self {
        let n = factors.order.len();
        let mut places = vec![0; factors.n_speeds()];
        for (place, k) in factors.order.iter().enumerate() {
            places[k.index()] = place;
        }
        let row = |couplings: &Vec<(BodySpeed, Expr)>| -> Row {
            let entries = couplings.iter();
            let entries = entries.map(|&(speed, factor)| (places[speed.index()], -factor));
            entries.collect()
        };
        let own: Vec<Row> = factors.couplings.iter().map(row).collect();
        let next: Vec<Option<usize>> = own
            .iter()
            .map(|row| row.iter().map(|&(other, _)| other).min())
            .collect();
        let (mut reached, mut foot) = (vec![BTreeSet::new(); n], vec![None; n]);
        for place in (0..n).rev() {
            for &(other, _) in &own[place] {
                let farther = reached[other].clone();
                reached[place].extend(farther);
                reached[place].insert(other);
            }
            let body = |place: usize| factors.order[place].body;
            foot[place] = match next[place] {
                Some(below) if body(below) == body(place) => foot[below],
                below => below,
            };
        }
        let rows = own
            .into_iter()
            .enumerate()
            .map(|(place, row)| ((place, 0), row));
        Self {
            carriers,
            order: factors.order.clone(),
            reached,
            foot,
            known: rows.collect(),
        }
    }

    /// A speed and all farther in that it is coupled with, directly or through others.
    pub(super) fn path(&self, place: usize) -> BTreeSet<usize> {
        let mut path = self.reached[place].clone();
        path.insert(place);
        path
    }

    /// The shortest row of `-L` that gives a speed's solution, where the right-hand side is zero but at these places, and the
    /// body up to which all was eliminated, if any was.
    pub(super) fn row(
        &mut self,
        graph: &mut ExprGraph,
        tree: &Tree,
        i: usize,
        places: &BTreeSet<usize>,
    ) -> (Row, Option<BodyId>) {
        // What must stay.
        let Some(&first) = self.reached[i].intersection(places).next() else {
            return (Vec::new(), None);
        };
        let (mut cut, mut at) = (0, i);
        while let Some(foot) = self.next_foot(at).filter(|foot| *foot <= first) {
            self.eliminate(graph, tree, i, [cut, foot]);
            (cut, at) = (foot, foot);
        }
        let foot = (cut > 0).then(|| self.order[cut].body);
        (self.known[&(i, cut)].clone(), foot)
    }

    /// Up to where is eliminated next. What is on a carrier is felt by that carrier or by the root.
    fn next_foot(&self, place: usize) -> Option<usize> {
        let body = |place: usize| self.order[place].body;
        let mut foot = self.foot[place];
        if self.carriers.contains(body(place)) {
            while let Some(own) = foot.filter(|own| self.carriers.own(body(*own)).is_some()) {
                foot = self.foot[own];
            }
        }
        foot
    }

    /// Makes the row from which all below the place `to` is eliminated, of that from which all below `from` was.
    fn eliminate(&mut self, graph: &mut ExprGraph, tree: &Tree, i: usize, [from, to]: [usize; 2]) {
        if self.known.contains_key(&(i, to)) {
            return;
        }
        let row = self.known[&(i, from)].clone();
        let (gone, stays): (Row, Row) = row.into_iter().partition(|&(other, _)| other < to);
        let mut sums: BTreeMap<usize, Expr> = stays.into_iter().collect();
        for (k, factor) in gone {
            self.eliminate(graph, tree, k, [0, to]);
            graph.enter(self.order[i].body);
            for &(other, entry) in &self.known[&(k, to)] {
                let term = graph.mul(factor, entry);
                let sum = sums.get(&other).copied();
                let sum = sum.map_or(term, |sum| graph.add(sum, term));
                sums.insert(other, sum);
            }
        }
        self.derive(graph, tree, [i, to], &mut sums);
        let (own, foot) = (self.order[i], &tree.body(self.order[to].body).identifier);
        for (&other, &entry) in &sums {
            let other = self.order[other];
            let at = &tree.body(other.body).identifier;
            let [k, l] = [own, other].map(|speed| speed.coordinate);
            graph.name(entry, format!("l_{k}_{at}_{l}_on_{foot}"));
        }
        self.known.insert((i, to), sums.into_iter().collect());
    }

    /// Replaces the entries of speeds on the way to a carrier, from which all beyond was eliminated, where that is cheaper than
    /// what was eliminated from them.
    fn derive(
        &self,
        graph: &mut ExprGraph,
        tree: &Tree,
        [i, to]: [usize; 2],
        sums: &mut BTreeMap<usize, Expr>,
    ) {
        let carrier = self.order[to].body;
        if !self.carriers.contains(carrier) {
            return;
        }
        let n_eliminated = self.reached[i].range(..to).count();
        let zero = graph.zero();
        let place = |speed| self.order.iter().position(|own| own.speed == speed);
        let root = self.carriers.root(carrier).map(|own| {
            let entry = place(own).and_then(|place| sums.get(&place));
            entry.copied().unwrap_or(zero)
        });
        for own in self.carriers.entries(graph, tree, carrier, &root) {
            if own.n_parts <= n_eliminated
                && let Some(place) = place(own.speed)
            {
                sums.insert(place, own.entry);
            }
        }
    }
}
