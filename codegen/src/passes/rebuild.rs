//! Rebuilding a graph node by node, from which each pass departs where it knows better.

use crate::expr::{Expr, ExprGraph, Node, NodeId};

/// The nodes of an old graph, as expressions of a new one.
#[derive(Debug)]
pub(super) struct Rebuilt {
    new: Vec<Option<Expr>>,
}

impl Rebuilt {
    pub(super) fn new(old: &ExprGraph) -> Self {
        Self {
            new: vec![None; old.len()],
        }
    }

    pub(super) fn set(&mut self, id: NodeId, expr: Expr) {
        self.new[id.index()] = Some(expr);
    }

    pub(super) fn node(&self, id: NodeId) -> Expr {
        self.new[id.index()].expect("passes: operands are rebuilt before what uses them")
    }

    pub(super) fn expr(&self, expr: Expr) -> Expr {
        self.node(expr.node()).signed(expr.is_negative())
    }

    /// The node as it was, of rebuilt operands.
    pub(super) fn copy(&self, graph: &mut ExprGraph, old: &ExprGraph, id: NodeId) -> Expr {
        match old.node(id) {
            Node::Number(bits) => graph.number(f64::from_bits(bits)),
            Node::Input(input) => graph.input(input),
            Node::Sin(a) => graph.sin(self.node(a)),
            Node::Cos(a) => graph.cos(self.node(a)),
            Node::Abs(a) => graph.abs(self.node(a)),
            Node::Add(a, b) => graph.add(self.expr(a), self.expr(b)),
            Node::Mul(a, b) => graph.mul(self.node(a), self.node(b)),
            Node::Div(a, b) => graph.div(self.node(a), self.node(b)),
        }
    }
}
