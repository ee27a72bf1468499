//! Links: the bodies as the recursion sees them, and the way from a lower link to a link, step by step: an offset, a
//! constant rotation, then rotations about x, y, z.

use super::{
    inertia::{self, Composite},
    layout::{self, Layout},
    parallel,
    plan::{Plan, Technique},
    regroup,
    rotation::{Constant, Rotation, Turn},
    rounding,
};
use crate::{
    expr::{Axis, ExprGraph, Matrix, Vector},
    geometry,
    id::{BodyId, BodyMap},
    kane::{given, orientation},
    tree::{Body, Coordinate, Joint, Motion, Orientation, Tree},
};

/// A body in axes and with an origin of the recursion's choice.
#[derive(Clone, Debug)]
pub struct Link {
    /// From the lower link's origin to the link's, lower-link components.
    pub offset: Vector,
    /// From the lower link's axes to the joint's.
    pub constant: Constant,
    /// How the link is turned from the joint's axes.
    pub turning: Turning,
    /// Inertia about the link's origin, regrouped.
    pub inertia: Composite,
    /// Its second moments `S_aa = (I_bb + I_cc - I_aa) / 2`.
    pub second: Vector,
    pub(super) layout: Layout,
    /// The rotation of the joint, if the link's axes do not follow it.
    pub(super) unturned: Option<Rotation>,
}

/// How a link is turned from its joint's axes in the lower link.
#[derive(Clone, Debug)]
pub enum Turning {
    /// By the 1-2-3 body-fixed rotations, in order; each may have a coordinate that moves.
    Angles([Rotation; 3]),
    /// By a matrix.
    Matrix(Matrix),
}

/// The links of a plan.
pub fn links(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> BodyMap<Link> {
    let layouts = layout::layouts(graph, tree, plan);
    let mut links = BodyMap::outward(tree.bodies.len(), |body, _| {
        link(graph, tree, body, &layouts[body])
    });
    regroup::run(graph, tree, plan, &mut links);
    parallel::run(graph, tree, plan, &mut links);
    for body in tree.body_ids() {
        graph.enter(body);
        let link = &links[body];
        graph.name_vector(link.offset, "offset");
        graph.name_vector(link.inertia.moment, "moment");
        inertia::name(graph, &link.inertia.inertia, "inertia_o");
    }
    links
}

fn link(graph: &mut ExprGraph, tree: &Tree, body: BodyId, layout: &Layout) -> Link {
    graph.enter(body);
    let joint = &tree.body(body).joint;
    let constant = Constant::new(graph, &layout.constant);
    let translation = joint.translations.map(|s| given::coordinate(graph, s));
    let translation = constant.backward(graph, translation);
    let offset = graph.add_vectors(layout.attachment, translation);
    let inertia = own_inertia(graph, tree.body(body), layout);
    Link {
        offset,
        constant,
        turning: turning(graph, tree, joint, layout.phase),
        inertia,
        second: inertia.second_moments(graph),
        layout: *layout,
        unturned: None,
    }
}

fn turning(graph: &mut ExprGraph, tree: &Tree, joint: &Joint, phase: f64) -> Turning {
    let Some(angles) = joint.angles() else {
        let matrix = orientation::of_joint(graph, tree, joint);
        graph.name_matrix(&matrix, "rel");
        return Turning::Matrix(matrix);
    };
    let rates = match joint.orientation {
        Orientation::Rates(_) => joint.turns(),
        Orientation::AngularVelocity { .. } => [None; 3],
    };
    let trigonometry = orientation::trigonometry(graph, tree, angles);
    Turning::Angles(Axis::ALL.map(|axis| {
        let place = axis.index();
        let (mut sine, mut cosine) = (trigonometry.sines[place], trigonometry.cosines[place]);
        if phase != 0.0 && !matches!(angles[place], Coordinate::Locked(_)) {
            let angle = given::coordinate(graph, angles[place]);
            (sine, cosine) = rounding::phased(graph, angle, phase);
            graph.name(sine, format!("sin{}", place + 1));
            graph.name(cosine, format!("cos{}", place + 1));
        }
        Rotation {
            axis,
            motion: rates[place],
            sine,
            cosine,
        }
    }))
}

fn own_inertia(graph: &mut ExprGraph, body: &Body, layout: &Layout) -> Composite {
    let own = inertia::own(graph, body);
    let axes = Constant::new(graph, &geometry::transposed(&layout.axes));
    let mut turned = axes.backward_composite(graph, &own);
    if layout.axes != geometry::IDENTITY {
        turned.moment = rounding::without_crumbs(graph, turned.moment, turned.moment);
    }
    turned.moved(graph, layout.origin)
}

/// The bodies that need not turn: all axes on them are parallel to their own.
pub fn parallel_axes(tree: &Tree, plan: &Plan) -> Vec<BodyId> {
    let mut graph = ExprGraph::default();
    let links = links(&mut graph, tree, &plan.with(Technique::Parallel, false));
    let mut is_parallel = |body: &BodyId| {
        let axis = tree.body(*body).joint.turning_axis();
        axis.is_some_and(|axis| {
            parallel::carries_parallel_axes(&mut graph, tree, *body, axis, &links)
        })
    };
    tree.body_ids().filter(|body| is_parallel(body)).collect()
}

/// For every body whether some of its ten inertial parameters are zero, along its own axes.
pub fn sparse_inertias(tree: &Tree) -> BodyMap<bool> {
    let mut graph = ExprGraph::default();
    BodyMap::outward(tree.bodies.len(), |body, _| {
        let own = inertia::own(&mut graph, tree.body(body));
        let numbers = [own.moment, own.inertia.diagonal, own.inertia.mixed];
        let mut numbers = numbers.into_iter().flatten();
        numbers.any(|number| graph.is_zero(number))
    })
}

/// The motions of a joint that are components of its angular velocity: they enter in the body's axes, all at once.
pub fn angular_velocity(joint: &Joint) -> Option<[Motion; 3]> {
    match joint.orientation {
        Orientation::Rates(_) => None,
        Orientation::AngularVelocity { speeds, .. } => {
            Some(speeds.map(|speed| Motion { speed, factor: 1.0 }))
        }
    }
}

impl Link {
    /// Sets the inertia, and the second moments with it.
    pub(super) fn set_inertia(&mut self, graph: &mut ExprGraph, inertia: Composite) {
        self.second = inertia.second_moments(graph);
        self.inertia = inertia;
    }

    /// Link components of a vector given by its components along the body's internal axes.
    pub fn of_body(&self, graph: &mut ExprGraph, v: Vector) -> Vector {
        let axes = given::constant(graph, &self.layout.axes);
        let turned = axes.forward(graph, v);
        self.unturned(graph, turned)
    }

    /// The position from the link's origin of a point given from the body's internal one, each along its axes.
    pub fn point_of_body(&self, graph: &mut ExprGraph, position: Vector) -> Vector {
        let axes = given::constant(graph, &self.layout.axes);
        let turned = axes.forward(graph, position);
        let from_origin = graph.add_vectors(self.layout.origin, turned);
        self.unturned(graph, from_origin)
    }

    fn unturned(&self, graph: &mut ExprGraph, v: Vector) -> Vector {
        match &self.unturned {
            None => v,
            Some(rotation) => rotation.backward(graph, v),
        }
    }

    /// Components along the link's axes of a vector given along the joint's.
    pub fn forward(&self, graph: &mut ExprGraph, v: Vector) -> Vector {
        match &self.turning {
            Turning::Matrix(matrix) => matrix.forward(graph, v),
            Turning::Angles(rotations) => rotations
                .iter()
                .fold(v, |v, rotation| rotation.forward(graph, v)),
        }
    }

    /// Components along the joint's axes of a vector given along the link's.
    pub fn backward(&self, graph: &mut ExprGraph, v: Vector) -> Vector {
        match &self.turning {
            Turning::Matrix(matrix) => matrix.backward(graph, v),
            Turning::Angles(rotations) => rotations
                .iter()
                .rev()
                .fold(v, |v, rotation| rotation.backward(graph, v)),
        }
    }
}
