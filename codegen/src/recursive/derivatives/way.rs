//! How links move wherever motions enter, on the way outward.

use crate::{
    expr::{ExprGraph, Vector},
    given::{self, Accelerations},
    id::{BodyId, BodyMap},
    recursive::links::{
        link_motion::{LinkMotion, Moving},
        linkage::Linkage,
        passage::{Drive, Passenger, speeds},
        rotation::Turn,
    },
    tree::Motion,
};

/// How a link moves where motions enter.
#[derive(Clone, Copy, Debug)]
pub(super) struct At {
    /// As it arrives there.
    pub(super) lower: LinkMotion,
    /// With these motions.
    pub(super) after: LinkMotion,
    /// Twice the velocity of the origin, of which only what joints beyond the root add is there.
    pub(super) v: Vector,
    /// What is there before the rotation of an angle, if the column begins there: if what is below turns, and the link carries others.
    /// One that carries none has fewer numbers along its own axes.
    pub(super) before: Option<Before>,
}

/// How a lower link moves, along the axes before a rotation.
#[derive(Clone, Copy, Debug)]
pub(super) struct Before {
    motion: LinkMotion,
    v: Vector,
}

impl Before {
    /// In the place of both motions: what is asked about the axis of an angle does not depend on its own rate and acceleration.
    pub(super) fn at(self) -> At {
        let Self { motion, v } = self;
        At {
            lower: motion,
            after: motion,
            v,
            before: None,
        }
    }
}

/// The way outward through a joint.
struct Way<'a> {
    moving: Moving<'a>,
    v: Vector,
    is_root: bool,
    /// True where the link carries others.
    carries: bool,
    /// In the order of the way.
    at_motions: Vec<At>,
}

/// What is left of it at the link.
pub(super) struct Went {
    motion: LinkMotion,
    v: Vector,
    pub(super) at_motions: Vec<At>,
}

/// How all links move.
pub(super) fn ways(
    graph: &mut ExprGraph,
    linkage: &Linkage<'_>,
    accelerations: Accelerations<'_>,
) -> BodyMap<Went> {
    let tree = linkage.tree;
    let gravity = given::acting_gravity(graph, tree);
    BodyMap::outward(tree.bodies.len(), |body, ways: &BodyMap<Went>| {
        graph.enter(body);
        let lower = tree.lower(body).map(|lower| &ways[lower]);
        let base = if linkage.falls[body] {
            graph.zero_vector()
        } else {
            gravity.map(|along| -along)
        };
        let motion = lower.map(|lower| &lower.motion);
        let mut way = Way {
            moving: Moving::new(graph, motion, base, accelerations),
            v: lower.map_or_else(|| graph.zero_vector(), |lower| lower.v),
            is_root: lower.is_none(),
            carries: !tree.uppers(body).is_empty(),
            at_motions: Vec::new(),
        };
        linkage.passages[body].outward(graph, &mut way);
        Went {
            motion: way.moving.arrived(graph),
            v: way.v,
            at_motions: way.at_motions,
        }
    })
}

impl Passenger for Way<'_> {
    fn shift(&mut self, graph: &mut ExprGraph, lower: BodyId, offset: Vector) {
        let w = graph.doubled(self.moving.w);
        let swept = graph.cross(w, offset);
        self.v = graph.add_vectors(self.v, swept);
        self.moving.shift(graph, lower, offset);
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive) {
        let Moving { w, alpha, .. } = self.moving;
        let begins_before =
            matches!(drive, Drive::Angle(..)) && self.carries && !graph.is_zero_vector(w);
        let before = begins_before.then(|| Before {
            motion: self.moving.reached(graph),
            v: self.v,
        });
        self.v = rotation.forward(graph, self.v);
        self.moving.turn(graph, rotation, drive);
        let after = self.moving.reached(graph);
        // About the axis of an angle both are the same to what is asked of them.
        let lower = if let Drive::AngularVelocity(_) = drive {
            let [w, alpha] = [w, alpha].map(|v| rotation.forward(graph, v));
            LinkMotion::new(graph, w, alpha, after.a)
        } else {
            after
        };
        let v = self.v;
        self.at_motions.push(At {
            lower,
            after,
            v,
            before,
        });
    }

    fn along(&mut self, graph: &mut ExprGraph, motions: [Option<Motion>; 3]) {
        let lower = self.moving.reached(graph);
        if !self.is_root {
            let own = speeds(graph, motions);
            let own = graph.doubled(own);
            self.v = graph.add_vectors(self.v, own);
        }
        self.moving.along(graph, motions);
        let after = lower;
        let v = self.v;
        self.at_motions.push(At {
            lower,
            after,
            v,
            before: None,
        });
    }
}
