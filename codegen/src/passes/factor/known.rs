//! The last step: of the terms of a sum those that are known before the loop, numbers and what depends on parameters alone, are
//! added up, wherever in the part of it of one body they stand. They would cost an addition each.

use super::super::rebuild::Rebuilt;
use crate::expr::{Binding, Expr, ExprGraph, Node, NodeId};

/// The graph with such terms gathered, and its roots.
pub(super) fn gathered(old: &ExprGraph, roots: &[Expr]) -> (ExprGraph, Vec<Expr>) {
    let uses = old.uses(roots);
    let places = places(old, &uses);
    let mut graph = ExprGraph::with_capacity(old.len());
    let mut rebuilt = Rebuilt::new(old);
    // Of the parts of sums that are gathered what is known, in the new graph; `rebuilt` has the rest of them.
    let mut known: Vec<Option<Expr>> = vec![None; old.len()];
    for id in old.ids().filter(|id| uses[id.index()] > 0) {
        graph.enter_like(old, id);
        let (Node::Add(a, b), Place::Head | Place::Part) = (old.node(id), places[id.index()])
        else {
            let expr = rebuilt.copy(&mut graph, old, id);
            graph.name_like(expr, old, Expr::of(id));
            rebuilt.set(id, expr);
            continue;
        };
        let zero = graph.zero();
        let [a, b] = [a, b].map(|term| {
            let (expr, negative) = (rebuilt.expr(term), term.is_negative());
            match known[term.node().index()] {
                Some(known) => (expr, known.signed(negative)),
                None if is_known(old, term.node()) => (zero, expr),
                None => (expr, zero),
            }
        });
        let (rest, sum) = (graph.add(a.0, b.0), graph.add(a.1, b.1));
        if places[id.index()] == Place::Head {
            let whole = graph.add(rest, sum);
            graph.name_like(whole, old, Expr::of(id));
            rebuilt.set(id, whole);
        } else {
            rebuilt.set(id, rest);
            known[id.index()] = Some(sum);
        }
    }
    let roots = roots.iter().map(|&root| rebuilt.expr(root)).collect();
    (graph, roots)
}

/// What a node is to the sums that are gathered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Place {
    /// None of them, or a term.
    Other,
    /// A sum with several known terms.
    Head,
    /// A part of such a sum, and of nothing else.
    Part,
}

fn places(graph: &ExprGraph, uses: &[u32]) -> Vec<Place> {
    let is_sum = |id: NodeId| {
        uses[id.index()] > 0 && matches!(graph.node(id), Node::Add(..)) && !is_known(graph, id)
    };
    let is_part = |of: NodeId, id: NodeId| {
        let is_free = graph.label(id).is_none_or(|label| label.is_hint);
        let same_body = graph.scope(id) == graph.scope(of);
        uses[id.index()] == 1 && is_free && same_body && is_sum(id)
    };
    let mut n_known = vec![0_u32; graph.len()];
    for id in graph.ids().filter(|id| is_sum(*id)) {
        let operands = graph.node(id).operands();
        n_known[id.index()] = operands
            .map(|operand| match is_known(graph, operand) {
                true => 1,
                false if is_part(id, operand) => n_known[operand.index()],
                false => 0,
            })
            .sum();
    }
    let mut places = vec![Place::Other; graph.len()];
    for id in graph.ids().rev().filter(|id| is_sum(*id)) {
        // What uses it was met before: if that is no such sum, it is the head of what it adds up.
        if places[id.index()] == Place::Other && n_known[id.index()] > 1 {
            places[id.index()] = Place::Head;
        }
        if places[id.index()] != Place::Other {
            for operand in graph.node(id).operands().filter(|own| is_part(id, *own)) {
                places[operand.index()] = Place::Part;
            }
        }
    }
    places
}

fn is_known(graph: &ExprGraph, id: NodeId) -> bool {
    graph.binding(id) != Binding::State
}
