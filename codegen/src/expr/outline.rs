//! Calls made of what was derived on sides: all that depends on them becomes a helper.

use std::{collections::BTreeMap, sync::Arc};

use super::{
    graph::ExprGraph,
    lockstep::{Call, Helper},
    node::{Expr, Input, Node, NodeId},
};

impl ExprGraph {
    /// What `roots` are for each column of `sides`: they were derived on [`Input::Side`]s in the place of these.
    pub fn call_outlined(&mut self, roots: &[Expr], sides: Vec<Vec<Expr>>) -> Vec<Vec<Expr>> {
        let outline = Outline::of(self, roots);
        let varying: Vec<Option<Expr>> = roots.iter().map(|root| outline.varying(*root)).collect();
        let helper = Helper {
            lanes: sides[0].len(),
            graph: outline.helper,
            roots: varying.iter().flatten().copied().collect(),
        };
        let sides = outline.sides.iter().map(|own| sides[*own].clone());
        let sides = sides.collect();
        let lockstep = self.next_lockstep();
        self.add_lockstep(lockstep, outline.shared, vec![Arc::new(helper)]);
        let lanes = self.call(lockstep, Call { helper: 0, sides }).into_iter();
        let lanes = lanes.map(|lane| {
            let mut lane = lane.into_iter();
            let all = roots.iter().zip(&varying);
            // What does not depend on sides is the same for all.
            let own = all.map(|(root, varies)| varies.and_then(|_| lane.next()).unwrap_or(*root));
            own.collect()
        });
        lanes.collect()
    }
}

/// A helper while it is taken out of a graph.
struct Outline<'a> {
    graph: &'a ExprGraph,
    helper: ExprGraph,
    /// What nodes that depend on sides are in the helper.
    varying: Vec<Option<Expr>>,
    shared: Vec<Expr>,
    places: BTreeMap<NodeId, usize>,
    /// The sides that are needed.
    sides: Vec<usize>,
}

impl<'a> Outline<'a> {
    fn of(graph: &'a ExprGraph, roots: &[Expr]) -> Self {
        let mut outline = Self {
            graph,
            helper: ExprGraph::default(),
            varying: vec![None; graph.len()],
            shared: Vec::new(),
            places: BTreeMap::new(),
            sides: Vec::new(),
        };
        let needed = graph.reachable(roots);
        for id in graph.ids().filter(|id| needed[id.index()]) {
            let node = graph.node(id);
            let is_varying = |operand: NodeId| outline.varying[operand.index()].is_some();
            if matches!(node, Node::Input(Input::Side(_))) || node.operands().any(is_varying) {
                outline.take(id, node);
            }
        }
        outline
    }

    /// Takes a node that depends on sides.
    fn take(&mut self, id: NodeId, mut node: Node) {
        self.helper.enter_like(self.graph, id);
        if let Node::Input(Input::Side(place)) = &mut node {
            self.sides.push(*place);
            *place = self.sides.len() - 1;
        }
        let operands: BTreeMap<NodeId, Expr> = node
            .operands()
            .map(|operand| (operand, self.operand(operand)))
            .collect();
        let expr = self.helper.copied(node, |operand| operands[&operand]);
        self.helper.name_like(expr, self.graph, Expr::of(id));
        self.varying[id.index()] = Some(expr);
    }

    fn operand(&mut self, id: NodeId) -> Expr {
        if let Some(varying) = self.varying[id.index()] {
            return varying;
        }
        if let Node::Number(bits) = self.graph.node(id) {
            return self.helper.number(f64::from_bits(bits));
        }
        let place = *self.places.entry(id).or_insert_with(|| {
            self.shared.push(Expr::of(id));
            self.shared.len() - 1
        });
        self.helper.input(Input::Shared(place))
    }

    /// What an expression is in the helper, if it depends on sides.
    fn varying(&self, expr: Expr) -> Option<Expr> {
        let varying = self.varying[expr.node().index()]?;
        Some(varying.signed(expr.is_negative()))
    }
}
