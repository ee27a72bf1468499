//! What the values of a body may be made of: one another, what they are computed from, what the bodies on the path to it compute of
//! nothing that comes from farther out, and what bodies farther out compute.

use std::collections::{BTreeMap, BTreeSet};

use super::work::Work;
use crate::{
    expr::{Binding, Input, Node, NodeId},
    id::BodyId,
    tree::Tree,
};

/// How many operations of bodies farther out are among the known ones, at most.
const MOST_BEYOND: usize = 4_000;

/// Of which bodies' values a body's values may be made, beside its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Reach {
    /// Those on the path to it.
    Path,
    /// Those farther out too.
    Beyond,
}

/// The operations of the loop, by bodies.
pub(super) struct Bodies<'a> {
    tree: &'a Tree,
    work: &'a Work<'a>,
    operations: BTreeMap<Option<BodyId>, Vec<NodeId>>,
}

impl<'a> Bodies<'a> {
    pub(super) fn new(tree: &'a Tree, work: &'a Work<'a>) -> Self {
        let graph = work.graph;
        let mut operations: BTreeMap<Option<BodyId>, Vec<NodeId>> = BTreeMap::new();
        for &id in &work.order {
            let is_operation = graph.node(id).operands().next().is_some();
            if is_operation && graph.binding(id) == Binding::State {
                operations.entry(graph.scope(id)).or_default().push(id);
            }
        }
        Self {
            tree,
            work,
            operations,
        }
    }

    /// The bodies, and the operations of each.
    pub(super) fn all(&self) -> impl Iterator<Item = (Option<BodyId>, &[NodeId])> {
        let all = self.operations.iter();
        all.map(|(body, operations)| (*body, operations.as_slice()))
    }

    /// The operations that are evaluated for a body: its own, and those on the path to it that need nothing from farther out; with all
    /// of bodies farther out if they are to be among them. `None` where there are none of these, or too many.
    pub(super) fn known(&self, body: Option<BodyId>, reach: Reach) -> Option<BTreeSet<NodeId>> {
        let beyond = match reach {
            Reach::Path => Vec::new(),
            Reach::Beyond => self.beyond(body)?,
        };
        let mut known = self.of_path(body);
        known.extend(self.operations.get(&body).into_iter().flatten());
        known.extend(beyond);
        Some(known)
    }

    /// What the bodies on the path to a body compute of nothing from farther out.
    fn of_path(&self, body: Option<BodyId>) -> BTreeSet<NodeId> {
        let mut known = BTreeSet::new();
        let path = body
            .into_iter()
            .flat_map(|body| self.tree.path(body).skip(1));
        let mut path: Vec<_> = path.map(Some).chain([None]).collect();
        path.reverse();
        for lower in path {
            let operations = self.operations.get(&lower).into_iter().flatten();
            for &id in operations {
                let mut operands = self.work.operands(id);
                if operands.all(|id| self.is_from_below(id, &known)) {
                    known.insert(id);
                }
            }
        }
        known
    }

    /// The operations of all bodies farther out than this one; `None` where there are none, or too many.
    fn beyond(&self, body: Option<BodyId>) -> Option<Vec<NodeId>> {
        let mut all = Vec::new();
        let mut next = match body {
            Some(body) => self.tree.uppers(body).to_vec(),
            None => self.roots(),
        };
        while let Some(body) = next.pop() {
            all.extend(self.operations.get(&Some(body)).into_iter().flatten());
            if all.len() > MOST_BEYOND {
                return None;
            }
            next.extend(self.tree.uppers(body));
        }
        (!all.is_empty()).then_some(all)
    }

    fn roots(&self) -> Vec<BodyId> {
        let bodies = self.tree.body_ids();
        bodies
            .filter(|body| self.tree.lower(*body).is_none())
            .collect()
    }

    fn is_from_below(&self, id: NodeId, known: &BTreeSet<NodeId>) -> bool {
        let graph = self.work.graph;
        match graph.node(id) {
            Node::Input(input) => !matches!(input, Input::CallResult(_)),
            Node::Number(_) | Node::Sin(_) | Node::Cos(_) => true,
            _ => graph.binding(id) != Binding::State || known.contains(&id),
        }
    }

    /// These operations, each after what it is computed from where that is first needed.
    pub(super) fn given(&self, known: &BTreeSet<NodeId>) -> Vec<NodeId> {
        let mut in_order: Vec<NodeId> = known.iter().copied().collect();
        in_order.sort_by_key(|id| self.work.place(*id));
        let mut is_given = BTreeSet::new();
        let all = in_order.into_iter();
        all.flat_map(|id| self.work.operands(id).chain([id]))
            .filter(|id| is_given.insert(*id))
            .collect()
    }
}
