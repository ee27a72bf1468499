//! Nodes built anew: of other operands, or with other expressions for inputs.

use std::collections::BTreeMap;

use super::{Expr, ExprGraph, Input, Label, Node, NodeId};

impl ExprGraph {
    /// A node of this or of another graph, of the operands that stand here for its own.
    pub fn copied(&mut self, node: Node, operand: impl Fn(NodeId) -> Expr) -> Expr {
        let signed = |term: Expr| operand(term.node()).signed(term.is_negative());
        match node {
            Node::Number(bits) => self.number(f64::from_bits(bits)),
            Node::Input(input) => self.input(input),
            Node::Sin(a) => self.sin(operand(a)),
            Node::Cos(a) => self.cos(operand(a)),
            Node::Abs(a) => self.abs(operand(a)),
            Node::Add(a, b) => self.add(signed(a), signed(b)),
            Node::Mul(a, b) => self.mul(operand(a), operand(b)),
            Node::Div(a, b) => self.div(operand(a), operand(b)),
        }
    }

    /// Gives an expression a label that another had.
    pub(super) fn label_as(&mut self, expr: Expr, label: Label) {
        if label.is_hint {
            self.hint(|graph| graph.name(expr, label.text));
        } else {
            self.name(expr, label.text);
        }
    }

    /// The same with other expressions, of this graph, for some inputs. What depends on these is built anew, where and under the
    /// name that it had; what does not stays.
    pub fn substituted(&mut self, roots: &[Expr], values: &BTreeMap<Input, Expr>) -> Vec<Expr> {
        let needed = self.reachable(roots);
        let mut changed: BTreeMap<NodeId, Expr> = BTreeMap::new();
        for id in self.ids().filter(|id| needed[id.index()]) {
            let node = self.node(id);
            if let Node::Input(input) = node {
                changed.extend(values.get(&input).map(|value| (id, *value)));
            } else if node
                .operands()
                .any(|operand| changed.contains_key(&operand))
            {
                self.enter(self.scope(id));
                self.begin(self.purpose(id));
                let operand = |id: NodeId| changed.get(&id).copied().unwrap_or(Expr::of(id));
                let expr = self.copied(node, operand);
                if let Some(label) = self.label(id).cloned() {
                    self.label_as(expr.signed(label.negative), label);
                }
                changed.insert(id, expr);
            }
        }
        let root = |root: &Expr| {
            let new = changed.get(&root.node()).copied();
            new.map_or(*root, |new| new.signed(root.is_negative()))
        };
        roots.iter().map(root).collect()
    }
}
