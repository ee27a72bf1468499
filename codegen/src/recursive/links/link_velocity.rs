//! The velocities of links along their own axes, carried outward.

use super::{
    link::Link,
    passage::{Drive, Passenger, speeds},
    rotation::Turn,
};
use crate::{
    expr::{ExprGraph, Vector},
    id::{BodyId, BodyMap},
    tree::{Motion, Tree},
};

/// The velocity of a link in its own axes, or of what has been reached on the way outward.
#[derive(Clone, Copy, Debug)]
pub(in crate::recursive) struct LinkVelocity {
    /// Of its origin.
    pub(in crate::recursive) linear: Vector,
    pub(in crate::recursive) angular: Vector,
}

/// The velocity of every link.
pub(in crate::recursive) fn velocities(
    graph: &mut ExprGraph,
    tree: &Tree,
    links: &BodyMap<Link>,
) -> BodyMap<LinkVelocity> {
    BodyMap::outward(
        tree.bodies.len(),
        |body, velocities: &BodyMap<LinkVelocity>| {
            graph.enter(body);
            let below = tree.lower(body).map(|lower| velocities[lower]);
            let mut carried = below.unwrap_or_else(|| LinkVelocity::zero(graph));
            links[body].passage.outward(graph, &mut carried);
            carried.name(graph);
            carried
        },
    )
}

impl LinkVelocity {
    /// That of the inertial frame.
    pub(in crate::recursive) fn zero(graph: &mut ExprGraph) -> Self {
        Self {
            linear: graph.zero_vector(),
            angular: graph.zero_vector(),
        }
    }

    pub(in crate::recursive) fn name(&self, graph: &mut ExprGraph) {
        graph.name_vector(self.linear, "v_o");
        graph.name_vector(self.angular, "w");
    }
}

impl Passenger for LinkVelocity {
    fn shift(&mut self, graph: &mut ExprGraph, _: BodyId, offset: Vector) {
        let swept = graph.cross(self.angular, offset);
        self.linear = graph.add_vectors(self.linear, swept);
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive) {
        self.linear = rotation.forward(graph, self.linear);
        self.angular = rotation.forward(graph, self.angular);
        let rates = speeds(graph, drive.motions());
        self.angular = graph.add_vectors(self.angular, rates);
    }

    fn along(&mut self, graph: &mut ExprGraph, motions: [Option<Motion>; 3]) {
        let rates = speeds(graph, motions);
        self.linear = graph.add_vectors(self.linear, rates);
    }
}
