//! Hoist. Needs: nothing. Afterwards: a function's graph holds no operation that depends on parameters alone, and no
//! parameter: each such value is an input `Prepared(i)`, computed once in [`Preparation`], which all functions of a
//! module share. Keeps: the value of every root. Does not: move numbers, which cost nothing.

use super::rebuild::Rebuilt;
use crate::expr::{Binding, Expr, ExprGraph, Input, Node};

/// The values that depend on parameters alone.
#[derive(Clone, Debug, Default)]
pub struct Preparation {
    /// Their graph, whose inputs are parameters.
    pub graph: ExprGraph,
    /// The values in the order of `Input::Prepared`.
    pub roots: Vec<Expr>,
}

/// The graph with the parameters' own work taken out, and its roots.
pub fn run(
    old: &ExprGraph,
    roots: &[Expr],
    preparation: &mut Preparation,
) -> (ExprGraph, Vec<Expr>) {
    let needed = old.reachable(roots);
    let mut outside = Rebuilt::new(old);
    let mut inside = Rebuilt::new(old);
    let mut graph = ExprGraph::default();
    for id in old.ids().filter(|id| needed[id.index()]) {
        if old.binding(id) != Binding::State {
            preparation.graph.enter(old.scope(id));
            let expr = outside.copy(&mut preparation.graph, old, id);
            preparation.graph.name_like(expr, old, Expr::of(id));
            outside.set(id, expr);
        }
    }
    let mut boundary = vec![false; old.len()];
    for id in old
        .ids()
        .filter(|id| needed[id.index()] && old.binding(*id) == Binding::State)
    {
        for operand in old.node(id).operands() {
            boundary[operand.index()] = true;
        }
    }
    for root in roots {
        boundary[root.node().index()] = true;
    }
    for id in old.ids().filter(|id| needed[id.index()]) {
        graph.enter(old.scope(id));
        let expr = match old.binding(id) {
            Binding::Parameters if !boundary[id.index()] => continue,
            Binding::Parameters => preparation.take(&mut graph, outside.node(id)),
            Binding::Number | Binding::State => inside.copy(&mut graph, old, id),
        };
        graph.name_like(expr, old, Expr::of(id));
        inside.set(id, expr);
    }
    let roots = roots.iter().map(|&root| inside.expr(root)).collect();
    (graph, roots)
}

impl Preparation {
    /// A value of the preparation as an input of a function.
    fn take(&mut self, graph: &mut ExprGraph, value: Expr) -> Expr {
        if let Node::Number(bits) = self.graph.node(value.node()) {
            return graph
                .number(f64::from_bits(bits))
                .signed(value.is_negative());
        }
        let positive = value.abs_sign();
        let place = self
            .roots
            .iter()
            .position(|&root| root == positive)
            .unwrap_or_else(|| {
                self.roots.push(positive);
                self.roots.len() - 1
            });
        graph
            .input(Input::Prepared(place))
            .signed(value.is_negative())
    }
}
