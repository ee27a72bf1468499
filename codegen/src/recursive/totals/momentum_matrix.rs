//! Momentum of all bodies about their mass centre, speed by speed: that of composite bodies, carried inward as a mass matrix's
//! columns are, or taken to inertial axes at once from links that carry many.

use super::center;
use crate::{
    expr::{ExprGraph, Matrix, Purpose, Vector, transpose},
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
        plan::{Plan, Technique},
    },
    tree::{Motion, Tree},
};

/// From how many columns on it pays to know how a link stands in the inertial frame: each would be rotated by its joint for 6
/// operations a vector, and by the matrix costs no more than by the lower link's, which itself takes 18.
const MANY: usize = 3;

/// The columns of the momentum matrix about the mass centre, inertial components, one a speed.
pub fn momentum_matrix(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Vec<Momentum> {
    let plan = root::kept_whole(tree, plan);
    let linkage = Linkage::of_speeds(graph, tree, &plan);
    let inertias = BodyMap::outward(tree.bodies.len(), |body, _| linkage.links[body].inertia);
    let arrived = arrived(graph, &linkage, inertias);
    let center = center::from_first(graph, tree, &linkage.links);
    let zero = Momentum::zero(graph);
    let mut columns = vec![zero; tree.n_speeds];
    for Arrived { column, about } in arrived {
        let mut column = column;
        if let About::Link(link, origin) = about {
            graph.enter(None);
            let from_center = graph.sub_vectors(origin, center);
            let name = format!("{}_from_center", tree.body(link).identifier);
            graph.name_vector(from_center, &name);
            column.shift(graph, from_center);
        }
        graph.enter(column.body());
        add(graph, &mut columns, &column);
    }
    columns
}

/// The partial velocities of the mass centre, inertial components, one a speed; zero where no body has mass.
pub fn center_jacobian(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Vec<Vector> {
    let plan = root::kept_whole(tree, plan);
    let linkage = Linkage::of_speeds(graph, tree, &plan);
    let inertias = BodyMap::outward(tree.bodies.len(), |body, _| linkage.links[body].inertia);
    let zero = Momentum::zero(graph);
    let mut columns = vec![zero; tree.n_speeds];
    for Arrived { column, .. } in arrived(graph, &linkage, inertias) {
        graph.enter(column.body());
        add(graph, &mut columns, &column);
    }
    let columns = columns.into_iter();
    columns
        .map(|column| given::over_total_mass(graph, tree, column.linear))
        .collect()
}

fn add(graph: &mut ExprGraph, columns: &mut [Momentum], column: &Column) {
    let Motion { speed, factor } = column.motion;
    let factor = graph.number(factor);
    let [linear, angular] = column.parts().map(|part| graph.scale(factor, part));
    let sum = &mut columns[speed.index()];
    *sum = sum.plus(graph, &Momentum { linear, angular });
}

/// A column in inertial axes.
struct Arrived {
    column: Column,
    about: About,
}

/// What the angular part of a column is about.
#[derive(Clone, Copy)]
enum About {
    /// The origin of a link, and where that is from the origin of the first link on the inertial frame, inertial components.
    Link(BodyId, Vector),
    /// The mass centre: the whole system moves along an axis, and has no angular momentum.
    Center,
}

/// The momentum of composite bodies for a unit of each motion, in inertial axes, about some link's origin.
fn arrived(
    graph: &mut ExprGraph,
    linkage: &Linkage<'_>,
    mut composites: BodyMap<Composite>,
) -> Vec<Arrived> {
    let Linkage { tree, passages, .. } = linkage;
    let stands = stands(graph, linkage);
    let roots = tree.body_ids().filter(|body| tree.lower(*body).is_none());
    let n_roots = roots.count();
    graph.begin(Purpose::Momentum);
    let mut columns = BodyMap::outward(tree.bodies.len(), |_, _| Vec::<Column>::new());
    let mut arrived = Vec::new();
    for body in tree.body_ids().rev() {
        graph.enter(body);
        let composite = composites[body];
        inertia::name(graph, &composite.inertia, "composite");
        graph.name_vector(composite.moment, "composite");
        let mut carried = Carried {
            tree,
            body,
            composite,
            columns: std::mem::take(&mut columns[body]),
            through_center: Vec::new(),
            is_alone: tree.lower(body).is_none() && n_roots == 1,
        };
        passages[body].inward(graph, &mut carried);
        let Carried {
            composite,
            columns: own,
            through_center,
            ..
        } = carried;
        let Some(lower) = tree.lower(body) else {
            let about = About::Link(body, root::from_first(graph, tree, &linkage.links, body));
            let through = through_center
                .into_iter()
                .map(|column| (column, About::Center));
            let all = own.into_iter().map(|column| (column, about)).chain(through);
            arrived.extend(all.map(|(column, about)| Arrived { column, about }));
            continue;
        };
        graph.enter(lower);
        composites[lower] = composites[lower].plus(graph, &composite);
        match &stands[lower] {
            None => columns[lower].extend(own),
            Some(stand) => {
                let taken = own
                    .into_iter()
                    .map(|column| stand.take(graph, lower, column));
                arrived.extend(taken);
            }
        }
    }
    arrived
}

/// How a link stands in the inertial frame.
#[derive(Clone, Copy, Debug)]
struct Stand {
    /// Inertial components to the link's.
    rotation: Matrix,
    /// Of its origin, from that of the first link on the inertial frame, inertial components.
    origin: Vector,
}

impl Stand {
    fn take(&self, graph: &mut ExprGraph, link: BodyId, mut column: Column) -> Arrived {
        column.turn(graph, &self.rotation);
        Arrived {
            column,
            about: About::Link(link, self.origin),
        }
    }
}

/// The same of links that carry many columns, where the plan has them go to inertial axes at once.
fn stands(graph: &mut ExprGraph, linkage: &Linkage<'_>) -> BodyMap<Option<Stand>> {
    let Linkage {
        tree, links, plan, ..
    } = linkage;
    graph.begin(Purpose::Outward);
    let mut carried = BodyMap::outward(tree.bodies.len(), |_, _| 0);
    for body in tree.body_ids().rev() {
        if let Some(lower) = tree.lower(body) {
            let own = tree
                .body(body)
                .joint
                .motions()
                .into_iter()
                .flatten()
                .count();
            carried[lower] += own + carried[body];
        }
    }
    BodyMap::outward(
        tree.bodies.len(),
        |body, stands: &BodyMap<Option<Stand>>| {
            if !plan.uses(Technique::Shortcut) || carried[body] < MANY {
                return None;
            }
            let passage = &links[body].passage;
            let (below, origin) = match tree.lower(body) {
                Some(lower) => {
                    let stand: Stand =
                        stands[lower].expect("momentum matrix: a lower link carries more");
                    graph.enter(body);
                    let back = transpose(&stand.rotation);
                    let offset = graph.mul_vector(&back, passage.offset);
                    (back, graph.add_vectors(stand.origin, offset))
                }
                None => (graph.identity(), root::from_first(graph, tree, links, body)),
            };
            graph.enter(body);
            // An inertial axis in link components is a column of the rotation.
            let axes = below.map(|axis| {
                let axis = passage.constant.forward(graph, axis);
                passage.forward_from_joint(graph, axis)
            });
            let rotation = transpose(&axes);
            graph.name_matrix(&rotation, "rot");
            graph.name_vector(origin, "p_o");
            Some(Stand { rotation, origin })
        },
    )
}

/// A composite body and the columns of what it carries, on their way inward through a joint, where its own begin.
struct Carried<'a> {
    tree: &'a Tree,
    body: BodyId,
    composite: Composite,
    columns: Vec<Column>,
    /// Those of motions that move the mass centre along an axis with all bodies.
    through_center: Vec<Column>,
    /// True for the only link on the inertial frame: all bodies move with it.
    is_alone: bool,
}

impl Carried<'_> {
    fn column(
        &self,
        graph: &mut ExprGraph,
        motion: Motion,
        place: usize,
        momentum: [Vector; 2],
    ) -> Column {
        let name = self.tree.body(self.body).joint.motion_names()[place];
        Column::new(graph, self.body, motion, name, momentum)
    }
}

impl Passenger for Carried<'_> {
    fn shift(&mut self, graph: &mut ExprGraph, lower: BodyId, offset: Vector) {
        for column in &mut self.columns {
            column.shift(graph, offset);
            column.name(graph, self.tree, lower);
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
        for column in self.columns.iter_mut().chain(&mut self.through_center) {
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
                self.through_center.push(own);
            } else {
                let own = self.column(graph, motion, 3 + axis, [linear, angular]);
                self.columns.push(own);
            }
        }
    }
}
