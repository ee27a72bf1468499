//! Energies body by body, on links that keep all their inertia: what a joint does not move of a link is not given to its lower
//! link here, for then the sum alone would be right.

use crate::{
    expr::{Expr, ExprGraph, Purpose, Vector},
    given::{self, mechanics},
    id::{BodyId, BodyMap},
    recursive::{
        forces::weight::{Field, Weight},
        links::{
            link::{self, Link},
            link_velocity,
            passage::{Drive, Passenger},
            rotation::Turn,
        },
        plan::Plan,
        technique::Technique,
    },
    tree::{Motion, Tree},
};

/// `1/2 (m_K v_G_K · v_G_K + w_K · I_K w_K)` and that of the rotors of its joint, J, of each body.
pub fn kinetic_by_body(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> BodyMap<Expr> {
    let links = link::links(graph, tree, &whole(plan));
    graph.begin(Purpose::Outward);
    let velocities = link_velocity::velocities(graph, tree, &links);
    graph.begin(Purpose::Energy);
    BodyMap::outward(tree.bodies.len(), |body, _| {
        graph.enter(body);
        let (link, velocity) = (&links[body], velocities[body]);
        let mass = given::mass(graph, tree.body(body));
        let center = given::mass_center(graph, tree.body(body));
        let center = link.point_of_body(graph, center);
        let swept = graph.cross(velocity.angular, center);
        let v = graph.add_vectors(velocity.linear, swept);
        let square = graph.dot(v, v);
        let translational = graph.mul(mass, square);
        let inertia = given::inertia(graph, tree.body(body));
        let inertia = link.tensor_of_body(graph, &inertia);
        let momentum = graph.mul_symmetric(&inertia, velocity.angular);
        let turning = graph.dot(velocity.angular, momentum);
        let twice = graph.add(translational, turning);
        let of_rotors = mechanics::twice_kinetic_of(graph, tree, body);
        let twice = graph.add(twice, of_rotors);
        let half = graph.number(0.5);
        graph.mul(half, twice)
    })
}

/// `-m_K g · p_G_K` less what is lifted of it, zero at the inertial origin, and that of the springs of its joint, J, of each body.
pub fn potential_by_body(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> BodyMap<Expr> {
    let links = link::links(graph, tree, &whole(plan));
    let field = Field::of_masses(graph, tree);
    graph.begin(Purpose::Energy);
    let gravity = given::acting_gravity(graph, tree);
    let depths = BodyMap::outward(tree.bodies.len(), |body, depths: &BodyMap<Depth>| {
        graph.enter(body);
        let depth = match tree.lower(body) {
            Some(lower) => depths[lower].carried(graph, &links[body]),
            None => Depth::of_root(graph, tree, &links[body], body, gravity),
        };
        graph.name(depth.of_origin, "depth");
        graph.name_vector(depth.gravity, "g");
        depth
    });
    BodyMap::outward(tree.bodies.len(), |body, _| {
        graph.enter(body);
        let Depth { of_origin, gravity } = depths[body];
        let weight = Weight::left(graph, tree, &field, &links[body], body);
        let at_origin = graph.mul(weight.mass, of_origin);
        let from_there = graph.dot(gravity, weight.moment);
        let of_weight = -graph.add(at_origin, from_there);
        let twice = mechanics::twice_potential_of(graph, tree, body);
        let half = graph.number(0.5);
        let of_springs = graph.mul(half, twice);
        graph.add(of_weight, of_springs)
    })
}

/// The plan, with all inertia where it is.
fn whole(plan: &Plan) -> Plan {
    plan.with(Technique::Regroup, false)
}

/// How far a link is down along gravity from the inertial origin, times gravity.
#[derive(Clone, Copy, Debug)]
struct Depth {
    of_origin: Expr,
    /// Gravity, along the axes that have been reached.
    gravity: Vector,
}

impl Depth {
    /// That of a link on the inertial frame, whose origin may stand elsewhere on its axis than its body's.
    fn of_root(
        graph: &mut ExprGraph,
        tree: &Tree,
        link: &Link,
        body: BodyId,
        gravity: Vector,
    ) -> Self {
        let offset = given::offset(graph, tree.body(body));
        let of_origin = graph.dot(gravity, offset);
        let mut depth = Self { of_origin, gravity }.carried(graph, link);
        let zero = graph.zero_vector();
        let own = link.point_of_body(graph, zero);
        let beyond = graph.dot(depth.gravity, own);
        depth.of_origin = graph.sub(depth.of_origin, beyond);
        depth
    }

    fn carried(mut self, graph: &mut ExprGraph, link: &Link) -> Self {
        link.passage.outward(graph, &mut self);
        self
    }
}

impl Passenger for Depth {
    fn shift(&mut self, graph: &mut ExprGraph, _: BodyId, offset: Vector) {
        let down = graph.dot(self.gravity, offset);
        self.of_origin = graph.add(self.of_origin, down);
    }

    fn turn(&mut self, graph: &mut ExprGraph, rotation: &dyn Turn, _: Drive) {
        self.gravity = rotation.forward(graph, self.gravity);
    }

    fn along(&mut self, _: &mut ExprGraph, _: [Option<Motion>; 3]) {}
}
