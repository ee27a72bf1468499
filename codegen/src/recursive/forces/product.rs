//! The mass matrix times accelerations: motion outward and wrenches inward, as inverse dynamics, of a system at rest without
//! weight.

use super::inverse_dynamics;
use crate::{
    expr::{Expr, ExprGraph, Purpose, Vector},
    given::Accelerations,
    id::{BodyId, BodyMap},
    recursive::{
        links::{
            linkage::Linkage,
            passage::{Drive, Passenger, speed_rates},
            rotation::Turn,
            wrench::Wrench,
        },
        plan::Plan,
    },
    tree::{Motion, Tree},
};

/// `A y_dot`, Eq. (42) without rotors.
pub fn mass_matrix_product(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Vec<Expr> {
    let linkage = Linkage::of_speeds(graph, tree, plan);
    let wrenches = needed(graph, &linkage, Accelerations::Given);
    inverse_dynamics::project(graph, &linkage, wrenches)
}

/// The wrench that each link needs for these accelerations, about its origin.
pub(in crate::recursive) fn needed(
    graph: &mut ExprGraph,
    linkage: &Linkage<'_>,
    accelerations: Accelerations<'_>,
) -> BodyMap<Wrench> {
    let tree = linkage.tree;
    graph.begin(Purpose::Accelerations);
    let starts = BodyMap::outward(tree.bodies.len(), |body, starts: &BodyMap<[Vector; 2]>| {
        graph.enter(body);
        let still = graph.zero_vector();
        let below = tree.lower(body).map(|lower| starts[lower]);
        let [alpha, a] = below.unwrap_or([still; 2]);
        let mut starting = Starting {
            alpha,
            a,
            accelerations,
        };
        linkage.passages[body].outward(graph, &mut starting);
        let Starting { alpha, a, .. } = starting;
        graph.name_vector(alpha, "alpha");
        graph.name_vector(a, "a");
        [alpha, a]
    });
    graph.begin(Purpose::Needed);
    BodyMap::outward(tree.bodies.len(), |body, _| {
        graph.enter(body);
        let [alpha, a] = starts[body];
        Wrench::of_inertia(graph, &linkage.links[body].inertia, a, alpha)
    })
}

/// The acceleration of a link that is at rest, on its way outward through a joint: angular, and of the origin.
#[derive(Clone, Copy, Debug)]
struct Starting<'a> {
    alpha: Vector,
    a: Vector,
    accelerations: Accelerations<'a>,
}

impl Passenger for Starting<'_> {
    fn shift(&mut self, graph: &mut ExprGraph, _: BodyId, offset: Vector) {
        let swept = graph.cross(self.alpha, offset);
        self.a = graph.add_vectors(self.a, swept);
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive) {
        [self.alpha, self.a] = [self.alpha, self.a].map(|v| rotation.forward(graph, v));
        let own = speed_rates(graph, drive.motions(), self.accelerations);
        self.alpha = graph.add_vectors(self.alpha, own);
    }

    fn along(&mut self, graph: &mut ExprGraph, motions: [Option<Motion>; 3]) {
        let own = speed_rates(graph, motions, self.accelerations);
        self.a = graph.add_vectors(self.a, own);
    }
}
