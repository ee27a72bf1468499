//! Sines. Needs: nothing. Afterwards: the sines and cosines of angles among the coordinates, and of what is such an angle or
//! several of them plus what is known before the loop, are inputs or made of inputs by the addition theorems. Keeps: the
//! value of every root, up to rounding, and bit for bit where no theorem is needed. Does not: touch the sine of a multiple
//! of an angle, as of a joint that follows another with a ratio; it stays, and its angle is computed from `q`.

use std::collections::BTreeMap;

use super::theorems::{of_angle, of_sum, without_crumb};
use crate::{
    expr::{Binding, Expr, ExprGraph, Input, Node, NodeId, Rebuilt},
    id::CoordinateId,
    tree::Angle,
};

/// The graph with the sines and cosines of `angles` given, and its roots.
pub fn run(old: &ExprGraph, roots: &[Expr], angles: &[Angle]) -> (ExprGraph, Vec<Expr>) {
    let places = angles.iter().enumerate();
    let places = places.map(|(place, angle)| (angle.coordinate, place));
    let mut pairs = Pairs {
        old,
        places: places.collect(),
        known: vec![Known::NotYet; old.len()],
    };
    let needed = old.reachable(roots);
    let mut graph = ExprGraph::with_capacity(old.len());
    let mut rebuilt = Rebuilt::new(old);
    for id in old.ids().filter(|id| needed[id.index()]) {
        graph.enter_like(old, id);
        let pair = match old.node(id) {
            Node::Sin(angle) | Node::Cos(angle) => pairs.of(&mut graph, &rebuilt, Expr::of(angle)),
            _ => None,
        };
        let expr = match pair {
            None => rebuilt.copy(&mut graph, old, id),
            Some([sine, cosine]) => {
                let is_sine = matches!(old.node(id), Node::Sin(_));
                if is_sine { sine } else { cosine }
            }
        };
        graph.name_like(expr, old, id);
        rebuilt.set(id, expr);
    }
    let roots = roots.iter().map(|&root| rebuilt.expr(root)).collect();
    (graph, roots)
}

/// Sines and cosines of angles.
struct Pairs<'a> {
    old: &'a ExprGraph,
    places: BTreeMap<CoordinateId, usize>,
    /// By nodes.
    known: Vec<Known>,
}

/// What is known of an angle.
#[derive(Clone, Copy)]
enum Known {
    NotYet,
    Pair([Expr; 2]),
    /// Its sine and cosine are of another kind.
    Other,
}

impl Pairs<'_> {
    /// Sine and cosine of an angle, of a sum from those of its terms, so that sums which continue one another share them.
    /// `None` where it has others.
    fn of(&mut self, graph: &mut ExprGraph, rebuilt: &Rebuilt, angle: Expr) -> Option<[Expr; 2]> {
        // Sums may be as deep as the tree.
        let mut open = vec![angle.node()];
        while let Some(&id) = open.last() {
            if let Some(term) = self.lacking(id) {
                open.push(term);
            } else {
                open.pop();
                if self.is_new(id) {
                    let pair = self.of_terms(graph, rebuilt, id);
                    self.known[id.index()] = pair.map_or(Known::Other, Known::Pair);
                }
            }
        }
        self.at(angle)
    }

    /// The first term of an angle that must be known before; the second is not asked for where the first has others.
    fn lacking(&self, id: NodeId) -> Option<NodeId> {
        let Node::Add(a, b) = self.old.node(id) else {
            return None;
        };
        if !self.is_new(id) || self.old.binding(id) != Binding::State {
            return None;
        }
        let [a, b] = [a, b].map(Expr::node);
        match self.known[a.index()] {
            Known::NotYet => Some(a),
            Known::Pair(_) => self.is_new(b).then_some(b),
            Known::Other => None,
        }
    }

    fn is_new(&self, id: NodeId) -> bool {
        matches!(self.known[id.index()], Known::NotYet)
    }

    /// What is known of an angle.
    fn at(&self, angle: Expr) -> Option<[Expr; 2]> {
        match self.known[angle.node().index()] {
            Known::Pair([sine, cosine]) => Some([sine.signed(angle.is_negative()), cosine]),
            Known::NotYet | Known::Other => None,
        }
    }

    fn of_terms(&self, graph: &mut ExprGraph, rebuilt: &Rebuilt, id: NodeId) -> Option<[Expr; 2]> {
        if self.old.binding(id) != Binding::State {
            let angle = rebuilt.node(id);
            return Some(of_angle(graph, angle).map(|entry| without_crumb(graph, entry)));
        }
        match self.old.node(id) {
            Node::Input(Input::Q(coordinate)) => {
                let &place = self.places.get(&coordinate)?;
                Some([Input::Sine(place), Input::Cosine(place)].map(|input| graph.input(input)))
            }
            Node::Add(a, b) => {
                let (one, other) = (self.at(a)?, self.at(b)?);
                Some(of_sum(graph, one, other))
            }
            _ => None,
        }
    }
}
