//! Calls made of what was derived on sides: all that depends on them becomes a helper.

use std::{collections::BTreeMap, sync::Arc};

use super::{
    graph::ExprGraph,
    lockstep::{Call, Helper},
    node::{CallId, Expr, Input, Node, NodeId},
    shared::Shared,
};

impl ExprGraph {
    /// What `roots` are for each column of `sides`: they were derived on [`Input::Side`]s in the place of these. What is alike has one
    /// helper, and what is the same one call.
    pub fn call_outlined(&mut self, roots: &[Expr], sides: &[Vec<Expr>]) -> Vec<Vec<Expr>> {
        let lanes = sides[0].len();
        let is_computed = |own: &Expr| self.side(*own).is_none();
        let computed: Vec<Expr> = roots.iter().copied().filter(is_computed).collect();
        let outline = Outline::of(self, &computed);
        let varying = |own: &Expr| outline.varying(*own).filter(|_| is_computed(own));
        let varying: Vec<Option<Expr>> = roots.iter().map(varying).collect();
        let own_sides = outline.sides.iter().map(|own| sides[*own].clone());
        let own_sides: Vec<Vec<Expr>> = own_sides.collect();
        let helper = Helper {
            lanes,
            graph: outline.helper,
            roots: varying.iter().flatten().copied().collect(),
        };
        let is_call = !helper.roots.is_empty();
        let shared = outline.shared.numbers();
        let call = is_call.then(|| self.once(helper, shared, own_sides));
        let column = |graph: &mut Self, lane: usize| {
            let mut place = 0;
            let all = roots.iter().zip(&varying);
            let own = all.map(|(root, varies)| {
                if let Some(side) = graph.side(*root) {
                    return sides[side][lane].signed(root.is_negative());
                }
                // What does not depend on sides is the same for all.
                let (Some(call), Some(_)) = (call, varies) else {
                    return *root;
                };
                place += 1;
                graph.call_result(call, lane, place - 1)
            });
            own.collect()
        };
        (0..lanes).map(|lane| column(self, lane)).collect()
    }

    /// The side that an expression is, or the negative of.
    fn side(&self, expr: Expr) -> Option<usize> {
        match self.node(expr.node()) {
            Node::Input(Input::Side(place)) => Some(place),
            _ => None,
        }
    }

    /// The call of a helper on columns, which may be there already.
    fn once(&mut self, helper: Helper<Self>, shared: Vec<Expr>, sides: Vec<Vec<Expr>>) -> CallId {
        let all = self.locksteps.iter();
        let alike =
            all.filter(|(_, own)| own.helpers.len() == 1 && is_same(&own.helpers[0], &helper));
        let alike: Vec<_> = alike.collect();
        if let Some(&(&lockstep, own)) = alike.iter().find(|(_, own)| own.shared == shared) {
            let mut calls = own.calls.iter();
            let known = calls.find(|(_, call)| call.sides == sides);
            let known = known.map(|(&call, _)| CallId { lockstep, call });
            return known.unwrap_or_else(|| self.add_call(lockstep, Call { helper: 0, sides }));
        }
        let known = alike.first().map(|(_, own)| own.helpers[0].clone());
        let lockstep = self.next_lockstep();
        self.add_lockstep(
            lockstep,
            shared,
            vec![known.unwrap_or_else(|| Arc::new(helper))],
        );
        self.add_call(lockstep, Call { helper: 0, sides })
    }
}

/// True for helpers that do the same.
fn is_same(one: &Helper<ExprGraph>, other: &Helper<ExprGraph>) -> bool {
    let (a, b) = (&one.graph, &other.graph);
    let are_same = |id: NodeId| a.node(id) == b.node(id);
    one.lanes == other.lanes
        && one.roots == other.roots
        && a.len() == b.len()
        && a.ids().all(are_same)
}

/// A helper while it is taken out of a graph.
struct Outline<'a> {
    graph: &'a ExprGraph,
    helper: ExprGraph,
    /// What nodes that depend on sides are in the helper.
    varying: Vec<Option<Expr>>,
    shared: Shared,
    /// The sides that are needed.
    sides: Vec<usize>,
}

impl<'a> Outline<'a> {
    fn of(graph: &'a ExprGraph, roots: &[Expr]) -> Self {
        let mut outline = Self {
            graph,
            helper: ExprGraph::default(),
            varying: vec![None; graph.len()],
            shared: Shared::default(),
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
        self.helper.name_like(expr, self.graph, id);
        self.varying[id.index()] = Some(expr);
    }

    fn operand(&mut self, id: NodeId) -> Expr {
        if let Some(varying) = self.varying[id.index()] {
            return varying;
        }
        self.shared
            .share(self.graph, &mut self.helper, Expr::of(id))
    }

    /// What an expression is in the helper, if it depends on sides.
    fn varying(&self, expr: Expr) -> Option<Expr> {
        let varying = self.varying[expr.node().index()]?;
        Some(varying.signed(expr.is_negative()))
    }
}
