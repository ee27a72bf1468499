//! When groups are computed: those of a layer after the numbers that they are given.

use super::groups::Groups;
use crate::expr::{Expr, ExprGraph, Input, Node, NodeId};

/// For each node, how many layers of groups come before it.
pub(super) struct Layers(Vec<usize>);

impl Layers {
    pub(super) fn of(graph: &ExprGraph, roots: &[Expr], groups: &Groups) -> Self {
        let needed = graph.reachable(roots);
        let reads: Vec<Vec<NodeId>> = graph.ids().map(|id| reads(graph, id)).collect();
        let mut layers = vec![0; graph.len()];
        // An operand that one group computes for all branches may be of the same layer.
        let after = |layers: &[usize], nodes: &[NodeId], is_inside: bool| {
            let before = nodes.iter().map(|own| {
                let is_called = !is_inside && groups.group(*own).is_some();
                layers[own.index()] + usize::from(is_called)
            });
            before.max().unwrap_or(0)
        };
        // What a branch needs may come after what the first one does: until nothing moves. This ends: a group's members have one
        // colour, and the colour of an operand is part of it.
        let mut has_moved = true;
        while has_moved {
            has_moved = false;
            for id in graph.ids().filter(|id| needed[id.index()]) {
                let alone = [id];
                let group = groups.group(id).map(|group| &groups.all[group]);
                let (members, layer) = match group {
                    None => (&alone[..], after(&layers, &reads[id.index()], false)),
                    Some(group) => {
                        let of_operands = group.operands.iter().map(|operand| {
                            let is_inside = operand.group().is_some_and(|own| groups.is_whole(own));
                            after(&layers, &operand.nodes, is_inside)
                        });
                        (&group.members[..], of_operands.max().unwrap_or(0))
                    }
                };
                for member in members {
                    has_moved |= layers[member.index()] != layer;
                    layers[member.index()] = layer;
                }
            }
        }
        Self(layers)
    }

    /// The groups of each layer, operands first.
    pub(super) fn groups(&self, groups: &Groups) -> Vec<Vec<usize>> {
        let mut found = Vec::new();
        for (group, own) in groups.all.iter().enumerate() {
            if groups.is_whole(group) {
                let layer = self.0[own.members[0].index()];
                found.resize_with(found.len().max(layer + 1), Vec::new);
                found[layer].push(group);
            }
        }
        found.retain(|own| !own.is_empty());
        found
    }
}

/// What a node needs: its operands, or what the call reads that computes it.
pub(super) fn reads(graph: &ExprGraph, id: NodeId) -> Vec<NodeId> {
    if let Node::Input(Input::Solved(solved)) = graph.node(id) {
        let of = graph.lockstep(solved.lockstep);
        let own = of.calls[&solved.call].operands();
        return of
            .shared
            .iter()
            .copied()
            .chain(own)
            .map(Expr::node)
            .collect();
    }
    graph.node(id).operands().collect()
}
