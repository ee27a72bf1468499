//! The graph: every constructor folds, shares, and keeps signs on references.

use std::collections::BTreeMap;

use rustc_hash::FxHashMap;

use super::{
    lockstep::Lockstep,
    node::{Binding, Expr, Input, Label, Node, NodeId},
    nodes::Nodes,
    purpose::Purpose,
};
use crate::{
    id::BodyId,
    number::{Number as _, Rounded},
};

/// A hash-consed graph of scalar expressions.
///
/// Each node remembers the body in whose scope it was first built, and perhaps a label: names in the
/// output come from these, so they follow the structure of the system and not the order of its nodes.
#[derive(Clone, Debug, Default)]
pub struct ExprGraph {
    pub(super) nodes: Nodes,
    bindings: Vec<Binding>,
    scopes: Vec<Option<BodyId>>,
    purposes: Vec<Purpose>,
    labels: Vec<Option<Label>>,
    /// For each node, whether it was its negative that was written.
    written_negative: Vec<bool>,
    /// How far folding may have left numbers from the exact ones, where that is more than [`Self::DIGITS_LOST`].
    lost: FxHashMap<NodeId, f64>,
    /// Helpers and their calls, by number.
    pub(super) locksteps: BTreeMap<u16, Lockstep<Self>>,
    scope: Option<BodyId>,
    purpose: Purpose,
    /// True while labels are hints.
    hints: bool,
    overflowed: bool,
    n_asked: usize,
}

impl ExprGraph {
    /// What a number may be off by, relative to itself, and still count as one with all its digits.
    const DIGITS_LOST: f64 = 4.0 * f64::EPSILON;

    /// An empty graph with room for so many nodes, which then need not be moved.
    pub fn with_capacity(n_nodes: usize) -> Self {
        Self {
            nodes: Nodes::with_capacity(n_nodes),
            bindings: Vec::with_capacity(n_nodes),
            scopes: Vec::with_capacity(n_nodes),
            purposes: Vec::with_capacity(n_nodes),
            labels: Vec::with_capacity(n_nodes),
            written_negative: Vec::with_capacity(n_nodes),
            ..Self::default()
        }
    }

    /// From here on new nodes belong to `scope`: a body, or the whole system.
    pub fn enter(&mut self, scope: impl Into<Option<BodyId>>) {
        self.scope = scope.into();
    }

    /// From here on new nodes are for this, whichever body they are of.
    pub fn begin(&mut self, purpose: Purpose) {
        self.purpose = purpose;
    }

    /// From here on new nodes belong to the scope of a node of another graph, and are for the same.
    pub fn enter_like(&mut self, other: &Self, id: NodeId) {
        self.scope = other.scope(id);
        self.purpose = other.purpose(id);
    }

    /// Number of nodes.
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// True for a graph without nodes.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// How many sums and products were asked for, with those that were there or could be folded: the work that was done.
    pub fn n_asked(&self) -> usize {
        self.n_asked
    }

    /// The node with this id.
    pub fn node(&self, id: NodeId) -> Node {
        self.nodes.get(id)
    }

    /// The nodes in order of creation, operands first.
    pub fn ids(&self) -> impl DoubleEndedIterator<Item = NodeId> + use<> {
        (0..u32::try_from(self.nodes.len()).expect("node ids are u32")).map(NodeId)
    }

    /// The body in whose scope the node was built.
    pub fn scope(&self, id: NodeId) -> Option<BodyId> {
        self.scopes[id.index()]
    }

    /// What the node is for.
    pub fn purpose(&self, id: NodeId) -> Purpose {
        self.purposes[id.index()]
    }

    /// The node's label.
    pub fn label(&self, id: NodeId) -> Option<&Label> {
        self.labels[id.index()].as_ref()
    }

    /// The node with the sign with which it was written: canonical form may have turned it round.
    pub fn as_written(&self, id: NodeId) -> Expr {
        Expr::new(id, self.written_negative[id.index()])
    }

    /// When the node's value is known.
    pub fn binding(&self, id: NodeId) -> Binding {
        self.bindings[id.index()]
    }

    /// Gives what a node of another graph became here its label and its sign.
    pub fn name_like(&mut self, expr: Expr, other: &Self, original: NodeId) {
        let written = other.as_written(original).is_negative();
        self.written_negative[expr.node().index()] = written ^ expr.is_negative();
        if let Some(label) = other.label(original) {
            self.label_as(expr.signed(label.negative), label.clone());
        }
    }

    /// Labels what has no label by hints: passes treat it as if it had none.
    pub fn hint(&mut self, label: impl FnOnce(&mut Self)) {
        self.hints = true;
        label(self);
        self.hints = false;
    }

    /// Labels an operation that has no label yet, and moves it into the current scope, whose quantity it is. A number or
    /// an input keeps its own name, but for what a call computes, and so does what belongs to a body further inward.
    pub fn name(&mut self, expr: Expr, text: impl Into<String>) {
        self.name_by(expr, || text.into());
    }

    /// The same, with a text that is made only where it is needed.
    pub fn name_by(&mut self, expr: Expr, text: impl FnOnce() -> String) {
        let id = expr.node();
        let scope = self.scope(id);
        let is_free = match (self.label(id), self.hints) {
            (None, true) => self.scope == scope,
            (Some(_), true) => false,
            (None, false) => self.scope <= scope,
            (Some(label), false) => label.is_hint && self.scope <= scope,
        };
        if !is_free || self.node(id).has_own_name() {
            return;
        }
        self.labels[id.index()] = Some(Label {
            text: text(),
            negative: expr.is_negative(),
            is_hint: self.hints,
        });
        self.scopes[id.index()] = self.scope;
        self.purposes[id.index()] = self.purpose;
    }

    /// A number; see [`Self::overflowed`] for one that is not finite.
    pub fn number(&mut self, value: f64) -> Expr {
        self.overflowed |= !value.is_finite();
        let magnitude = self.intern(Node::Number(value.abs().to_bits()));
        Expr::new(magnitude, value < 0.0)
    }

    /// True if some number was not finite: the description's are too large, or too small to divide by.
    pub fn overflowed(&self) -> bool {
        self.overflowed
    }

    /// A number that was computed from others.
    fn folded(&mut self, number: Rounded) -> Expr {
        let expr = self.number(number.value);
        let magnitude = number.value.abs();
        if number.error > Self::DIGITS_LOST * magnitude && magnitude > 0.0 {
            let lost = self.lost.entry(expr.node()).or_default();
            *lost = lost.max(number.error);
        }
        expr
    }

    /// The number of a node, and how far folding may have left it from the exact one.
    pub(super) fn rounded(&self, id: NodeId, value: f64) -> Rounded {
        let whole = Rounded::constant(value);
        match self.lost.get(&id) {
            Some(&error) => Rounded { error, ..whole },
            None => whole,
        }
    }

    /// Zero.
    pub fn zero(&mut self) -> Expr {
        self.number(0.0)
    }

    /// One.
    pub fn one(&mut self) -> Expr {
        self.number(1.0)
    }

    /// The value of a number; `None` for anything else.
    pub fn as_number(&self, expr: Expr) -> Option<f64> {
        match self.node(expr.node()) {
            Node::Number(bits) => {
                let magnitude = f64::from_bits(bits);
                Some(if expr.is_negative() {
                    -magnitude
                } else {
                    magnitude
                })
            }
            _ => None,
        }
    }

    /// True for the number zero.
    pub fn is_zero(&self, expr: Expr) -> bool {
        self.as_number(expr) == Some(0.0)
    }

    /// A value that the function is given.
    pub fn input(&mut self, input: Input) -> Expr {
        Expr::new(self.intern(Node::Input(input)), false)
    }

    /// `a + b`.
    pub fn add(&mut self, a: Expr, b: Expr) -> Expr {
        self.n_asked += 1;
        match (self.as_number(a), self.as_number(b)) {
            (Some(0.0), Some(0.0)) => return a.abs_sign(),
            (Some(0.0), _) => return b,
            (_, Some(0.0)) => return a,
            (Some(x), Some(y)) => {
                let sum = self.rounded(a.node(), x) + self.rounded(b.node(), y);
                return self.folded(sum);
            }
            _ => {}
        }
        if a.node() == b.node() {
            if a.is_negative() != b.is_negative() {
                return self.zero();
            }
            let two = self.number(2.0);
            return self.mul(two, a);
        }
        if let Some(merged) = self.merge_multiples(a, b) {
            return merged;
        }
        if let Some(rest) = self.cancelled(a, b).or_else(|| self.cancelled(b, a)) {
            return rest;
        }
        // Canonical: the older operand first, and without a sign.
        let (first, second) = if a.node() < b.node() { (a, b) } else { (b, a) };
        let negative = first.is_negative();
        let sum = Node::Add(first.signed(negative), second.signed(negative));
        self.written(sum, negative)
    }

    /// `a - b`.
    pub fn sub(&mut self, a: Expr, b: Expr) -> Expr {
        self.add(a, -b)
    }

    /// `a b`.
    pub fn mul(&mut self, a: Expr, b: Expr) -> Expr {
        self.n_asked += 1;
        let negative = a.is_negative() ^ b.is_negative();
        let (a, b) = (a.abs_sign(), b.abs_sign());
        match (self.as_number(a), self.as_number(b)) {
            (Some(0.0), y) if y.is_none_or(f64::is_finite) => return a,
            (x, Some(0.0)) if x.is_none_or(f64::is_finite) => return b,
            (Some(1.0), _) => return b.signed(negative),
            (_, Some(1.0)) => return a.signed(negative),
            (Some(x), Some(y)) => {
                let product = self.rounded(a.node(), x) * self.rounded(b.node(), y);
                return self.folded(product).signed(negative);
            }
            _ => {}
        }
        if let Some(merged) = self
            .merge_constants(a, b)
            .or_else(|| self.merge_constants(b, a))
        {
            return merged.signed(negative);
        }
        let key = |expr: Expr| (self.binding(expr.node()), expr.node());
        let (first, second) = if key(a) <= key(b) { (a, b) } else { (b, a) };
        self.written(Node::Mul(first.node(), second.node()), negative)
    }

    /// `a / b`. A value divided by the number zero is kept: it is what IEEE arithmetic makes of it.
    pub fn div(&mut self, a: Expr, b: Expr) -> Expr {
        let negative = a.is_negative() ^ b.is_negative();
        match (self.as_number(a), self.as_number(b)) {
            // A quotient of an overflow must not hide it.
            (Some(x), Some(y)) if y.is_finite() => {
                let quotient = self.rounded(a.node(), x) / self.rounded(b.node(), y);
                return self.folded(quotient);
            }
            (Some(_), Some(_)) => return self.number(f64::NAN),
            (None, Some(y)) if y.is_finite() && (1.0 / y).is_finite() => {
                let reciprocal = Rounded::exact(1.0) / self.rounded(b.node(), y);
                let reciprocal = self.folded(reciprocal);
                return self.mul(a, reciprocal);
            }
            _ => {}
        }
        if self.is_zero(a) {
            return a;
        }
        if a.node() == b.node() {
            return self.one().signed(negative);
        }
        self.written(Node::Div(a.node(), b.node()), negative)
    }

    /// `1 / a`.
    pub fn reciprocal(&mut self, a: Expr) -> Expr {
        let one = self.one();
        self.div(one, a)
    }

    /// `sin(a)`; the sign goes outside.
    pub fn sin(&mut self, a: Expr) -> Expr {
        match self.as_number(a) {
            Some(angle) => self.number(libm::sin(angle)),
            None => Expr::new(self.intern(Node::Sin(a.node())), a.is_negative()),
        }
    }

    /// `cos(a)`; the sign is dropped.
    pub fn cos(&mut self, a: Expr) -> Expr {
        match self.as_number(a) {
            Some(angle) => self.number(libm::cos(angle)),
            None => Expr::new(self.intern(Node::Cos(a.node())), false),
        }
    }

    /// `|a|`.
    pub fn abs(&mut self, a: Expr) -> Expr {
        match self.node(a.node()) {
            Node::Number(_) | Node::Abs(_) => a.abs_sign(),
            _ => Expr::new(self.intern(Node::Abs(a.node())), false),
        }
    }

    /// `c x + d x = (c + d) x` for numbers c, d; a missing factor is one.
    fn merge_multiples(&mut self, a: Expr, b: Expr) -> Option<Expr> {
        let x = self.without_factor(a);
        if x != self.without_factor(b) || self.as_number(Expr::new(x, false)).is_some() {
            return None;
        }
        let sum = self.folded(self.factor(a) + self.factor(b));
        Some(self.mul(sum, Expr::new(x, false)))
    }

    /// `(a + b) - b = a`.
    fn cancelled(&self, sum: Expr, other: Expr) -> Option<Expr> {
        let Node::Add(first, second) = self.node(sum.node()) else {
            return None;
        };
        let [first, second] = [first, second].map(|term| term.signed(sum.is_negative()));
        if first == -other {
            Some(second)
        } else if second == -other {
            Some(first)
        } else {
            None
        }
    }

    /// The expression's node without its numeric factor.
    fn without_factor(&self, expr: Expr) -> NodeId {
        match self.node(expr.node()) {
            Node::Mul(first, second) if matches!(self.node(first), Node::Number(_)) => second,
            _ => expr.node(),
        }
    }

    /// Its numeric factor, one where there is none.
    fn factor(&self, expr: Expr) -> Rounded {
        let factor = match self.node(expr.node()) {
            Node::Mul(first, _) => {
                let value = self.as_number(Expr::new(first, false));
                value.map(|value| self.rounded(first, value))
            }
            _ => None,
        };
        let factor = factor.unwrap_or(Rounded::exact(1.0));
        if expr.is_negative() { -factor } else { factor }
    }

    /// `c (d x) = (c d) x` where c and d are known before the loop: their product then costs nothing in it.
    fn merge_constants(&mut self, c: Expr, product: Expr) -> Option<Expr> {
        let Node::Mul(d, x) = self.node(product.node()) else {
            return None;
        };
        let latest = self.binding(c.node()).max(self.binding(d));
        if latest >= self.binding(x) || latest == Binding::State {
            return None;
        }
        let factor = self.mul(c, Expr::new(d, false));
        Some(self.mul(factor, Expr::new(x, false)))
    }

    /// A node or its negative, which a new node remembers.
    fn written(&mut self, node: Node, negative: bool) -> Expr {
        let n_nodes = self.len();
        let id = self.intern(node);
        if self.len() > n_nodes {
            self.written_negative[id.index()] = negative;
        }
        Expr::new(id, negative)
    }

    /// The current scope, or the body further inward that all operands belong to: what several bodies can share there
    /// must not be named after the first that asks. A number among the operands is the current body's.
    fn innermost_scope(&self, node: Node) -> Option<BodyId> {
        let scope = |operand| {
            if self.binding(operand) == Binding::Number {
                self.scope
            } else {
                self.scope(operand)
            }
        };
        node.operands()
            .map(scope)
            .max()
            .map_or(self.scope, |of_operands| of_operands.min(self.scope))
    }

    /// A product of two labelled values is known by both labels: it needs no number, which others could shift.
    fn product_label(&self, node: Node) -> Option<Label> {
        let Node::Mul(a, b) = node else { return None };
        let (a, b) = (self.label(a)?, self.label(b)?);
        Some(Label {
            text: format!("{}_{}", a.text, b.text),
            negative: a.negative ^ b.negative,
            is_hint: true,
        })
    }

    fn intern(&mut self, node: Node) -> NodeId {
        let vacant = match self.nodes.find(&node) {
            Ok(id) => return id,
            Err(vacant) => vacant,
        };
        let binding = match node {
            Node::Number(_) => Binding::Number,
            Node::Input(Input::Parameter(_) | Input::Prepared(_)) => Binding::Parameters,
            Node::Input(_) => Binding::State,
            _ => node
                .operands()
                .map(|operand| self.binding(operand))
                .max()
                .unwrap_or(Binding::Number),
        };
        self.bindings.push(binding);
        let scope = self.innermost_scope(node);
        self.labels.push(if scope == self.scope {
            None
        } else {
            self.product_label(node)
        });
        self.scopes.push(scope);
        self.purposes.push(self.purpose);
        self.written_negative.push(false);
        self.nodes.add(node, vacant)
    }
}
