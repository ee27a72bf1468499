//! Rebuilding a graph node by node, from which each pass departs where it knows better.

use super::{
    graph::ExprGraph,
    node::{Expr, Input, Node, NodeId},
};

/// The nodes of an old graph, as expressions of a new one.
#[derive(Debug)]
pub(crate) struct Rebuilt {
    new: Vec<Option<Expr>>,
}

impl Rebuilt {
    pub(crate) fn new(old: &ExprGraph) -> Self {
        Self {
            new: vec![None; old.len()],
        }
    }

    pub(crate) fn set(&mut self, id: NodeId, expr: Expr) {
        self.new[id.index()] = Some(expr);
    }

    /// True once it is there.
    pub(crate) fn has(&self, id: NodeId) -> bool {
        self.new[id.index()].is_some()
    }

    pub(crate) fn node(&self, id: NodeId) -> Expr {
        self.new[id.index()].expect("expr: operands are rebuilt before what uses them")
    }

    pub(crate) fn expr(&self, expr: Expr) -> Expr {
        self.node(expr.node()).signed(expr.is_negative())
    }

    /// The node as it was, of rebuilt operands.
    pub(crate) fn copy(&self, graph: &mut ExprGraph, old: &ExprGraph, id: NodeId) -> Expr {
        if let Node::Input(Input::CallResult(result)) = old.node(id) {
            graph.take_call(old, result.call, |expr| self.expr(expr));
        }
        graph.copied(old.node(id), |operand| self.node(operand))
    }
}
