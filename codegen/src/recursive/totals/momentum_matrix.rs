//! Momentum of all bodies about their mass centre or the inertial origin, speed by speed: that of composite bodies, carried inward as a mass matrix's
//! columns are, or taken to inertial axes at once from links that carry many.

use super::{
    axes, center,
    changes::{self, Change},
    stands::{self, Reference, Stand, Stands},
};
use crate::{
    expr::{ExprGraph, Purpose, Vector},
    given,
    id::{BodyId, BodyMap},
    kane::center::Momentum,
    recursive::{
        links::{
            inertia::{self, Composite},
            linkage::Linkage,
            passage::{Drive, Passenger},
            root,
            rotation::Turn,
        },
        matrices::column::Column,
        plan::Plan,
    },
    tree::{Motion, Tree},
};

/// The columns of the momentum matrix about the mass centre, inertial components, one a speed.
pub fn momentum_matrix(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Vec<Momentum> {
    let plan = root::kept_whole(tree, plan);
    let linkage = Linkage::of_speeds(graph, tree, &plan);
    let center = center::from_first(graph, tree, &linkage.links);
    let stands = Stands::new(graph, &linkage, Reference::Center(center));
    by_speeds(graph, &linkage, &stands)
}

/// The same, and how what each speed moves changes as it moves. Each speed moves one joint.
pub fn momentum_matrix_with_changes(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> (Vec<Momentum>, Vec<Change>) {
    let plan = root::kept_whole(tree, plan);
    let linkage = Linkage::of_speeds(graph, tree, &plan);
    let center = center::from_first(graph, tree, &linkage.links);
    let stands = Stands::new(graph, &linkage, Reference::Center(center));
    let arrived = arrived(graph, &linkage, &stands);
    let columns = summed(graph, tree, &arrived.columns);
    let changes = changes::changes(graph, &linkage, &stands, &arrived.composites, &columns);
    (columns, changes)
}

/// The columns of the angular momentum about the inertial origin, inertial components, one a speed.
pub fn angular_about_origin(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Vec<Vector> {
    let linkage = Linkage::of_speeds(graph, tree, plan);
    let stands = Stands::new(graph, &linkage, Reference::Origin);
    let columns = by_speeds(graph, &linkage, &stands).into_iter();
    columns.map(|column| column.angular).collect()
}

/// The partial velocities of the mass centre, inertial components, one a speed; zero where no body has mass.
pub fn center_jacobian(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Vec<Vector> {
    let plan = root::kept_whole(tree, plan);
    let linkage = Linkage::of_speeds(graph, tree, &plan);
    let Some([first, last]) = stands::by_mass(graph, &linkage) else {
        return vec![graph.zero_vector(); tree.n_speeds];
    };
    let stands = Stands::new(graph, &linkage, Reference::Times(first));
    let columns = by_speeds(graph, &linkage, &stands).into_iter();
    graph.enter(None);
    let columns = columns.map(|column| graph.scale(last, column.linear));
    columns.collect()
}

/// The same, after the angular velocities of what moves. Rotations to inertial axes serve both, so that no factor is in them.
pub fn center_jacobian_with_axes(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> [Vec<Vector>; 2] {
    let plan = root::kept_whole(tree, plan);
    let linkage = Linkage::of_speeds(graph, tree, &plan);
    let one = graph.one();
    let stands = Stands::new(graph, &linkage, Reference::Times(one));
    let columns = by_speeds(graph, &linkage, &stands).into_iter();
    let columns = columns.map(|column| given::over_total_mass(graph, tree, column.linear));
    let columns = columns.collect();
    [axes::turning(graph, &linkage), columns]
}

/// The momentum of composite bodies for a unit of each speed, along inertial axes and about the point of the stands.
fn by_speeds(graph: &mut ExprGraph, linkage: &Linkage<'_>, stands: &Stands) -> Vec<Momentum> {
    let arrived = arrived(graph, linkage, stands);
    summed(graph, linkage.tree, &arrived.columns)
}

/// Columns of motions, added up speed by speed.
fn summed(graph: &mut ExprGraph, tree: &Tree, columns: &[Column]) -> Vec<Momentum> {
    let zero = Momentum::zero(graph);
    let mut sums = vec![zero; tree.n_speeds];
    for column in columns {
        graph.enter(column.body());
        let Motion { speed, factor } = column.motion;
        let factor = graph.number(factor);
        let [linear, angular] = column.parts().map(|part| graph.scale(factor, part));
        let sum = &mut sums[speed.index()];
        *sum = sum.plus(graph, &Momentum { linear, angular });
    }
    sums
}

/// What arrives at the inertial frame, and what was met on the way.
struct Arrived {
    /// One a motion.
    columns: Vec<Column>,
    /// Of each speed the composite body that it moves, where its motion enters.
    composites: Vec<Composite>,
}

/// The momentum of composite bodies for a unit of each motion.
fn arrived(graph: &mut ExprGraph, linkage: &Linkage<'_>, stands: &Stands) -> Arrived {
    let Linkage { tree, passages, .. } = linkage;
    let mut composites = BodyMap::outward(tree.bodies.len(), |body, _| linkage.links[body].inertia);
    let only_root = tree.only_root().filter(|_| stands.ignores_shifts);
    graph.begin(Purpose::Momentum);
    let mut columns = BodyMap::outward(tree.bodies.len(), |_, _| Vec::<Column>::new());
    let mut arrived = Arrived {
        columns: Vec::new(),
        composites: vec![Composite::zero(graph); tree.n_speeds],
    };
    for body in tree.body_ids().rev() {
        graph.enter(body);
        let composite = composites[body];
        inertia::name(graph, &composite.inertia, "composite");
        graph.name_vector(composite.moment, "composite");
        let lower = tree.lower(body);
        let mut carried = Carried {
            tree,
            body,
            composite,
            columns: std::mem::take(&mut columns[body]),
            at_point: Vec::new(),
            is_alone: only_root == Some(body),
            stand: lower.and_then(|lower| stands.links[lower]),
            moved: &mut arrived.composites,
        };
        passages[body].inward(graph, &mut carried);
        if lower.is_none() {
            let (stand, nowhere) = (stands.at_root(graph, linkage, body), graph.zero_vector());
            carried.leave(graph, &stand, nowhere);
        }
        arrived.columns.extend(carried.at_point);
        if let Some(lower) = lower {
            graph.enter(lower);
            composites[lower] = composites[lower].plus(graph, &carried.composite);
            columns[lower].extend(carried.columns);
        }
    }
    arrived
}

/// A composite body and the columns of what it carries, on their way inward through a joint, where its own begin.
struct Carried<'a> {
    tree: &'a Tree,
    body: BodyId,
    composite: Composite,
    columns: Vec<Column>,
    /// Those about the point of the stands: of shifts of all bodies, which have no moment about the mass centre, and what has left.
    at_point: Vec<Column>,
    /// True for the only link on the inertial frame, with which all bodies move, if moments of its shifts are ignored.
    is_alone: bool,
    /// How the lower link stands, where columns leave it for inertial axes.
    stand: Option<Stand>,
    /// Of each speed the composite body that it moves.
    moved: &'a mut [Composite],
}

impl Carried<'_> {
    fn column(
        &mut self,
        graph: &mut ExprGraph,
        motion: Motion,
        place: usize,
        momentum: [Vector; 2],
    ) -> Column {
        self.moved[motion.speed.index()] = self.composite;
        let name = self.tree.body(self.body).joint.motion_names()[place];
        Column::new(graph, self.body, motion, name, momentum)
    }

    /// Sends all columns to inertial axes, from an origin that lies at `offset` from that of the stand.
    fn leave(&mut self, graph: &mut ExprGraph, stand: &Stand, offset: Vector) {
        let lever = stand.lever(graph, offset);
        for column in &mut self.columns {
            column.shift(graph, lever);
        }
        self.at_point.append(&mut self.columns);
        for column in &mut self.at_point {
            column.turn_in(graph, stand.scope(column.body()), stand.rotation());
        }
    }
}

impl Passenger for Carried<'_> {
    fn shift(&mut self, graph: &mut ExprGraph, lower: BodyId, offset: Vector) {
        match self.stand {
            Some(stand) => self.leave(graph, &stand, offset),
            None => {
                for column in &mut self.columns {
                    column.shift(graph, offset);
                    column.name(graph, self.tree, lower);
                }
            }
        }
        graph.enter(self.body);
        self.composite = self.composite.moved(graph, offset);
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive) {
        for (axis, motion) in drive.motions().into_iter().enumerate() {
            let Some(motion) = motion else { continue };
            let momentum = self.composite.turned_about(graph, axis);
            let own = self.column(graph, motion, axis, momentum);
            self.columns.push(own);
        }
        self.composite = rotation.backward_composite(graph, &self.composite);
        for column in self.columns.iter_mut().chain(&mut self.at_point) {
            column.turn(graph, rotation);
        }
        graph.enter(self.body);
    }

    fn along(&mut self, graph: &mut ExprGraph, motions: [Option<Motion>; 3]) {
        for (axis, motion) in motions.into_iter().enumerate() {
            let Some(motion) = motion else { continue };
            let [linear, angular] = self.composite.shifted_along(graph, axis);
            if self.is_alone {
                let none = graph.zero_vector();
                let own = self.column(graph, motion, 3 + axis, [linear, none]);
                self.at_point.push(own);
            } else {
                let own = self.column(graph, motion, 3 + axis, [linear, angular]);
                self.columns.push(own);
            }
        }
    }
}
