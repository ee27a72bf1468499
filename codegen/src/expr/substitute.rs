//! Expressions in which inputs are other expressions.

use std::collections::BTreeMap;

use super::{Expr, ExprGraph, Input, Node, NodeId};

impl ExprGraph {
    /// The same with other expressions, of this graph, for some inputs. What depends on these is built anew, where and under the
    /// name that it had; what does not stays.
    pub fn substituted(&mut self, roots: &[Expr], values: &BTreeMap<Input, Expr>) -> Vec<Expr> {
        let needed = self.reachable(roots);
        let mut changed: BTreeMap<NodeId, Expr> = BTreeMap::new();
        let ids = self.ids().filter(|id| needed[id.index()]);
        for id in ids.collect::<Vec<_>>() {
            let node = self.node(id);
            let mut operands = node.operands();
            let new = match node {
                Node::Input(input) => values.get(&input).copied(),
                _ if operands.any(|operand| changed.contains_key(&operand)) => {
                    Some(self.rebuilt(id, &changed))
                }
                _ => None,
            };
            changed.extend(new.map(|new| (id, new)));
        }
        roots.iter().map(|root| new(&changed, *root)).collect()
    }

    /// A node of other operands.
    fn rebuilt(&mut self, id: NodeId, changed: &BTreeMap<NodeId, Expr>) -> Expr {
        self.enter(self.scope(id));
        self.begin(self.purpose(id));
        let of = |id| new(changed, Expr::of(id));
        let expr = match self.node(id) {
            Node::Number(_) | Node::Input(_) => Expr::of(id),
            Node::Sin(a) => self.sin(of(a)),
            Node::Cos(a) => self.cos(of(a)),
            Node::Abs(a) => self.abs(of(a)),
            Node::Add(a, b) => self.add(new(changed, a), new(changed, b)),
            Node::Mul(a, b) => self.mul(of(a), of(b)),
            Node::Div(a, b) => self.div(of(a), of(b)),
        };
        if let Some(label) = self.label(id).cloned() {
            let named = expr.signed(label.negative);
            if label.is_hint {
                self.hint(|graph| graph.name(named, label.text));
            } else {
                self.name(named, label.text);
            }
        }
        expr
    }
}

/// An operand as it is now.
fn new(changed: &BTreeMap<NodeId, Expr>, old: Expr) -> Expr {
    let new = changed.get(&old.node()).copied();
    new.map_or(old, |new| new.signed(old.is_negative()))
}
