//! When groups are computed: those of a layer after the numbers that they are given.

use std::collections::BTreeMap;

use super::groups::{Group, Groups};
use crate::expr::{CallId, Expr, ExprGraph, Input, Node, NodeId};

/// For each node, how many layers of groups come before it.
pub(super) struct Layers<'a> {
    groups: &'a Groups,
    of: Vec<usize>,
}

impl<'a> Layers<'a> {
    pub(super) fn of(graph: &ExprGraph, roots: &[Expr], groups: &'a Groups) -> Self {
        let mut layers = Self {
            groups,
            of: vec![0; graph.len()],
        };
        let needed = graph.reachable(roots);
        let needed: Vec<NodeId> = graph.ids().filter(|id| needed[id.index()]).collect();
        // What a branch needs may come after what the first one does: until nothing moves. This ends: a group's members have one
        // colour, and the colour of an operand is part of it.
        while layers.move_all(graph, &needed) {}
        layers
    }

    /// Puts each node after what it needs; false if all were there.
    fn move_all(&mut self, graph: &ExprGraph, needed: &[NodeId]) -> bool {
        let mut has_moved = false;
        let mut of_calls: BTreeMap<CallId, usize> = BTreeMap::new();
        for &id in needed {
            let alone = [id];
            let group = self.groups.group(id).map(|group| &self.groups.all[group]);
            let (members, layer) = match (group, graph.node(id)) {
                (Some(group), _) => (&group.members[..], self.after_operands(group)),
                (None, Node::Input(Input::CallResult(result))) => {
                    let read = || self.after(graph.read_by(result.call).map(Expr::node), false);
                    (
                        &alone[..],
                        *of_calls.entry(result.call).or_insert_with(read),
                    )
                }
                (None, node) => (&alone[..], self.after(node.operands(), false)),
            };
            for member in members {
                let own = &mut self.of[member.index()];
                has_moved |= *own != layer;
                *own = layer;
            }
        }
        has_moved
    }

    fn after_operands(&self, group: &Group) -> usize {
        let of_operands = group.operands.iter().map(|operand| {
            let of = operand.group();
            let is_inside = of.is_some_and(|own| self.groups.is_whole(own));
            self.after(operand.nodes.iter().copied(), is_inside)
        });
        of_operands.max().unwrap_or(0)
    }

    /// The layer after nodes. An operand that one group computes for all branches may be of the same layer.
    fn after(&self, nodes: impl Iterator<Item = NodeId>, is_inside: bool) -> usize {
        let before = nodes.map(|own| {
            let is_called = !is_inside && self.groups.group(own).is_some();
            self.of[own.index()] + usize::from(is_called)
        });
        before.max().unwrap_or(0)
    }

    /// For each layer and team the groups, operands first.
    pub(super) fn groups(&self) -> Vec<Vec<usize>> {
        let mut found: BTreeMap<(usize, usize), Vec<usize>> = BTreeMap::new();
        for (number, group) in self.groups.all.iter().enumerate() {
            if self.groups.is_whole(number) {
                let layer = self.of[group.members[0].index()];
                found.entry((layer, group.team)).or_default().push(number);
            }
        }
        found.into_values().collect()
    }
}
