//! Angular velocities, their partials and derivatives, Eqs. (8)-(20).

use crate::{
    expr::{Expr, ExprGraph, Input, Matrix, Purpose, Vector, negated},
    given::{
        self, Accelerations,
        orientation::{self, trigonometry},
    },
    id::{BodyId, BodyMap, CoordinateId},
    partition::{Block, Partition, Row},
    tree::{ChartCoordinates, Coordinate, Orientation, Tree},
};

/// `P_K`, Eq. (17): speeds of rotation to relative angular velocity, body components; where these are the speeds, the
/// identity.
pub fn rate_matrix(graph: &mut ExprGraph, tree: &Tree, body: BodyId) -> Block {
    let Some(angles) = tree.body(body).joint.angles_with_rates() else {
        return Block::Identity;
    };
    let t = trigonometry(graph, tree, angles);
    let (s3, c2, c3) = (t.sines[2], t.cosines[1], t.cosines[2]);
    let (zero, one) = (graph.zero(), graph.one());
    Block::Full([
        [graph.mul(c2, c3), s3, zero],
        [graph.mul(-c2, s3), c3, zero],
        [t.sines[1], zero, one],
    ])
}

/// `P_dot_K`, the time derivative of Eq. (17); zero where the speeds are the relative angular velocity.
pub fn rate_matrix_dot(graph: &mut ExprGraph, tree: &Tree, body: BodyId) -> Matrix {
    let joint = &tree.body(body).joint;
    let zero = graph.zero();
    let Some(angles) = joint.angles_with_rates() else {
        return [[zero; 3]; 3];
    };
    let t = trigonometry(graph, tree, angles);
    let ([_, s2, s3], [_, c2, c3]) = (t.sines, t.cosines);
    let turns = joint.turns();
    let (d2, d3) = (given::speed(graph, turns[1]), given::speed(graph, turns[2]));
    let (s2_dot, c2_dot) = (graph.mul(c2, d2), graph.mul(-s2, d2));
    let (s3_dot, c3_dot) = (graph.mul(c3, d3), graph.mul(-s3, d3));
    let mut derivative = |c2_dot, c3, c2, c3_dot| {
        let (a, b) = (graph.mul(c2_dot, c3), graph.mul(c2, c3_dot));
        graph.add(a, b)
    };
    let xx = derivative(c2_dot, c3, c2, c3_dot);
    let yx = -derivative(c2_dot, s3, c2, s3_dot);
    [[xx, s3_dot, zero], [yx, c3_dot, zero], [s2_dot, zero, zero]]
}

/// `w_rel_K = P_K theta_dot_K`, Eq. (8), body components, for every body.
pub fn relative_velocity(graph: &mut ExprGraph, tree: &Tree) -> BodyMap<Vector> {
    graph.begin(Purpose::AngularVelocity);
    BodyMap::outward(tree.bodies.len(), |body, _| {
        relative_velocity_of(graph, tree, body)
    })
}

/// The same of one body.
pub fn relative_velocity_of(graph: &mut ExprGraph, tree: &Tree, body: BodyId) -> Vector {
    graph.enter(body);
    let p = rate_matrix(graph, tree, body).matrix(graph);
    let turns = tree.body(body).joint.turns();
    let speeds = turns.map(|turn| given::speed(graph, turn));
    let w_rel = graph.mul_vector(&p, speeds);
    graph.name_vector(w_rel, "w_rel");
    w_rel
}

/// The rates of the angles from a given relative angular velocity, Eq. (9), for bodies whose three angles are free.
///
/// Zero for the others. Singular at `cos(theta_2) = 0`.
pub fn angle_rates(graph: &mut ExprGraph, tree: &Tree) -> BodyMap<Vector> {
    graph.begin(Purpose::Rates);
    BodyMap::outward(tree.bodies.len(), |body, _| {
        graph.enter(body);
        let joint = &tree.body(body).joint;
        match joint.angles() {
            Some(angles) if angles.iter().all(|angle| angle.is_free()) => {
                let w_rel = given::relative_angular_velocity(graph, tree, body);
                orientation::rates(graph, tree, angles, w_rel)
            }
            _ => graph.zero_vector(),
        }
    })
}

/// The rates of Euler parameters: half of Hamilton's product with `(0, w)`, body components.
pub fn parameter_rates(graph: &mut ExprGraph, e: [CoordinateId; 4], w: Vector) -> [Expr; 4] {
    let [e0, e1, e2, e3] = e.map(|parameter| graph.input(Input::Q(parameter)));
    let half = graph.number(0.5);
    let [w1, w2, w3] = graph.scale(half, w);
    let scalar = graph.dot([e1, e2, e3], [w1, w2, w3]);
    let along = graph.scale(e0, [w1, w2, w3]);
    let across = graph.cross([e1, e2, e3], [w1, w2, w3]);
    let [x, y, z] = graph.add_vectors(along, across);
    [-scalar, x, y, z]
}

/// The rates of all coordinates, Eqs. (44), (9), or those of Euler parameters.
pub fn coordinate_rates(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    graph.begin(Purpose::Rates);
    let mut rates = vec![graph.zero(); tree.n_coordinates];
    let mut set = |coordinate: CoordinateId, rate| rates[coordinate.index()] = rate;
    for body in tree.body_ids() {
        graph.enter(body);
        let joint = &tree.body(body).joint;
        let mut plain = 0..6;
        if let Orientation::AngularVelocity { chart, speeds } = joint.orientation {
            plain = 3..6;
            let w = speeds.map(|speed| graph.input(Input::U(speed)));
            match chart {
                ChartCoordinates::EulerParameters(e) => {
                    let own = parameter_rates(graph, e, w);
                    e.into_iter().zip(own).for_each(|(e, rate)| set(e, rate));
                }
                ChartCoordinates::Angles(places) => {
                    let angles = joint.angles().expect("tree: the chart has angles");
                    let own = orientation::rates(graph, tree, angles, w);
                    places
                        .into_iter()
                        .zip(own)
                        .for_each(|(place, rate)| set(place, rate));
                }
            }
        }
        for motion in plain {
            if let Some(Coordinate::Free { coordinate, speed }) = joint.coordinate_of(motion) {
                set(coordinate, graph.input(Input::U(speed)));
            }
        }
    }
    rates
}

/// `w_K = JR_K w_J + w_rel_K`, Eq. (11), body components, for every body.
pub fn velocity(
    graph: &mut ExprGraph,
    tree: &Tree,
    relative: &BodyMap<Matrix>,
    w_rel: &BodyMap<Vector>,
) -> BodyMap<Vector> {
    graph.begin(Purpose::AngularVelocity);
    BodyMap::outward(tree.bodies.len(), |body, w| {
        graph.enter(body);
        let Some(lower) = tree.lower(body) else {
            return w_rel[body];
        };
        let carried = graph.mul_vector(&relative[body], w[lower]);
        let sum = graph.add_vectors(carried, w_rel[body]);
        graph.name_vector(sum, "w");
        sum
    })
}

/// `W_K = JR_K W_J + [0 .. P_K .. 0]`, Eqs. (15), (16), for every body.
pub fn partial(graph: &mut ExprGraph, tree: &Tree, relative: &BodyMap<Matrix>) -> BodyMap<Row> {
    graph.begin(Purpose::PartialVelocity);
    BodyMap::outward(tree.bodies.len(), |body, rows: &BodyMap<Row>| {
        graph.enter(body);
        let own = rate_matrix(graph, tree, body);
        let own = Row::single(tree, Partition::Angles(body), own);
        let row = match tree.lower(body) {
            None => own,
            Some(lower) => rows[lower]
                .premultiplied(graph, &relative[body])
                .plus(graph, own),
        };
        row.name(graph, tree, "w");
        row
    })
}

/// `W_dot_K = JR_K W_dot_J + tilde(w_rel_K)^T JR_K W_J + [0 .. P_dot_K .. 0]`, Eq. (20), for every body.
pub fn partial_dot(
    graph: &mut ExprGraph,
    tree: &Tree,
    relative: &BodyMap<Matrix>,
    w_rel: &BodyMap<Vector>,
    partial: &BodyMap<Row>,
) -> BodyMap<Row> {
    graph.begin(Purpose::PartialVelocityDot);
    BodyMap::outward(tree.bodies.len(), |body, rows: &BodyMap<Row>| {
        graph.enter(body);
        let own = rate_matrix_dot(graph, tree, body);
        let own = Row::single(tree, Partition::Angles(body), Block::Full(own));
        let row = match tree.lower(body) {
            None => own,
            Some(lower) => {
                let carried = rows[lower].premultiplied(graph, &relative[body]);
                let turned = partial[lower]
                    .premultiplied(graph, &relative[body])
                    .crossed(graph, w_rel[body]);
                carried.plus(graph, turned).plus(graph, own)
            }
        };
        row.name(graph, tree, "w_dot");
        row
    })
}

/// `alpha_K = W_K y_dot + W_dot_K y`, below Eq. (19), body components, for every body.
///
/// Eqs. (15) and (20) are multiplied by `y_dot` and `y` before they recur, so that no matrix is built.
pub fn acceleration(
    graph: &mut ExprGraph,
    tree: &Tree,
    relative: &BodyMap<Matrix>,
    w_rel: &BodyMap<Vector>,
    w: &BodyMap<Vector>,
    accelerations: Accelerations<'_>,
) -> BodyMap<Vector> {
    graph.begin(Purpose::Acceleration);
    BodyMap::outward(tree.bodies.len(), |body, alpha| {
        graph.enter(body);
        let turns = tree.body(body).joint.turns();
        let (p, p_dot) = (
            rate_matrix(graph, tree, body).matrix(graph),
            rate_matrix_dot(graph, tree, body),
        );
        let rates = turns.map(|turn| given::speed(graph, turn));
        let second = turns.map(|turn| given::acceleration(graph, turn, accelerations));
        let own = graph.mul_vector(&p, second);
        let own_dot = graph.mul_vector(&p_dot, rates);
        let mut sum = graph.add_vectors(own_dot, own);
        if let Some(lower) = tree.lower(body) {
            let carried = graph.mul_vector(&relative[body], alpha[lower]);
            let w_lower = graph.mul_vector(&relative[body], w[lower]);
            let turned = graph.cross(w_rel[body], w_lower);
            let moved = graph.add_vectors(carried, negated(turned));
            sum = graph.add_vectors(moved, sum);
        }
        graph.name_vector(sum, "alpha");
        sum
    })
}
