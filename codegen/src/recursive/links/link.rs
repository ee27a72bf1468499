//! Links: the bodies as the recursion sees them, each in axes and with an origin of the plan's choice.
//!
//! In: a tree and a plan. Out: every body's [`Link`]. They come about in stages, each made of the ones before: layouts, each
//! link by itself, inertias regrouped, axes merged.

use super::{
    inertia::{self, Composite, LinkInertia},
    layout::{self, Layout},
    parallel::{self, AngleRotation},
    passage::{Arm, Passage},
    regroup,
    rotation::{AxisRotation, ConstantRotation, Turn},
    rounding,
};
use crate::{
    expr::{ExprGraph, Matrix, Purpose, Symmetric, Vector},
    geometry, given,
    id::{BodyId, BodyMap},
    recursive::plan::Plan,
    tree::{Body, Tree},
};

/// A body in axes and with an origin of the recursion's choice.
#[derive(Clone, Debug)]
pub(in crate::recursive) struct Link {
    /// The way to it from its lower link.
    pub(in crate::recursive) passage: Passage,
    /// Inertia about the link's origin, regrouped.
    pub(in crate::recursive) inertia: Composite,
    /// Its second moments `S_aa = (I_bb + I_cc - I_aa) / 2`.
    pub(in crate::recursive) second: Vector,
    layout: Layout,
    /// What its axes turn by where it turns about one axis alone, or would, if they do not follow the joint.
    rotation: Option<AngleRotation>,
    follows: bool,
}

/// A way to a link, turned further by a constant angle.
pub(in crate::recursive) struct Phased {
    /// The way to axes that are turned further.
    pub(in crate::recursive) passage: Passage,
    /// The turn.
    pub(in crate::recursive) turn: AxisRotation,
    /// Rows that were along the link's axes, along these.
    pub(in crate::recursive) axes: Matrix,
}

/// The links of a plan.
pub(in crate::recursive) fn links(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> BodyMap<Link> {
    of_inertias(graph, tree, plan, own_inertia)
}

/// The links of a plan for what moves without forces: their inertias are zero.
pub(in crate::recursive) fn massless(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> BodyMap<Link> {
    of_inertias(graph, tree, plan, |graph, _, _| Composite::zero(graph))
}

/// A body's inertia about the origin of its link.
type OwnInertia = fn(&mut ExprGraph, &Body, &Layout) -> Composite;

fn of_inertias(graph: &mut ExprGraph, tree: &Tree, plan: &Plan, own: OwnInertia) -> BodyMap<Link> {
    graph.begin(Purpose::Joint);
    let layouts = layout::layouts(graph, tree, plan);
    let alone = BodyMap::outward(tree.bodies.len(), |body, _| {
        alone(graph, tree, body, &layouts[body], own)
    });
    let (passages, inertias) = alone.unzip();
    let inertias = regroup::regrouped(graph, tree, plan, &passages, inertias);
    let stays = parallel::unturned(tree, plan, &layouts);
    let links = BodyMap::outward(tree.bodies.len(), |body, links: &BodyMap<Link>| {
        graph.enter(body);
        let below = tree.lower(body).and_then(|lower| links[lower].unturned());
        let joint = &tree.body(body).joint;
        let layout = layouts[body];
        let passage = passages[body].clone();
        let (passage, rotation) = parallel::merged(graph, joint, &layout, passage, below);
        let unturned = rotation.filter(|_| stays[body]);
        let (passage, inertia) = match &unturned {
            None => (passage, inertias[body]),
            Some(rotation) => rotation.left_out(graph, passage, &inertias[body]),
        };
        Link {
            passage,
            inertia: inertia.composite,
            second: inertia.second,
            layout,
            rotation,
            follows: unturned.is_none(),
        }
    });
    name(graph, tree, &links);
    links
}

fn name(graph: &mut ExprGraph, tree: &Tree, links: &BodyMap<Link>) {
    for body in tree.body_ids() {
        graph.enter(body);
        let link = &links[body];
        graph.name_vector(link.passage.offset, "offset");
        graph.name_vector(link.inertia.moment, "moment");
        inertia::name(graph, &link.inertia.inertia, "inertia_o");
    }
}

/// A link as its own joint and mass make it, whatever is on it or below.
fn alone(
    graph: &mut ExprGraph,
    tree: &Tree,
    body: BodyId,
    layout: &Layout,
    own: OwnInertia,
) -> (Passage, LinkInertia) {
    graph.enter(body);
    let arm = Arm::new(graph, &tree.body(body).joint, layout);
    let inertia = own(graph, tree.body(body), layout);
    let passage = Passage::new(graph, tree, body, layout, arm);
    (passage, LinkInertia::new(graph, inertia))
}

fn own_inertia(graph: &mut ExprGraph, body: &Body, layout: &Layout) -> Composite {
    let own = inertia::own(graph, &body.parts);
    let axes = ConstantRotation::new(graph, &geometry::transposed(&layout.axes));
    let mut turned = axes.backward_composite(graph, &own);
    if layout.axes != geometry::IDENTITY {
        turned.moment = rounding::without_crumbs(graph, turned.moment, turned.moment);
    }
    turned.moved(graph, layout.origin)
}

impl Link {
    /// Link components of a vector given by its components along the body's internal axes.
    pub(in crate::recursive) fn of_body(&self, graph: &mut ExprGraph, v: Vector) -> Vector {
        let axes = given::constant(graph, &self.layout.axes);
        let turned = axes.forward(graph, v);
        self.before(graph, turned)
    }

    /// Components along the body's internal axes of a vector given by its link components.
    pub(in crate::recursive) fn to_body(&self, graph: &mut ExprGraph, v: Vector) -> Vector {
        let turned = match self.unturned() {
            None => v,
            Some(unturned) => unturned.forward(graph, v),
        };
        given::constant_back(graph, &self.layout.axes, turned)
    }

    /// The position from the link's origin of a point given from the body's internal one, each along its axes.
    pub(in crate::recursive) fn point_of_body(
        &self,
        graph: &mut ExprGraph,
        position: Vector,
    ) -> Vector {
        let axes = given::constant(graph, &self.layout.axes);
        let turned = axes.forward(graph, position);
        let from_origin = graph.add_vectors(self.layout.origin, turned);
        self.before(graph, from_origin)
    }

    /// A tensor of the body along the link's axes, given along the body's internal ones.
    pub(in crate::recursive) fn tensor_of_body(
        &self,
        graph: &mut ExprGraph,
        tensor: &Symmetric,
    ) -> Symmetric {
        let axes = ConstantRotation::new(graph, &geometry::transposed(&self.layout.axes));
        let turned = axes.backward_symmetric(graph, tensor);
        match self.unturned() {
            None => turned,
            Some(unturned) => unturned.backward_symmetric(graph, &turned),
        }
    }

    /// The way turned further about the joint's axis, so that rows given along the link's axes become sparse; where they are
    /// numbers, and one of them is along that axis.
    pub(in crate::recursive) fn phased(
        &self,
        graph: &mut ExprGraph,
        axes: &Matrix,
    ) -> Option<Phased> {
        let rotation = self.rotation.filter(|_| self.follows)?;
        let (a, (b, c)) = (rotation.axis().index(), rotation.axis().others());
        let mut numbers = [[0.0; 3]; 3];
        for (numbers, row) in numbers.iter_mut().zip(axes) {
            for (number, &entry) in numbers.iter_mut().zip(row) {
                *number = graph.as_number(entry)?;
            }
        }
        // One row is along the axis, the others are across it, and not sparse yet.
        let mut across = numbers.iter().filter(|row| row[a] == 0.0);
        let (Some(across), Some(_), None) = (across.next(), across.next(), across.next()) else {
            return None;
        };
        if [across[b], across[c]].contains(&0.0) {
            return None;
        }
        let phase = libm::atan2(across[c], across[b]);
        let phased = rotation.with_phase(graph, phase);
        let (sine, cosine) = (graph.number(across[c]), graph.number(across[b]));
        let turn = AxisRotation {
            axis: rotation.axis(),
            sine,
            cosine,
        };
        let rows = axes.map(|row| turn.forward(graph, row));
        Some(Phased {
            passage: self.passage.clone().with_rotation(phased),
            turn,
            axes: rows.map(|row| rounding::exact_row(graph, row)),
        })
    }

    fn before(&self, graph: &mut ExprGraph, v: Vector) -> Vector {
        match self.unturned() {
            None => v,
            Some(unturned) => unturned.backward(graph, v),
        }
    }

    /// What its axes would turn by, if they do not follow the joint.
    fn unturned(&self) -> Option<AngleRotation> {
        self.rotation.filter(|_| !self.follows)
    }
}
