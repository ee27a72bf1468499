//! How the inertia about the mass centre changes as each speed moves the composite body that it carries: rotations to inertial axes and the way to
//! the mass centre pass outward, and each motion meets its composite body where it enters.

use super::stands::{Stand, Stands};
use crate::{
    expr::{Axis, ExprGraph, Purpose, Symmetric, Vector},
    given,
    id::{BodyId, BodyMap, SpeedId},
    kane::center::Momentum,
    recursive::links::{
        inertia::{self, Composite},
        linkage::Linkage,
        passage::{Drive, Passenger},
        rotation::Turn,
    },
    tree::Motion,
};

/// For a unit of one speed: inertial components.
#[derive(Clone, Copy, Debug)]
pub struct Change {
    /// The angular velocity of what moves.
    pub axis: Vector,
    /// The velocity with which what moves passes the mass centre of all, less that of the mass centre itself.
    pub past_center: Vector,
    /// The rate of the moved bodies' inertia about the point where the mass centre is.
    pub inertia: Symmetric,
}

/// One a speed, of the composite bodies that they move and of their momenta.
pub(super) fn changes(
    graph: &mut ExprGraph,
    linkage: &Linkage<'_>,
    stands: &Stands,
    composites: &[Composite],
    momenta: &[Momentum],
) -> Vec<Change> {
    let Linkage { tree, passages, .. } = linkage;
    graph.begin(Purpose::Outward);
    let none = Change {
        axis: graph.zero_vector(),
        past_center: graph.zero_vector(),
        inertia: graph.zero_symmetric(),
    };
    let mut changes = vec![none; tree.n_speeds];
    let only_root = tree.only_root();
    BodyMap::outward(tree.bodies.len(), |body, reached: &BodyMap<Stand>| {
        let stand = match tree.lower(body) {
            Some(lower) => reached[lower],
            None => stands.at_root(graph, linkage, body),
        };
        graph.enter(body);
        let mut met = Met {
            body,
            stand,
            linkage,
            composites,
            momenta,
            is_all: only_root == Some(body),
            changes: &mut changes,
        };
        passages[body].outward(graph, &mut met);
        let stand = met.stand;
        graph.name_matrix(stand.rotation(), "rot");
        stand
    });
    changes
}

/// A link's axes on their way outward through its joint.
struct Met<'a> {
    body: BodyId,
    stand: Stand,
    linkage: &'a Linkage<'a>,
    composites: &'a [Composite],
    momenta: &'a [Momentum],
    /// True for the only link on the inertial frame, which carries all mass: the mass centre moves as it does.
    is_all: bool,
    changes: &'a mut [Change],
}

impl Met<'_> {
    /// From the mass centre to the origin that has been reached.
    fn lever(&self, graph: &mut ExprGraph) -> Vector {
        let nowhere = graph.zero_vector();
        self.stand.lever(graph, nowhere)
    }

    /// Of a motion, what is along the axes that have been reached: with the velocity at the mass centre.
    fn meet(&mut self, graph: &mut ExprGraph, speed: SpeedId, own: &Change) {
        let rotation = *self.stand.rotation();
        let change = &mut self.changes[speed.index()];
        change.axis = rotation.backward(graph, own.axis);
        change.inertia = rotation.backward_symmetric(graph, &own.inertia);
        if !self.is_all {
            let past = rotation.backward(graph, own.past_center);
            let linear = self.momenta[speed.index()].linear;
            let of_center = given::over_total_mass(graph, self.linkage.tree, linear);
            graph.enter(self.body);
            change.past_center = graph.sub_vectors(past, of_center);
        }
    }
}

impl Passenger for Met<'_> {
    fn shift(&mut self, graph: &mut ExprGraph, lower: BodyId, offset: Vector) {
        self.stand.shift(graph, lower, offset);
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive) {
        self.stand.turn(graph, rotation, drive);
        for (axis, motion) in Axis::ALL.into_iter().zip(drive.motions()) {
            let Some(Motion { speed, .. }) = motion else {
                continue;
            };
            let lever = self.lever(graph);
            let composite = &self.composites[speed.index()];
            let unit = graph.unit_vector(axis.index());
            let moved = graph.cross(unit, composite.moment);
            let at_origin = turned(graph, &composite.inertia, axis);
            let with_lever = carried(graph, lever, moved);
            let own = Change {
                axis: unit,
                past_center: graph.cross(lever, unit),
                inertia: graph.add_symmetric(&at_origin, &with_lever),
            };
            self.meet(graph, speed, &own);
        }
    }

    fn along(&mut self, graph: &mut ExprGraph, motions: [Option<Motion>; 3]) {
        for (axis, motion) in motions.into_iter().enumerate() {
            let Some(Motion { speed, .. }) = motion else {
                continue;
            };
            let lever = self.lever(graph);
            let composite = &self.composites[speed.index()];
            let unit = graph.unit_vector(axis);
            let of_lever = graph.scale(composite.mass, lever);
            let moment = graph.add_vectors(composite.moment, of_lever);
            let own = Change {
                axis: graph.zero_vector(),
                past_center: unit,
                inertia: carried(graph, moment, unit),
            };
            self.meet(graph, speed, &own);
        }
    }
}

/// How the inertia about a point changes for a unit angular velocity about an axis through it: `tilde(e) I - I tilde(e)`.
fn turned(graph: &mut ExprGraph, inertia: &Symmetric, axis: Axis) -> Symmetric {
    let (a, (b, c)) = (axis.index(), axis.others());
    let Symmetric { diagonal, mixed } = inertia;
    let two = graph.number(2.0);
    let twice = graph.mul(two, mixed[a]);
    let mut rate = graph.zero_symmetric();
    (rate.diagonal[b], rate.diagonal[c]) = (-twice, twice);
    rate.mixed[a] = graph.sub(diagonal[b], diagonal[c]);
    (rate.mixed[b], rate.mixed[c]) = (mixed[c], -mixed[b]);
    rate
}

/// `2 (r·p) 1 - r p^T - p r^T`: how the inertia about a point changes that has momentum `p` and lies farther off by `r`.
fn carried(graph: &mut ExprGraph, r: Vector, p: Vector) -> Symmetric {
    let two = graph.number(2.0);
    inertia::around(graph, [r, p], two)
}
