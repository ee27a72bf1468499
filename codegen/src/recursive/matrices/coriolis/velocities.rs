//! How fast links turn and move, wherever motions enter on the way outward.

use crate::{
    expr::{ExprGraph, Purpose, Vector},
    id::{BodyId, BodyMap},
    recursive::links::{
        linkage::Linkage,
        passage::{Drive, Passenger, speeds},
        rotation::Turn,
    },
    tree::Motion,
};

/// Angular velocity, and velocity of the origin.
pub(in crate::recursive) type Velocity = [Vector; 2];

/// The velocity where motions enter: on both sides of a rotation, which adds what drives it.
#[derive(Clone, Copy, Debug)]
pub(super) struct AtMotions {
    pub(super) before: Velocity,
    pub(super) after: Velocity,
}

/// A link's velocity on its way outward through a joint.
#[derive(Clone, Debug)]
pub(super) struct VelocityOutward {
    pub(super) velocity: Velocity,
    is_root: bool,
    /// The same wherever motions enter, in the order of the way.
    pub(super) at_motions: Vec<AtMotions>,
}

/// Of each link, in its own axes.
pub(super) fn velocities(graph: &mut ExprGraph, linkage: &Linkage<'_>) -> BodyMap<VelocityOutward> {
    graph.begin(Purpose::Outward);
    let tree = linkage.tree;
    BodyMap::outward(
        tree.bodies.len(),
        |body, moving: &BodyMap<VelocityOutward>| {
            graph.enter(body);
            let lower = tree.lower(body);
            let below = lower.map(|lower| moving[lower].velocity);
            let mut passing = VelocityOutward {
                velocity: below.unwrap_or([graph.zero_vector(); 2]),
                is_root: lower.is_none(),
                at_motions: Vec::new(),
            };
            linkage.passages[body].outward(graph, &mut passing);
            graph.name_vector(passing.velocity[0], "w");
            graph.name_vector(passing.velocity[1], "v_o");
            passing
        },
    )
}

impl Passenger for VelocityOutward {
    fn shift(&mut self, graph: &mut ExprGraph, _: BodyId, offset: Vector) {
        let [w, v] = self.velocity;
        let swept = graph.cross(w, offset);
        self.velocity = [w, graph.add_vectors(v, swept)];
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive) {
        let before = self.velocity;
        let [w, v] = before.map(|v| rotation.forward(graph, v));
        let own = drive.speeds(graph);
        self.velocity = [graph.add_vectors(w, own), v];
        let after = self.velocity;
        self.at_motions.push(AtMotions { before, after });
    }

    fn along(&mut self, graph: &mut ExprGraph, motions: [Option<Motion>; 3]) {
        if !self.is_root {
            let own = speeds(graph, motions);
            self.velocity[1] = graph.add_vectors(self.velocity[1], own);
        }
        // Translations turn nothing: there is one side.
        let after = self.velocity;
        let before = after;
        self.at_motions.push(AtMotions { before, after });
    }
}
