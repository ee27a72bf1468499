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
    graph.begin(Purpose::Accelerations);
    let starts = BodyMap::outward(tree.bodies.len(), |body, starts: &BodyMap<Starting>| {
        graph.enter(body);
        let still = graph.zero_vector();
        let below = tree.lower(body).map(|lower| starts[lower]);
        let mut starting = below.unwrap_or(Starting {
            alpha: still,
            a: still,
        });
        linkage.passages[body].outward(graph, &mut starting);
        graph.name_vector(starting.alpha, "alpha");
        graph.name_vector(starting.a, "a");
        starting
    });
    graph.begin(Purpose::Needed);
    let wrenches = BodyMap::outward(tree.bodies.len(), |body, _| {
        graph.enter(body);
        let Starting { alpha, a } = starts[body];
        Wrench::of_inertia(graph, &linkage.links[body].inertia, a, alpha)
    });
    inverse_dynamics::project(graph, &linkage, wrenches)
}

/// The acceleration of a link that is at rest, on its way outward through a joint: angular, and of the origin.
#[derive(Clone, Copy, Debug)]
struct Starting {
    alpha: Vector,
    a: Vector,
}

impl Passenger for Starting {
    fn shift(&mut self, graph: &mut ExprGraph, _: BodyId, offset: Vector) {
        let swept = graph.cross(self.alpha, offset);
        self.a = graph.add_vectors(self.a, swept);
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, drive: Drive) {
        [self.alpha, self.a] = [self.alpha, self.a].map(|v| rotation.forward(graph, v));
        let own = speed_rates(graph, drive.motions(), Accelerations::Given);
        self.alpha = graph.add_vectors(self.alpha, own);
    }

    fn along(&mut self, graph: &mut ExprGraph, motions: [Option<Motion>; 3]) {
        let own = speed_rates(graph, motions, Accelerations::Given);
        self.a = graph.add_vectors(self.a, own);
    }
}
