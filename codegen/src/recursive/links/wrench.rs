//! Wrenches, and the generalized forces that are read off them.

use super::{
    inertia::Composite,
    passage::{Drive, Passenger},
    rotation::Turn,
    totalled::Addend,
};
use crate::{
    expr::{Expr, ExprGraph, Vector},
    id::BodyId,
    tree::Motion,
};

/// A force and its moment about the link's origin, link components.
#[derive(Clone, Copy, Debug)]
pub(in crate::recursive) struct Wrench {
    pub(in crate::recursive) force: Vector,
    pub(in crate::recursive) moment: Vector,
}

impl Wrench {
    /// What gives bodies at rest, with this inertia about the origin, these accelerations; or their momentum at such velocities.
    pub(in crate::recursive) fn of_inertia(
        graph: &mut ExprGraph,
        inertia: &Composite,
        linear: Vector,
        angular: Vector,
    ) -> Self {
        let (carried, swept) = (
            graph.scale(inertia.mass, linear),
            graph.cross(angular, inertia.moment),
        );
        let (spun, lever) = (
            graph.mul_symmetric(&inertia.inertia, angular),
            graph.cross(inertia.moment, linear),
        );
        Self {
            force: graph.add_vectors(carried, swept),
            moment: graph.add_vectors(spun, lever),
        }
    }

    /// This one less another, about the same point.
    pub(in crate::recursive) fn minus(&self, graph: &mut ExprGraph, other: &Self) -> Self {
        Self {
            force: graph.sub_vectors(self.force, other.force),
            moment: graph.sub_vectors(self.moment, other.moment),
        }
    }

    /// About a point from which this one's point lies at `offset`.
    pub(in crate::recursive) fn moved(&self, graph: &mut ExprGraph, offset: Vector) -> Self {
        let lever = graph.cross(offset, self.force);
        Self {
            force: self.force,
            moment: graph.add_vectors(self.moment, lever),
        }
    }

    /// The same function of force and moment, in this order.
    pub(in crate::recursive) fn map(&self, mut f: impl FnMut(Vector) -> Vector) -> Self {
        Self {
            force: f(self.force),
            moment: f(self.moment),
        }
    }

    /// The moment's components, then the force's.
    pub(in crate::recursive) fn parts(&self) -> [Expr; 6] {
        let ([nx, ny, nz], [fx, fy, fz]) = (self.moment, self.force);
        [nx, ny, nz, fx, fy, fz]
    }

    pub(in crate::recursive) fn of_parts([nx, ny, nz, fx, fy, fz]: [Expr; 6]) -> Self {
        Self {
            force: [fx, fy, fz],
            moment: [nx, ny, nz],
        }
    }
}

/// Nothing is read off it on the way.
impl Passenger for Wrench {
    fn shift(&mut self, graph: &mut ExprGraph, _: BodyId, offset: Vector) {
        *self = self.moved(graph, offset);
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, _: Drive) {
        *self = self.map(|v| rotation.backward(graph, v));
    }

    fn along(&mut self, _: &mut ExprGraph, _: [Option<Motion>; 3]) {}
}

impl Addend for Wrench {
    fn plus(&self, graph: &mut ExprGraph, other: &Self) -> Self {
        Self {
            force: graph.add_vectors(self.force, other.force),
            moment: graph.add_vectors(self.moment, other.moment),
        }
    }
}

/// Adds what acts along motions, by the axes of these, to the generalized forces of their speeds.
pub(in crate::recursive) fn read_off(
    graph: &mut ExprGraph,
    tau: &mut [Expr],
    motions: [Option<Motion>; 3],
    along: Vector,
) {
    for (motion, along) in motions.into_iter().zip(along) {
        add(graph, tau, motion, along);
    }
}

/// Adds what acts along a motion to the generalized force of its speed.
pub(in crate::recursive) fn add(
    graph: &mut ExprGraph,
    tau: &mut [Expr],
    motion: Option<Motion>,
    along: Expr,
) {
    let Some(Motion { speed, factor }) = motion else {
        return;
    };
    let factor = graph.number(factor);
    let share = graph.mul(factor, along);
    tau[speed.index()] = graph.add(tau[speed.index()], share);
}
