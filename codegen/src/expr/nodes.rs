//! The nodes of a graph, each of them once.

use std::hash::BuildHasher as _;

use hashbrown::HashTable;
use rustc_hash::FxBuildHasher;

use super::node::{Node, NodeId};

/// Nodes in order of creation.
///
/// The table holds hashes and ids, a third of what it would be with nodes: long derivations wait most for memory. It is only
/// ever looked up, so that nothing depends on the order of hashes.
#[derive(Clone, Debug, Default)]
pub(super) struct Nodes {
    nodes: Vec<Node>,
    ids: HashTable<(Hash, NodeId)>,
}

/// What is kept of a node's hash.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Hash(u32);

impl Hash {
    fn of(node: &Node) -> Self {
        let whole = FxBuildHasher.hash_one(node);
        let folded = (whole ^ (whole >> 32)) & u64::from(u32::MAX);
        Self(u32::try_from(folded).expect("expr: half of its bits are left"))
    }

    /// A table looks at the first bits and at the last.
    fn whole(self) -> u64 {
        (u64::from(self.0) << 32) | u64::from(self.0)
    }
}

impl Nodes {
    pub(super) fn with_capacity(n_nodes: usize) -> Self {
        Self {
            nodes: Vec::with_capacity(n_nodes),
            ids: HashTable::with_capacity(n_nodes),
        }
    }

    pub(super) fn len(&self) -> usize {
        self.nodes.len()
    }

    pub(super) fn get(&self, id: NodeId) -> Node {
        self.nodes[id.index()]
    }

    /// The id of a node, or its hash where it is none of these.
    pub(super) fn find(&self, node: &Node) -> Result<NodeId, Hash> {
        let hash = Hash::of(node);
        let is_it = |&(own, id): &(Hash, NodeId)| own == hash && self.nodes[id.index()] == *node;
        let found = self.ids.find(hash.whole(), is_it);
        found.map(|&(_, id)| id).ok_or(hash)
    }

    /// Adds a node that is none of these, with its hash.
    pub(super) fn add(&mut self, node: Node, hash: Hash) -> NodeId {
        let id = u32::try_from(self.nodes.len()).expect("expr: fewer than 2^32 nodes");
        self.nodes.push(node);
        let again = |&(own, _): &(Hash, NodeId)| own.whole();
        self.ids
            .insert_unique(hash.whole(), (hash, NodeId(id)), again);
        NodeId(id)
    }
}
