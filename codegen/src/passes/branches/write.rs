//! The graph anew: for each call what it reads, then the call, and all else at the end in the order that it had.

use std::{
    collections::{BTreeMap, BTreeSet},
    sync::Arc,
};

use super::{
    calls::Calls,
    groups::{Group, Groups, Operand},
};
use crate::expr::{Call, CallId, Expr, ExprGraph, Helper, Input, Node, NodeId, Rebuilt, Shared};

/// The graph with its calls, and its roots.
pub(super) fn rewritten(
    old: &ExprGraph,
    roots: &[Expr],
    groups: &Groups,
    calls: &Calls,
) -> (ExprGraph, Vec<Expr>) {
    let mut writer = Writer {
        old,
        groups,
        calls,
        graph: ExprGraph::with_capacity(old.len()),
        rebuilt: Rebuilt::new(old),
        read: BTreeSet::new(),
    };
    for call in 0..calls.groups.len() {
        writer.call(call);
    }
    let needed = old.reachable(roots);
    for id in old.ids().filter(|id| needed[id.index()]) {
        writer.copy(id);
    }
    let roots = roots
        .iter()
        .map(|&root| writer.rebuilt.expr(root))
        .collect();
    (writer.graph, roots)
}

struct Writer<'a> {
    old: &'a ExprGraph,
    groups: &'a Groups,
    calls: &'a Calls,
    graph: ExprGraph,
    rebuilt: Rebuilt,
    /// Calls of the old graph all of whose operands are there.
    read: BTreeSet<CallId>,
}

/// A helper while it is written.
#[derive(Default)]
struct NewHelper {
    graph: ExprGraph,
    /// What each group of the call computes.
    groups: BTreeMap<usize, Expr>,
}

/// What a call is given.
#[derive(Default)]
struct Given {
    shared: Shared,
    /// Numbers of the model come last: one more moves no value.
    sides: Vec<Vec<Expr>>,
    /// Where each of these rows stands.
    places: BTreeMap<Vec<Expr>, usize>,
}

impl Writer<'_> {
    /// A node as it was, unless it is there already or a call's.
    fn copy(&mut self, id: NodeId) {
        if self.groups.group(id).is_none() && !self.rebuilt.has(id) {
            self.graph.enter_like(self.old, id);
            let expr = self.rebuilt.copy(&mut self.graph, self.old, id);
            self.graph.name_like(expr, self.old, id);
            self.rebuilt.set(id, expr);
        }
    }

    /// The group of a call that computes an operand, if one does.
    fn inside(&self, call: usize, operand: &Operand) -> Option<usize> {
        operand.group().filter(|&group| self.calls.has(call, group))
    }

    /// What a call reads, and the call.
    fn call(&mut self, call: usize) {
        self.copy_operands(call);
        let mut given = self.sides(call);
        let mut helper = NewHelper::default();
        let own = &self.calls.groups[call];
        for &number in own {
            let group = &self.groups.all[number];
            let operands: Vec<Expr> = group
                .operands
                .iter()
                .map(|operand| match self.inside(call, operand) {
                    Some(inside) => helper.groups[&inside],
                    None => self.given(&mut helper.graph, &mut given, operand),
                })
                .collect();
            let expr = self.operation(&mut helper.graph, group, &operands);
            helper.groups.insert(number, expr);
        }
        let found = own
            .iter()
            .copied()
            .filter(|&group| self.calls.is_found[group]);
        let found: Vec<usize> = found.collect();
        let NewHelper { graph, groups } = helper;
        let Given { shared, sides, .. } = given;
        let helper = Helper {
            lanes: self.groups.lanes(own[0]),
            roots: found.iter().map(|number| groups[number]).collect(),
            graph,
        };
        // Calls of the old graph keep their numbers.
        let number = self.old.next_lockstep().max(self.graph.next_lockstep());
        self.graph
            .add_lockstep(number, shared.numbers(), vec![Arc::new(helper)]);
        let call = self.graph.add_call(number, Call { helper: 0, sides });
        for (place, &group) in found.iter().enumerate() {
            for (lane, &member) in self.groups.all[group].members.iter().enumerate() {
                self.graph.enter_like(self.old, member);
                let result = self.graph.call_result(call, lane, place);
                let expr = result.signed(self.groups.is_negative(group, lane));
                self.graph.name_like(expr, self.old, member);
                self.rebuilt.set(member, expr);
            }
        }
    }

    /// All that a call needs and those before it have not computed.
    fn copy_operands(&mut self, call: usize) {
        let own = self.calls.groups[call].iter();
        let operands = own.flat_map(|&group| &self.groups.all[group].operands);
        let outside = operands.filter(|operand| self.inside(call, operand).is_none());
        let mut open: Vec<NodeId> = outside.flat_map(|operand| operand.nodes.clone()).collect();
        let mut wanted = BTreeSet::new();
        while let Some(id) = open.pop() {
            if self.groups.group(id).is_some() || self.rebuilt.has(id) || !wanted.insert(id) {
                continue;
            }
            match self.old.node(id) {
                Node::Input(Input::CallResult(result)) => {
                    if self.read.insert(result.call) {
                        open.extend(self.old.read_by(result.call).map(Expr::node));
                    }
                }
                node => open.extend(node.operands()),
            }
        }
        for id in wanted {
            self.copy(id);
        }
    }

    /// What a call is given that is of each lane.
    fn sides(&self, call: usize) -> Given {
        let mut given = Given::default();
        let mut numbers = Vec::new();
        let mut known = BTreeSet::new();
        let own = self.calls.groups[call].iter();
        let operands = own.flat_map(|&group| &self.groups.all[group].operands);
        for operand in operands.filter(|operand| self.inside(call, operand).is_none()) {
            let (row, _) = self.lanes(operand);
            if is_shared(&row) || !known.insert(row.clone()) {
                continue;
            }
            if row.iter().all(|&own| self.graph.as_number(own).is_some()) {
                numbers.push(row);
            } else {
                given.sides.push(row);
            }
        }
        given.sides.extend(numbers);
        let sides = given.sides.iter().cloned();
        given.places = sides.zip(0..).collect();
        given
    }

    /// An operand in each lane, and whether it is the negative of that: the first lane has no sign.
    fn lanes(&self, operand: &Operand) -> (Vec<Expr>, bool) {
        let row = self.groups.given(operand).into_iter();
        let row: Vec<Expr> = row.map(|own| self.rebuilt.expr(own)).collect();
        let is_negative = row[0].is_negative();
        let row = row.into_iter().map(|own| own.signed(is_negative));
        (row.collect(), is_negative)
    }

    /// An operand that a helper is given, at a place of its row or as what all lanes share.
    fn given(&self, helper: &mut ExprGraph, given: &mut Given, operand: &Operand) -> Expr {
        let (row, is_negative) = self.lanes(operand);
        helper.enter_like(self.old, operand.nodes[0]);
        let expr = if is_shared(&row) {
            given.shared.share(&self.graph, helper, row[0])
        } else {
            helper.input(Input::Side(given.places[&row]))
        };
        expr.signed(is_negative)
    }

    /// What the first of a group's members does, in a helper.
    fn operation(&self, helper: &mut ExprGraph, group: &Group, operands: &[Expr]) -> Expr {
        let member = group.members[0];
        helper.enter_like(self.old, member);
        let expr = match (self.old.node(member), operands) {
            (Node::Add(one, other), &[a, b]) => {
                let [a, b] =
                    [(a, one), (b, other)].map(|(own, as_is)| own.signed(as_is.is_negative()));
                helper.add(a, b)
            }
            (Node::Mul(..), &[a, b]) => helper.mul(a, b),
            (Node::Div(..), &[a, b]) => helper.div(a, b),
            (Node::Abs(_), &[a]) => helper.abs(a),
            (other, _) => unreachable!("passes: {other:?} is in no group"),
        };
        helper.name_like(expr, self.old, member);
        expr
    }
}

fn is_shared(row: &[Expr]) -> bool {
    row.iter().all(|own| *own == row[0])
}
