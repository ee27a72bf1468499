//! The rate of the mass matrix, from composite bodies.
//!
//! Momenta for unit speeds pass inward as for the mass matrix, and with each how fast it changes, seen from the link that has
//! been reached. The axis of a motion does not change there, so the rate of an entry is read off where the entry would be. No
//! velocity of a link is needed: a joint adds what its own rate does.

use super::{
    gathered::Gathered,
    moments::{Changing, Moments},
    speed_matrix,
    spreading::Spreading,
};
use crate::{
    expr::{ExprGraph, Purpose, Vector},
    id::{BodyId, BodyMap},
    recursive::{
        links::{
            linkage::Linkage,
            passage::{Drive, Passenger, speeds},
            rotation::Turn,
        },
        plan::Plan,
    },
    solve::{SpeedMatrix, zero_matrix},
    tree::{Motion, Tree},
};

/// `dA/dt`, `A` of Eq. (42), and `A` without rotors: the columns' momenta hold it.
pub fn mass_matrix_dot(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> (SpeedMatrix, SpeedMatrix) {
    let linkage = Linkage::of_speeds(graph, tree, plan);
    graph.begin(Purpose::Composite);
    let mut gathered = Gathered::<Spreading>::new(graph, &linkage);
    let mut columns = BodyMap::outward(tree.bodies.len(), |_, _| Vec::<RateColumn>::new());
    let mut a_dot = zero_matrix(graph, tree.n_speeds);
    let mut a = a_dot.clone();
    for body in tree.body_ids().rev() {
        graph.enter(body);
        let mut carried = Carried {
            body,
            moments: gathered.moments[body],
            rates: gathered.rates[body],
            columns: std::mem::take(&mut columns[body]),
            a_dot: &mut a_dot,
            a: &mut a,
        };
        linkage.passages[body].inward(graph, &mut carried);
        let Carried {
            moments: arrived,
            rates: changing,
            columns: others,
            ..
        } = carried;
        if let Some(lower) = tree.lower(body) {
            gathered.add(graph, lower, (&arrived, &changing), |graph| {
                for column in &others {
                    column.hint(graph, tree, lower);
                }
            });
            columns[lower].extend(others);
        }
    }
    (a_dot, a)
}

/// Momentum for a unit value of a speed and its rate, angular and linear, about the origin and along the axes that have been
/// reached.
#[derive(Clone, Copy, Debug)]
struct RateColumn {
    /// The body that moves with the speed: the column's operations belong to it, wherever they are carried.
    body: BodyId,
    motion: Motion,
    /// Of the motion among the six of the joint.
    place: usize,
    momentum: [Vector; 2],
    rate: [Vector; 2],
}

impl RateColumn {
    /// Names by hints what has come to a link: angular and linear momentum `l`, `p`, and their rates.
    fn hint(&self, graph: &mut ExprGraph, tree: &Tree, at: BodyId) {
        let name = tree.body(self.body).joint.motion_names()[self.place];
        let at = &tree.body(at).identifier;
        graph.enter(self.body);
        graph.hint(|graph| {
            for ([angular, linear], dot) in [(self.momentum, ""), (self.rate, "_dot")] {
                graph.name_vector(angular, &format!("{name}_l{dot}_{at}"));
                graph.name_vector(linear, &format!("{name}_p{dot}_{at}"));
            }
        });
    }

    /// Before a rotation, seen from the axes before it.
    fn undriven(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive) {
        graph.enter(self.body);
        let w = drive.speeds(graph);
        if let Drive::AngularVelocity(_) = drive {
            self.driven(graph, w);
            self.turn(graph, rotation);
        } else {
            self.turn(graph, rotation);
            self.driven(graph, w);
        }
    }

    /// Seen from axes about which those that have been reached turn by `w`.
    fn driven(&mut self, graph: &mut ExprGraph, w: Vector) {
        for (rate, momentum) in self.rate.iter_mut().zip(self.momentum) {
            let turned = graph.cross(w, momentum);
            *rate = graph.add_vectors(*rate, turned);
        }
    }

    /// Seen from where the origin moves by `v`.
    fn carried(&mut self, graph: &mut ExprGraph, v: Vector) {
        graph.enter(self.body);
        let moved = graph.cross(v, self.momentum[1]);
        self.rate[0] = graph.add_vectors(self.rate[0], moved);
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn) {
        self.momentum = self.momentum.map(|v| rotation.backward(graph, v));
        self.rate = self.rate.map(|v| rotation.backward(graph, v));
    }

    fn shift(&mut self, graph: &mut ExprGraph, offset: Vector) {
        graph.enter(self.body);
        for [angular, linear] in [&mut self.momentum, &mut self.rate] {
            let lever = graph.cross(offset, *linear);
            *angular = graph.add_vectors(*angular, lever);
        }
    }
}

/// A composite body and the columns of what it carries, on their way inward through a joint.
struct Carried<'a> {
    body: BodyId,
    moments: Moments,
    rates: Spreading,
    columns: Vec<RateColumn>,
    a_dot: &'a mut SpeedMatrix,
    a: &'a mut SpeedMatrix,
}

impl Carried<'_> {
    /// Begins a column, and reads the row of its motion, about (0 to 2) or along (3 to 5) an axis, off all columns.
    fn begin(&mut self, graph: &mut ExprGraph, motion: Motion, place: usize) {
        let unit = graph.unit_vector(place % 3);
        let Self { moments, rates, .. } = self;
        let [momentum, rate] = if place < 3 {
            [
                [
                    moments.about(graph, place),
                    graph.cross(unit, moments.first),
                ],
                [rates.about(graph, place), graph.cross(unit, rates.first)],
            ]
        } else {
            let still = graph.zero_vector();
            [
                [
                    graph.cross(moments.first, unit),
                    graph.scale(moments.mass, unit),
                ],
                [graph.cross(rates.first, unit), still],
            ]
        };
        self.columns.push(RateColumn {
            body: self.body,
            motion,
            place,
            momentum,
            rate,
        });
        let last = self.columns.len() - 1;
        for (i, column) in self.columns.iter().enumerate() {
            let row = [motion, column.motion];
            let (part, axis) = (place / 3, place % 3);
            speed_matrix::add_mirrored(graph, self.a_dot, row, column.rate[part][axis], i == last);
            speed_matrix::add_mirrored(graph, self.a, row, column.momentum[part][axis], i == last);
        }
    }
}

impl Passenger for Carried<'_> {
    fn shift(&mut self, graph: &mut ExprGraph, _: BodyId, offset: Vector) {
        for column in &mut self.columns {
            column.shift(graph, offset);
        }
        graph.enter(self.body);
        self.rates = self.rates.moved(graph, offset);
        self.moments = self.moments.moved(graph, offset);
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive) {
        for (axis, motion) in drive.motions().into_iter().enumerate() {
            if let Some(motion) = motion {
                self.begin(graph, motion, axis);
            }
        }
        // The body's speeds are read as its own, before columns of others need them.
        let w = drive.speeds(graph);
        for column in &mut self.columns {
            column.undriven(graph, rotation, drive);
        }
        graph.enter(self.body);
        self.rates = self
            .rates
            .undriven(graph, &mut self.moments, rotation, (drive, w));
    }

    fn along(&mut self, graph: &mut ExprGraph, motions: [Option<Motion>; 3]) {
        for (axis, motion) in motions.into_iter().enumerate() {
            if let Some(motion) = motion {
                self.begin(graph, motion, 3 + axis);
            }
        }
        let own = speeds(graph, motions);
        self.rates = self.rates.carried(graph, &self.moments, own);
        for column in &mut self.columns {
            column.carried(graph, own);
        }
        graph.enter(self.body);
    }
}
