//! How links stand in the inertial frame, for what goes there at once.

use crate::{
    expr::{Expr, ExprGraph, Matrix, Purpose, Vector, transpose},
    given,
    id::{BodyId, BodyMap},
    recursive::{
        links::{
            linkage::Linkage,
            passage::{Drive, Passenger},
            root,
            rotation::Turn,
        },
        plan::Plan,
        technique::Technique,
    },
    tree::Motion,
};

/// How many columns a link has to carry for a matrix of its own to inertial axes; `None` where the plan lets none leave. The matrix costs
/// 18 operations, three vectors turned by the link's joint, and saves that turn, 6 a vector, of each column; of sparse columns part of it
/// is not needed.
fn many(plan: &Plan) -> Option<usize> {
    let many = if plan.uses(Technique::Levers) { 2 } else { 3 };
    plan.uses(Technique::Shortcut).then_some(many)
}

/// How axes stand in the inertial frame.
#[derive(Clone, Copy, Debug)]
pub(in crate::recursive) struct Stand {
    /// Inertial components to those along the axes, times the factor.
    rotation: Matrix,
    has_factor: bool,
    /// The point that momenta are to be about, from the origin that has been reached.
    point: Vector,
}

impl Stand {
    /// From the point to an origin that lies at `offset`.
    pub(in crate::recursive) fn lever(&self, graph: &mut ExprGraph, offset: Vector) -> Vector {
        graph.sub_vectors(offset, self.point)
    }

    /// The rotation from inertial axes, times the factor.
    pub(in crate::recursive) fn rotation(&self) -> &Matrix {
        &self.rotation
    }

    /// The scope in which what belongs to a body is turned: products with a factor of all bodies belong to all.
    pub(in crate::recursive) fn scope(&self, body: BodyId) -> Option<BodyId> {
        (!self.has_factor).then_some(body)
    }

    fn at_root(self, graph: &mut ExprGraph, linkage: &Linkage<'_>, body: BodyId) -> Self {
        let origin = root::from_first(graph, linkage.tree, &linkage.links, body);
        graph.enter(None);
        Self {
            point: graph.sub_vectors(self.point, origin),
            ..self
        }
    }
}

impl Passenger for Stand {
    fn shift(&mut self, graph: &mut ExprGraph, _: BodyId, offset: Vector) {
        self.point = graph.sub_vectors(self.point, offset);
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, _: Drive) {
        self.rotation = turned(graph, &self.rotation, rotation);
        self.point = rotation.forward(graph, self.point);
    }

    fn along(&mut self, _: &mut ExprGraph, _: [Option<Motion>; 3]) {}
}

/// The rotation from inertial axes to those after another turn.
pub(super) fn turned(graph: &mut ExprGraph, to_axes: &Matrix, rotation: &dyn Turn) -> Matrix {
    // An inertial axis along the axes is a column.
    let columns = transpose(to_axes);
    transpose(&columns.map(|axis| rotation.forward(graph, axis)))
}

/// About which point columns are to be in the end.
#[derive(Clone, Copy, Debug)]
pub(in crate::recursive) enum Reference {
    /// Momenta about the mass centre, which is given from the origin of the first link on the inertial frame.
    Center(Vector),
    /// Momenta about the inertial origin.
    Origin,
    /// Linear momenta times a factor; no point matters.
    Times(Expr),
}

/// The inertial frame itself, and links that carry many columns, where the plan has these go to inertial axes at once.
pub(in crate::recursive) struct Stands {
    pub(in crate::recursive) links: BodyMap<Option<Stand>>,
    /// About the origin of each link on the inertial frame.
    inertial: Stand,
    /// True where the momentum of all bodies shifted as one has no moment, or none that is read.
    pub(super) ignores_shifts: bool,
}

impl Stands {
    /// As the plan of the links has it.
    pub(in crate::recursive) fn new(
        graph: &mut ExprGraph,
        linkage: &Linkage<'_>,
        wanted: Reference,
    ) -> Self {
        let Linkage {
            tree, links, plan, ..
        } = linkage;
        let axes = graph.identity();
        let about = |point| Stand {
            rotation: axes,
            has_factor: false,
            point,
        };
        let inertial = match wanted {
            Reference::Center(center) => about(center),
            Reference::Origin => {
                let first = root::origin(graph, tree, &links[BodyId::new(0)], BodyId::new(0));
                about(first.map(|entry| -entry))
            }
            Reference::Times(factor) => Stand {
                rotation: axes.map(|axis| graph.scale(factor, axis)),
                has_factor: graph.as_number(factor) != Some(1.0),
                point: graph.zero_vector(),
            },
        };
        graph.begin(Purpose::Outward);
        let (many, carried) = (many(plan), carried(linkage));
        let links = BodyMap::outward(
            tree.bodies.len(),
            |body, stands: &BodyMap<Option<Stand>>| {
                if many.is_none_or(|many| carried[body] < many) {
                    return None;
                }
                let mut stand = match tree.lower(body) {
                    Some(lower) => stands[lower].expect("stands: a lower link carries more"),
                    None => inertial.at_root(graph, linkage, body),
                };
                graph.enter(body);
                links[body].passage.outward(graph, &mut stand);
                graph.name_matrix(&stand.rotation, "rot");
                graph.name_vector(stand.point, "to_point");
                Some(stand)
            },
        );
        Self {
            links,
            inertial,
            ignores_shifts: !matches!(wanted, Reference::Origin),
        }
    }

    /// The inertial frame, where a link on it has its origin.
    pub(in crate::recursive) fn at_root(
        &self,
        graph: &mut ExprGraph,
        linkage: &Linkage<'_>,
        body: BodyId,
    ) -> Stand {
        self.inertial.at_root(graph, linkage, body)
    }
}

/// The factors by which linear momenta become partial velocities of the mass centre, the first on the way to inertial axes, the last there;
/// `None` where no body has mass. A changed mass is to change nothing of bodies that are not on its path.
pub(in crate::recursive) fn by_mass(
    graph: &mut ExprGraph,
    linkage: &Linkage<'_>,
) -> Option<[Expr; 2]> {
    let by_mass = given::inverse_total_mass(graph, linkage.tree)?;
    Some(if stay_apart(graph, linkage) {
        [by_mass, graph.one()]
    } else {
        [graph.one(), by_mass]
    })
}

/// True where constant rotations have no entries but 0, 1 and -1: with others, a factor of all bodies would be folded into numbers of one.
fn stay_apart(graph: &mut ExprGraph, linkage: &Linkage<'_>) -> bool {
    let Linkage { tree, links, .. } = linkage;
    graph.begin(Purpose::Outward);
    tree.body_ids().all(|body| {
        let mut kept = Kept { all: true };
        graph.enter(body);
        links[body].passage.outward(graph, &mut kept);
        kept.all
    })
}

/// Whether rotations have no constant entries but 0, 1 and -1.
struct Kept {
    all: bool,
}

impl Passenger for Kept {
    fn shift(&mut self, _: &mut ExprGraph, _: BodyId, _: Vector) {}

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, _: Drive) {
        let axes = graph.identity().map(|axis| rotation.forward(graph, axis));
        let numbers = axes
            .iter()
            .flatten()
            .filter_map(|entry| graph.as_number(*entry));
        self.all &= numbers
            .into_iter()
            .all(|entry| [0.0, 1.0, -1.0].contains(&entry));
    }

    fn along(&mut self, _: &mut ExprGraph, _: [Option<Motion>; 3]) {}
}

/// How many columns each link carries, beside its own.
fn carried(linkage: &Linkage<'_>) -> BodyMap<usize> {
    let tree = linkage.tree;
    let mut carried = BodyMap::outward(tree.bodies.len(), |_, _| 0);
    for body in tree.body_ids().rev() {
        if let Some(lower) = tree.lower(body) {
            let motions = tree.body(body).joint.motions();
            let own = motions.into_iter().flatten().count();
            carried[lower] += own + carried[body];
        }
    }
    carried
}
