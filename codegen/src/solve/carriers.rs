//! Bodies through which branches feel the rest of a floating tree.
//!
//! Where a root moves freely, the row of a speed farther out needs of all speeds up to a carrier no more than six numbers: what
//! the carrier's acceleration does, along the root's motions. The entry of a speed on the way there is that row times the
//! speed's own motion, also along the root's.

use std::collections::BTreeMap;

use crate::{
    expr::{Expr, ExprGraph},
    id::{BodyId, SpeedId},
    tree::Tree,
};

/// A motion along the six of a root.
pub type RootMotion = [Expr; 6];

/// The carriers of a system; of one without floating trees there are none.
#[derive(Debug, Default)]
pub struct Carriers {
    carriers: BTreeMap<BodyId, Carrier>,
    released: BTreeMap<BodyId, Released>,
}

/// A body that branches are on.
#[derive(Clone, Debug)]
struct Carrier {
    root: [SpeedId; 6],
    /// The speed of its joint and the motion that it is; none of the root's own.
    own: Option<(SpeedId, RootMotion)>,
}

/// A joint on a root without a rotor: where the root moves along it alone, the joint gives way, and nothing on it moves.
#[derive(Clone, Debug)]
pub(super) struct Released {
    pub(super) motion: RootMotion,
    /// A part of the motion that is a number, which is not zero.
    pub(super) pivot: usize,
}

/// An entry of a row at a speed on the way to a carrier, of those of the root.
pub(super) struct Derived {
    pub(super) speed: SpeedId,
    pub(super) entry: Expr,
    /// How many parts the speed's motion has along the root's.
    pub(super) n_parts: usize,
}

impl Carriers {
    /// Adds a root that moves freely, by these speeds.
    pub fn add_root(&mut self, body: BodyId, root: [SpeedId; 6]) {
        self.carriers.insert(body, Carrier { root, own: None });
    }

    /// Adds a carrier that one speed moves on another carrier.
    pub fn add(&mut self, tree: &Tree, body: BodyId, speed: SpeedId, motion: RootMotion) {
        let lower = tree.lower(body).and_then(|lower| self.carriers.get(&lower));
        if let Some(lower) = lower {
            let root = lower.root;
            let own = Some((speed, motion));
            self.carriers.insert(body, Carrier { root, own });
        }
    }

    /// Adds a body on a root whose joint, without a rotor, is this motion; `pivot` is a part of it that is a number.
    pub fn release(&mut self, body: BodyId, motion: RootMotion, pivot: usize) {
        self.released.insert(body, Released { motion, pivot });
    }

    /// True for a carrier.
    pub(super) fn contains(&self, body: BodyId) -> bool {
        self.carriers.contains_key(&body)
    }

    /// The farthest carrier on the way to a body.
    pub(super) fn toward(&self, tree: &Tree, body: Option<BodyId>) -> Option<BodyId> {
        let mut body = body;
        while let Some(own) = body.filter(|own| !self.contains(*own)) {
            body = tree.lower(own);
        }
        body
    }

    /// The speeds of the root that a carrier is on.
    pub(super) fn root(&self, carrier: BodyId) -> [SpeedId; 6] {
        self.carriers[&carrier].root
    }

    /// The speed that moves a carrier on its lower one, and how.
    pub(super) fn own(&self, carrier: BodyId) -> Option<(SpeedId, RootMotion)> {
        self.carriers[&carrier].own
    }

    /// The speeds from a carrier to its root, with what a row makes of the motion of each: their entries.
    pub(super) fn entries(
        &self,
        graph: &mut ExprGraph,
        tree: &Tree,
        carrier: BodyId,
        row: &RootMotion,
    ) -> Vec<Derived> {
        let mut entries = Vec::new();
        let mut body = Some(carrier);
        while let Some(own) = body {
            if let Some((speed, motion)) = self.own(own) {
                graph.enter(own);
                entries.push(Derived {
                    speed,
                    entry: dot(graph, row, &motion),
                    n_parts: motion.iter().filter(|part| !graph.is_zero(**part)).count(),
                });
            }
            body = tree.lower(own);
        }
        entries
    }

    /// The joint on the root by which a body is carried, where it gives way, and whether it is the body's own.
    pub(super) fn released(&self, tree: &Tree, body: BodyId) -> Option<(&Released, bool)> {
        let mut on_root = body;
        while let Some(lower) = tree.lower(on_root).filter(|own| tree.lower(*own).is_some()) {
            on_root = lower;
        }
        let released = self.released.get(&on_root)?;
        Some((released, on_root == body))
    }
}

/// `a^T b`.
pub(super) fn dot(graph: &mut ExprGraph, a: &RootMotion, b: &RootMotion) -> Expr {
    let mut sum = graph.zero();
    for (&a, &b) in a.iter().zip(b) {
        let term = graph.mul(a, b);
        sum = graph.add(sum, term);
    }
    sum
}
