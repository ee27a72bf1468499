//! The mass centre of all bodies, how it moves, and momentum about it: sums over bodies, inertial components.

use super::{dynamics, energy, orientation, position, velocity};
use crate::{
    expr::{Expr, ExprGraph, Matrix, Purpose, Vector, transpose},
    given::{self, Accelerations},
    id::{BodyMap, SpeedId},
    tree::Tree,
};

/// Linear and angular momentum, or their rates: inertial components, about the mass centre of all bodies.
#[derive(Clone, Copy, Debug)]
pub struct Momentum {
    /// Linear.
    pub linear: Vector,
    /// Angular.
    pub angular: Vector,
}

/// `sum_K m_K p_G_K / sum_K m_K`, from the inertial origin; the origin itself where no body has mass.
pub fn position(graph: &mut ExprGraph, tree: &Tree) -> Vector {
    let relative = orientation::relative(graph, tree);
    let origins = position::origin(graph, tree, &relative);
    let centers = position::mass_center(graph, tree, &origins);
    let moments = BodyMap::outward(tree.bodies.len(), |body, _| {
        graph.enter(body);
        let mass = given::mass(graph, tree.body(body));
        graph.scale(mass, centers[body])
    });
    let moment = energy::gather_vectors(graph, tree, &relative, moments);
    given::over_total_mass(graph, tree, moment)
}

/// `sum_K m_K v_G_K / sum_K m_K`; zero where no body has mass.
pub fn velocity(graph: &mut ExprGraph, tree: &Tree) -> Vector {
    let momentum = energy::linear_momentum(graph, tree);
    given::over_total_mass(graph, tree, momentum)
}

/// The partial velocities of the mass centre, one a speed.
pub fn jacobian(graph: &mut ExprGraph, tree: &Tree) -> Vec<Vector> {
    let matrix = momentum_matrix(graph, tree);
    let columns = matrix.into_iter();
    columns
        .map(|column| given::over_total_mass(graph, tree, column.linear))
        .collect()
}

/// The acceleration of the mass centre for `y_dot = 0`: `sum_K R_K^T m_K a_G_K / sum_K m_K`.
pub fn jacobian_dot_u(graph: &mut ExprGraph, tree: &Tree) -> Vector {
    let rates = momentum_matrix_dot_u(graph, tree);
    given::over_total_mass(graph, tree, rates.linear)
}

/// `sum_K R_K^T m_K V_G_K` and `sum_K R_K^T I_K W_K + (p_G_K - p) × R_K^T m_K V_G_K`, one column a speed.
pub fn momentum_matrix(graph: &mut ExprGraph, tree: &Tree) -> Vec<Momentum> {
    momentum_columns(graph, tree, position)
}

/// The columns of the angular momentum about the inertial origin: the same with `p = 0`.
pub fn angular_about_origin(graph: &mut ExprGraph, tree: &Tree) -> Vec<Vector> {
    let columns = momentum_columns(graph, tree, |graph, _| graph.zero_vector());
    columns.into_iter().map(|column| column.angular).collect()
}

/// Momenta for a unit of each speed, about this point.
fn momentum_columns(
    graph: &mut ExprGraph,
    tree: &Tree,
    about: fn(&mut ExprGraph, &Tree) -> Vector,
) -> Vec<Momentum> {
    let relative = orientation::relative(graph, tree);
    let partials = velocity::partials(graph, tree, &relative);
    let places = places(graph, tree, &relative, about);
    let zero = Momentum::zero(graph);
    let mut columns = vec![zero; tree.n_speeds];
    for body in tree.body_ids() {
        graph.enter(body);
        let mass = given::mass(graph, tree.body(body));
        let inertia = given::inertia(graph, tree.body(body));
        let place = &places[body];
        for (speed, column) in partials.mass_center[body].merged_columns(graph, tree) {
            let momentum = graph.scale(mass, column);
            let momentum = place.of_force(graph, momentum);
            add(graph, &mut columns, speed, momentum);
        }
        for (speed, column) in partials.angular[body].merged_columns(graph, tree) {
            let spin = graph.mul_symmetric(&inertia, column);
            let momentum = place.of_moment(graph, spin);
            add(graph, &mut columns, speed, momentum);
        }
    }
    columns
}

/// The rates of linear and angular momentum for `y_dot = 0`:
/// `sum_K R_K^T m_K a_G_K` and `sum_K R_K^T (I_K alpha_K + tilde(w_K) I_K w_K) + (p_G_K - p) × R_K^T m_K a_G_K`.
pub fn momentum_matrix_dot_u(graph: &mut ExprGraph, tree: &Tree) -> Momentum {
    let motion = velocity::accelerations(graph, tree, Accelerations::Zero);
    let rotational = &motion.rotational;
    let places = places(graph, tree, &rotational.relative, position);
    let mut sum = Momentum::zero(graph);
    for body in tree.body_ids() {
        graph.enter(body);
        let mass = given::mass(graph, tree.body(body));
        let inertia = given::inertia(graph, tree.body(body));
        let force = graph.scale(mass, motion.mass_center[body]);
        let (w, alpha) = (rotational.w[body], motion.alpha[body]);
        let moment = dynamics::euler(graph, &inertia, w, alpha);
        let parts = [
            places[body].of_force(graph, force),
            places[body].of_moment(graph, moment),
        ];
        graph.enter(None);
        for part in parts {
            sum = sum.plus(graph, &part);
        }
    }
    sum
}

/// Where a body is.
struct Place {
    /// Body components to inertial ones.
    back: Matrix,
    /// From the point that moments are about to the body's mass centre, inertial components.
    center: Vector,
}

fn places(
    graph: &mut ExprGraph,
    tree: &Tree,
    relative: &BodyMap<Matrix>,
    about: fn(&mut ExprGraph, &Tree) -> Vector,
) -> BodyMap<Place> {
    graph.begin(Purpose::Momentum);
    let point = about(graph, tree);
    let rotations = orientation::absolute(graph, tree, relative);
    let origins = position::origin(graph, tree, relative);
    let centers = position::mass_center(graph, tree, &origins);
    BodyMap::outward(tree.bodies.len(), |body, _| {
        graph.enter(body);
        let back = transpose(&rotations[body]);
        let center = graph.mul_vector(&back, centers[body]);
        let center = graph.sub_vectors(center, point);
        Place { back, center }
    })
}

impl Place {
    /// Of what acts at the body's mass centre, body components.
    fn of_force(&self, graph: &mut ExprGraph, force: Vector) -> Momentum {
        let linear = graph.mul_vector(&self.back, force);
        Momentum {
            linear,
            angular: graph.cross(self.center, linear),
        }
    }

    /// Of a couple, body components.
    fn of_moment(&self, graph: &mut ExprGraph, moment: Vector) -> Momentum {
        Momentum {
            linear: graph.zero_vector(),
            angular: graph.mul_vector(&self.back, moment),
        }
    }
}

impl Momentum {
    /// None.
    pub fn zero(graph: &mut ExprGraph) -> Self {
        Self {
            linear: graph.zero_vector(),
            angular: graph.zero_vector(),
        }
    }

    /// Both together.
    #[must_use]
    pub fn plus(&self, graph: &mut ExprGraph, other: &Self) -> Self {
        Self {
            linear: graph.add_vectors(self.linear, other.linear),
            angular: graph.add_vectors(self.angular, other.angular),
        }
    }
}

fn add(graph: &mut ExprGraph, columns: &mut [Momentum], speed: SpeedId, own: Momentum) {
    let column = &mut columns[speed.index()];
    *column = column.plus(graph, &own);
}

/// The matrices of columns, by rows: linear, then angular.
pub fn rows(columns: &[Momentum]) -> [Vec<Expr>; 2] {
    let of = |part: fn(&Momentum) -> Vector| {
        let row = |axis: usize| columns.iter().map(move |column| part(column)[axis]);
        (0..3).flat_map(row).collect()
    };
    [of(|column| column.linear), of(|column| column.angular)]
}
