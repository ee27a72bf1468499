//! Derivatives of what all bodies need together, and of their momentum: columns begin as those of inverse dynamics do, and go on to the
//! inertial frame, where they are added up speed by speed.
//!
//! Momentum is what a system at rest without weight needs for accelerations that are the speeds.

use std::collections::BTreeMap;

use super::{
    column::DerivativeColumn,
    passing::{Composites, Passing},
    reader::Reader,
    way::{At, ways},
};
use crate::{
    expr::{Expr, ExprGraph, Input, Purpose, Vector},
    given::{self, Accelerations, Loads},
    id::{BodyId, BodyMap, SpeedId},
    kane::center::Momentum,
    recursive::{
        forces::loaded,
        links::{
            linkage::Linkage,
            passage::{Drive, Passenger},
            root,
            rotation::Turn,
            wrench::Wrench,
        },
        matrices::shortcut::Next,
        plan::Plan,
        totals::{
            center,
            stands::{self, Reference, Stand, Stands},
        },
    },
    tree::{Motion, Tree},
};

/// A resultant about a point, inertial components, and how it changes, speed by speed.
#[derive(Debug)]
pub struct Resultant {
    /// Its value.
    pub whole: Momentum,
    /// With the coordinates, along the motions of the speeds.
    pub by_q: Vec<Momentum>,
    /// With the speeds.
    pub by_u: Vec<Momentum>,
}

/// The momentum of all bodies about the inertial origin.
pub fn of_momentum(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Resultant {
    let linkage = Linkage::weightless(graph, tree, plan);
    let about = Reference::Origin;
    let columns = Columns::new(graph, &linkage, about, Accelerations::Given);
    columns.of_momentum(graph, tree)
}

/// Its rate about the mass centre where no speed changes.
pub fn of_momentum_rate(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Resultant {
    let plan = root::kept_whole(tree, plan);
    let linkage = Linkage::weightless(graph, tree, &plan);
    let center = center::from_first(graph, tree, &linkage.links);
    let about = Reference::Center(center);
    let columns = Columns::new(graph, &linkage, about, Accelerations::Zero);
    let mut found = columns.of_rate(graph, tree);
    let carried = columns.summed(graph, tree, |own| own.carrying.momentum.wrench);
    // Moments are about a mass centre that moves.
    for (own, carried) in found.by_q.iter_mut().zip(carried) {
        let moved = given::over_total_mass(graph, tree, carried.linear);
        let lever = graph.cross(moved, columns.whole.linear);
        own.angular = graph.sub_vectors(own.angular, lever);
    }
    found
}

/// The velocity of the mass centre, linear; zero where no body has mass.
pub fn of_center_velocity(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Resultant {
    by_mass(
        graph,
        tree,
        plan,
        Accelerations::Given,
        Columns::of_momentum,
    )
}

/// Its acceleration where no speed changes, linear; zero where no body has mass.
pub fn of_center_acceleration(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Resultant {
    by_mass(graph, tree, plan, Accelerations::Zero, Columns::of_rate)
}

/// A linear resultant over all mass.
fn by_mass(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    accelerations: Accelerations<'_>,
    part: fn(&Columns, &mut ExprGraph, &Tree) -> Resultant,
) -> Resultant {
    let plan = root::kept_whole(tree, plan);
    let linkage = Linkage::weightless(graph, tree, &plan);
    let Some([first, last]) = stands::by_mass(graph, &linkage) else {
        let zero = Momentum::zero(graph);
        return Resultant {
            whole: zero,
            by_q: vec![zero; tree.n_speeds],
            by_u: vec![zero; tree.n_speeds],
        };
    };
    let columns = Columns::new(graph, &linkage, Reference::Times(first), accelerations);
    let found = part(&columns, graph, tree);
    graph.enter(None);
    found.map(|own| Momentum {
        linear: graph.scale(last, own.linear),
        ..*own
    })
}

impl Resultant {
    /// The same function of all.
    fn map(&self, mut f: impl FnMut(&Momentum) -> Momentum) -> Self {
        Self {
            whole: f(&self.whole),
            by_q: self.by_q.iter().map(&mut f).collect(),
            by_u: self.by_u.iter().map(&mut f).collect(),
        }
    }

    /// Where the system rests and its accelerations are the speeds.
    fn at_rest(&self, graph: &mut ExprGraph, tree: &Tree) -> Self {
        let all = std::iter::once(&self.whole);
        let all = all.chain(&self.by_q).chain(&self.by_u);
        let entries: Vec<Expr> = all
            .flat_map(|own| [own.linear, own.angular].concat())
            .collect();
        let speeds = (0..tree.n_speeds).map(SpeedId::new);
        let values = speeds.flat_map(|speed| {
            let own = graph.input(Input::U(speed));
            [(Input::U(speed), graph.zero()), (Input::UDot(speed), own)]
        });
        let values: BTreeMap<Input, Expr> = values.collect();
        let entries = graph.substituted(&entries, &values);
        let mut vectors = entries.as_chunks::<3>().0.iter().copied();
        let mut next = || {
            vectors
                .next()
                .expect("resultant: each vector has its place")
        };
        self.map(|_| Momentum {
            linear: next(),
            angular: next(),
        })
    }
}

/// What has come to the inertial frame.
struct Columns {
    whole: Momentum,
    columns: Vec<DerivativeColumn>,
}

impl Columns {
    fn new(
        graph: &mut ExprGraph,
        linkage: &Linkage<'_>,
        about: Reference,
        accelerations: Accelerations<'_>,
    ) -> Self {
        let Linkage { tree, passages, .. } = linkage;
        let wrenches = loaded::needed(graph, linkage, accelerations, Loads::Absent);
        let stands = Stands::new(graph, linkage, about);
        graph.begin(Purpose::Derivative);
        let ways = ways(graph, linkage, accelerations);
        let mut composites = Composites::new(graph, linkage, &ways, &wrenches);
        let mut columns =
            BodyMap::outward(tree.bodies.len(), |_, _| Vec::<DerivativeColumn>::new());
        let is_about_center = matches!(about, Reference::Center(_));
        let only_root = tree.only_root().filter(|_| is_about_center);
        let mut found = Self {
            whole: Momentum::zero(graph),
            columns: Vec::new(),
        };
        for body in tree.body_ids().rev() {
            graph.enter(body);
            let lower = tree.lower(body);
            let mut carried = Carried {
                passing: composites.at(body),
                columns: std::mem::take(&mut columns[body]),
                is_alone: only_root == Some(body),
                stand: lower.and_then(|lower| stands.links[lower]),
                arrived: &mut found.columns,
            };
            passages[body].inward(graph, &mut carried);
            let Some(lower) = lower else {
                let stand = stands.at_root(graph, linkage, body);
                let nowhere = graph.zero_vector();
                carried.leave(graph, &stand, nowhere);
                let wrench = carried.passing.wrench;
                found.add(graph, &stand, wrench);
                continue;
            };
            let Carried {
                passing,
                columns: others,
                ..
            } = carried;
            composites.add(graph, lower, &passing, |graph| {
                for column in &others {
                    column.hint(graph, tree, lower);
                }
            });
            columns[lower].extend(others);
        }
        found
    }

    /// Of a system whose accelerations are given: its momentum.
    fn of_momentum(&self, graph: &mut ExprGraph, tree: &Tree) -> Resultant {
        let found = Resultant {
            whole: self.whole,
            by_q: self.summed(graph, tree, |own| own.displaced.wrench),
            by_u: self.summed(graph, tree, |own| own.carrying.momentum.wrench),
        };
        found.at_rest(graph, tree)
    }

    /// The rate of momentum where no speed changes.
    fn of_rate(&self, graph: &mut ExprGraph, tree: &Tree) -> Resultant {
        Resultant {
            whole: self.whole,
            by_q: self.summed(graph, tree, |own| own.displaced.wrench),
            by_u: self.summed(graph, tree, |own| own.carrying.needed.wrench),
        }
    }

    /// Adds what a link on the inertial frame needs with all that it carries.
    fn add(&mut self, graph: &mut ExprGraph, stand: &Stand, wrench: Wrench) {
        let nowhere = graph.zero_vector();
        let lever = stand.lever(graph, nowhere);
        graph.enter(None);
        let wrench = wrench.moved(graph, lever);
        let Wrench { force, moment } = wrench.map(|v| stand.rotation().backward(graph, v));
        let own = Momentum {
            linear: force,
            angular: moment,
        };
        self.whole = self.whole.plus(graph, &own);
    }

    /// A part of all columns, added up speed by speed.
    fn summed(
        &self,
        graph: &mut ExprGraph,
        tree: &Tree,
        part: impl Fn(&DerivativeColumn) -> Wrench,
    ) -> Vec<Momentum> {
        let zero = Momentum::zero(graph);
        let mut sums = vec![zero; tree.n_speeds];
        for column in &self.columns {
            let Motion { speed, factor } = column.carrying.motion;
            graph.enter(column.carrying.body);
            let factor = graph.number(factor);
            let Wrench { force, moment } = part(column).map(|v| graph.scale(factor, v));
            let own = Momentum {
                linear: force,
                angular: moment,
            };
            let sum = &mut sums[speed.index()];
            *sum = sum.plus(graph, &own);
        }
        sums
    }
}

/// A composite body and the columns of what it carries, on their way inward through a joint, where its own begin.
struct Carried<'a> {
    passing: Passing<'a>,
    columns: Vec<DerivativeColumn>,
    /// True for the only link on the inertial frame, whose shifts change no rate of a momentum about the mass centre.
    is_alone: bool,
    /// How the lower link stands, where columns leave it for inertial axes.
    stand: Option<Stand>,
    arrived: &'a mut Vec<DerivativeColumn>,
}

impl Carried<'_> {
    /// Sends all columns to inertial axes, from an origin that lies at `offset` from that of the stand.
    fn leave(&mut self, graph: &mut ExprGraph, stand: &Stand, offset: Vector) {
        let lever = stand.lever(graph, offset);
        for mut column in self.columns.drain(..) {
            column.reach(graph, lever, Next::UNKNOWN);
            let scope = stand.scope(column.carrying.body);
            column.turn_in(graph, scope, stand.rotation());
            self.arrived.push(column);
        }
    }

    /// Begins the columns of turns that enter together; `own` is their angular velocity, where that has several components.
    fn begin(&mut self, graph: &mut ExprGraph, at: &At, drive: Drive) {
        let start = self.passing.start(at);
        let own = match drive {
            Drive::AngularVelocity(_) => drive.speeds(graph),
            Drive::Nothing | Drive::Angle(..) => graph.zero_vector(),
        };
        for (axis, motion) in drive.motions().into_iter().enumerate() {
            if let Some(motion) = motion {
                let reader = Reader::of_turn(graph, motion, axis, at, own);
                self.columns.push(start.turn(graph, &reader, own));
            }
        }
    }
}

impl Passenger for Carried<'_> {
    fn shift(&mut self, graph: &mut ExprGraph, _: BodyId, offset: Vector) {
        if let Some(stand) = self.stand {
            self.leave(graph, &stand, offset);
        }
        for column in &mut self.columns {
            column.reach(graph, offset, Next::UNKNOWN);
        }
        self.passing.shift(graph, offset);
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive) {
        let at = self.passing.next();
        if at.before.is_none() {
            self.begin(graph, &at, drive);
        }
        for column in &mut self.columns {
            column.turn(graph, rotation);
        }
        self.passing.turn_back(graph, rotation, drive);
        if let Some(before) = at.before {
            self.begin(graph, &before.at(), drive);
        }
    }

    fn along(&mut self, graph: &mut ExprGraph, motions: [Option<Motion>; 3]) {
        let at = self.passing.next();
        let start = self.passing.start(&at);
        for (axis, motion) in motions.into_iter().enumerate() {
            let Some(motion) = motion.filter(|_| !self.is_alone) else {
                continue;
            };
            let reader = Reader::of_shift(graph, motion, axis, &at);
            self.columns.push(start.shift(graph, &reader));
        }
        self.passing.along(graph, motions);
    }
}
