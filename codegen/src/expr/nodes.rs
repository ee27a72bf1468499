//! The nodes of a graph, each of them once.

use std::hash::BuildHasher as _;

use rustc_hash::FxBuildHasher;

use super::node::{Node, NodeId};

/// Nodes in order of creation.
///
/// They are looked up in a table of hashes and ids with open addressing, a third of what it would be with nodes: long
/// derivations wait most for memory. Nothing depends on the order of hashes.
#[derive(Clone, Debug, Default)]
pub(super) struct Nodes {
    nodes: Vec<Node>,
    /// None, or a power of two of which a quarter is free at least: a node stands at the first free place from its hash on.
    places: Vec<(u32, NodeId)>,
}

/// A place without a node.
const FREE: (u32, NodeId) = (0, NodeId(u32::MAX));

/// The place of a node that is none of these, until another is added.
#[derive(Clone, Copy, Debug)]
pub(super) struct Vacant {
    hash: u32,
    place: usize,
}

impl Nodes {
    pub(super) fn with_capacity(n_nodes: usize) -> Self {
        Self {
            nodes: Vec::with_capacity(n_nodes),
            places: vec![FREE; n_places(n_nodes)],
        }
    }

    pub(super) fn len(&self) -> usize {
        self.nodes.len()
    }

    pub(super) fn get(&self, id: NodeId) -> Node {
        self.nodes[id.index()]
    }

    /// The id of a node, or its place where it is none of these.
    pub(super) fn find(&self, node: &Node) -> Result<NodeId, Vacant> {
        let hash = hash(node);
        let mut place = self.first(hash);
        while let Some(&(own, id)) = self.places.get(place).filter(|own| **own != FREE) {
            if own == hash && self.nodes[id.index()] == *node {
                return Ok(id);
            }
            place = self.next(place);
        }
        Err(Vacant { hash, place })
    }

    /// Adds a node that is none of these, in the place that was found for it.
    pub(super) fn add(&mut self, node: Node, vacant: Vacant) -> NodeId {
        let id = u32::try_from(self.nodes.len()).expect("expr: fewer than 2^32 nodes");
        let id = NodeId(id);
        self.nodes.push(node);
        let Vacant { hash, place } = vacant;
        if n_places(self.len()) <= self.places.len() {
            self.places[place] = (hash, id);
        } else {
            self.grow();
            self.insert(hash, id);
        }
        id
    }

    fn grow(&mut self) {
        let places = vec![FREE; n_places(self.len())];
        let before = std::mem::replace(&mut self.places, places);
        for (hash, id) in before.into_iter().filter(|place| *place != FREE) {
            self.insert(hash, id);
        }
    }

    fn insert(&mut self, hash: u32, id: NodeId) {
        let mut place = self.first(hash);
        while self.places[place] != FREE {
            place = self.next(place);
        }
        self.places[place] = (hash, id);
    }

    /// Where the search for a hash begins; of no account in a table without places.
    fn first(&self, hash: u32) -> usize {
        hash as usize & self.places.len().wrapping_sub(1)
    }

    fn next(&self, place: usize) -> usize {
        (place + 1) & (self.places.len() - 1)
    }
}

/// How many places a table for so many nodes has.
fn n_places(n_nodes: usize) -> usize {
    (n_nodes + n_nodes / 3 + 1).next_power_of_two()
}

/// Sums, products and quotients are nearly all that is looked up.
fn hash(node: &Node) -> u32 {
    let (kind, first, second) = match *node {
        Node::Add(a, b) => (u64::from(b.is_negative()), a.node(), b.node()),
        Node::Mul(a, b) => (2, a, b),
        Node::Div(a, b) => (3, a, b),
        other => return folded(FxBuildHasher.hash_one(other)),
    };
    let operands = (u64::from(first.0) << 32) | u64::from(second.0);
    // Odd numbers without a pattern, as hashes by multiplication want them.
    let mixed = (operands ^ (kind << 62)).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    folded((mixed ^ (mixed >> 32)).wrapping_mul(0xD6E8_FEB8_6659_FD93))
}

fn folded(hash: u64) -> u32 {
    let folded = (hash ^ (hash >> 32)) & u64::from(u32::MAX);
    u32::try_from(folded).expect("expr: half of its bits are left")
}
