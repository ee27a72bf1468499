//! Generalized forces, mass matrix and right-hand side, Eqs. (36), (41)-(43), as sums over bodies.

use super::{orientation, velocity};
use crate::{
    expr::{Expr, ExprGraph, Input, Matrix, Purpose, Symmetric, Vector, negated},
    given::{self, Accelerations, Lifted},
    id::{BodyId, BodyMap, SpeedId},
    partition::Row,
    solve::{SpeedMatrix, zero_matrix},
    tree::Tree,
};

/// A force at the mass centre and a moment, body components.
#[derive(Clone, Copy, Debug)]
pub struct Wrench {
    /// The force, N.
    pub force: Vector,
    /// The moment about the mass centre, N m.
    pub moment: Vector,
}

impl Wrench {
    fn zero(graph: &mut ExprGraph) -> Self {
        Self {
            force: graph.zero_vector(),
            moment: graph.zero_vector(),
        }
    }

    /// This one less another.
    pub(super) fn minus(&self, graph: &mut ExprGraph, other: &Self) -> Self {
        Self {
            force: graph.sub_vectors(self.force, other.force),
            moment: graph.sub_vectors(self.moment, other.moment),
        }
    }
}

/// `A = sum_K m_K V_G_K^T V_G_K + W_K^T I_K W_K`, Eq. (42).
pub fn mass_matrix(graph: &mut ExprGraph, tree: &Tree) -> SpeedMatrix {
    let relative = orientation::relative(graph, tree);
    let partials = velocity::partials(graph, tree, &relative);
    graph.begin(Purpose::Sums);
    let mut a = zero_matrix(graph, tree.n_speeds);
    for body in tree.body_ids() {
        graph.enter(body);
        let mass = given::mass(graph, tree.body(body));
        let inertia = given::inertia(graph, tree.body(body));
        let v = partials.mass_center[body].merged_columns(graph, tree);
        let w = partials.angular[body].merged_columns(graph, tree);
        add_gram(graph, &mut a, &v, |graph, column| graph.scale(mass, column));
        add_gram(graph, &mut a, &w, |graph, column| {
            graph.mul_symmetric(&inertia, column)
        });
    }
    a
}

/// `A y_dot`, `A` of Eq. (42): `sum_K m_K V_G_K^T (V_G_K y_dot) + W_K^T I_K (W_K y_dot)`.
pub fn mass_matrix_product(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let relative = orientation::relative(graph, tree);
    let partials = velocity::partials(graph, tree, &relative);
    let wrenches = BodyMap::outward(tree.bodies.len(), |body, _| {
        graph.enter(body);
        let mass = given::mass(graph, tree.body(body));
        let inertia = given::inertia(graph, tree.body(body));
        let a = times_accelerations(graph, tree, &partials.mass_center[body]);
        let alpha = times_accelerations(graph, tree, &partials.angular[body]);
        Wrench {
            force: graph.scale(mass, a),
            moment: graph.mul_symmetric(&inertia, alpha),
        }
    });
    generalized(graph, tree, &wrenches)
}

/// A row of partial velocities times `y_dot`.
fn times_accelerations(graph: &mut ExprGraph, tree: &Tree, row: &Row) -> Vector {
    graph.begin(Purpose::Acceleration);
    let mut sum = graph.zero_vector();
    for (speed, column) in row.columns(graph, tree) {
        let acceleration = graph.input(Input::UDot(speed));
        let term = graph.scale(acceleration, column);
        sum = graph.add_vectors(sum, term);
    }
    sum
}

/// Adds `columns^T B columns` to a symmetric matrix.
fn add_gram(
    graph: &mut ExprGraph,
    a: &mut SpeedMatrix,
    columns: &[(SpeedId, Vector)],
    b: impl Fn(&mut ExprGraph, Vector) -> Vector,
) {
    for (place, &(r, column)) in columns.iter().enumerate() {
        let weighted = b(graph, column);
        for &(s, other) in &columns[..=place] {
            let term = graph.dot(other, weighted);
            let entry = graph.add(a[r.index()][s.index()], term);
            a[r.index()][s.index()] = entry;
            a[s.index()][r.index()] = entry;
        }
    }
}

/// `f`, Eq. (43): the loads' generalized forces, weight's with them, less the inertia forces at zero acceleration.
pub fn forcing(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let inertial = inertia_and_weight(graph, tree, Accelerations::Zero);
    let net = BodyMap::outward(tree.bodies.len(), |body, _| {
        graph.enter(body);
        let (force, moment) = (
            given::force(graph, tree, body),
            given::moment(graph, tree, body),
        );
        Wrench {
            force: graph.sub_vectors(force, inertial[body].force),
            moment: graph.sub_vectors(moment, inertial[body].moment),
        }
    });
    generalized(graph, tree, &net)
}

/// `A y_dot - f` with its loads: `tau` for given accelerations, the bias less the loads' generalized forces for none.
pub fn loaded_inverse_dynamics(
    graph: &mut ExprGraph,
    tree: &Tree,
    accelerations: Accelerations<'_>,
) -> Vec<Expr> {
    let needed = needed(graph, tree, accelerations);
    generalized(graph, tree, &needed)
}

/// What each body needs to move as it does, weight included, less the load on it: about its mass centre.
pub(super) fn needed(
    graph: &mut ExprGraph,
    tree: &Tree,
    accelerations: Accelerations<'_>,
) -> BodyMap<Wrench> {
    let inertial = inertia_and_weight(graph, tree, accelerations);
    let loads = loads(graph, tree);
    BodyMap::outward(tree.bodies.len(), |body, _| {
        graph.enter(body);
        Wrench {
            force: graph.sub_vectors(inertial[body].force, loads[body].force),
            moment: graph.sub_vectors(inertial[body].moment, loads[body].moment),
        }
    })
}

/// `A y_dot - f` without loads: `tau` for given accelerations, the bias for none.
pub fn inverse_dynamics(
    graph: &mut ExprGraph,
    tree: &Tree,
    accelerations: Accelerations<'_>,
) -> Vec<Expr> {
    let wrenches = inertia_and_weight(graph, tree, accelerations);
    generalized(graph, tree, &wrenches)
}

/// `F_y = sum_K V_G_K^T F_K + W_K^T M_K`, Eq. (36), of the loads.
pub fn generalized_forces(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let loads = loads(graph, tree);
    generalized(graph, tree, &loads)
}

/// The `tau` that holds the system at rest against weight: `-sum_K V_G_K^T m_K g`, less what lifts.
pub fn gravity_forces(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let relative = orientation::relative(graph, tree);
    let gravity = gravity_in_bodies(graph, tree, &relative);
    let lifts = lifts(graph, tree);
    let supports = BodyMap::outward(tree.bodies.len(), |body, _| {
        graph.enter(body);
        let mass = given::mass(graph, tree.body(body));
        let weight = graph.scale(mass, gravity[body]);
        let support = Wrench {
            force: negated(weight),
            moment: graph.zero_vector(),
        };
        support.minus(graph, &lifts[body])
    });
    generalized(graph, tree, &supports)
}

/// `sum_K V_G_K^T F_K + W_K^T M_K` of what lifts bodies.
pub fn lifting_forces(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let lifts = lifts(graph, tree);
    generalized(graph, tree, &lifts)
}

/// What lifts each body: `-c m g` at the mass centre of each of its parts, `c` the share of the part's weight.
pub(super) fn lifts(graph: &mut ExprGraph, tree: &Tree) -> BodyMap<Wrench> {
    let relative = orientation::relative(graph, tree);
    let gravity = gravity_in_bodies(graph, tree, &relative);
    BodyMap::outward(tree.bodies.len(), |body, _| {
        graph.enter(body);
        let Some(Lifted { mass, moment }) = given::lifted(graph, tree.body(body)) else {
            return Wrench::zero(graph);
        };
        let center = given::mass_center(graph, tree.body(body));
        let at_center = graph.scale(mass, center);
        let around = graph.sub_vectors(moment, at_center);
        let weight = graph.scale(mass, gravity[body]);
        Wrench {
            force: negated(weight),
            moment: graph.cross(gravity[body], around),
        }
    })
}

/// The loads as wrenches.
pub fn loads(graph: &mut ExprGraph, tree: &Tree) -> BodyMap<Wrench> {
    graph.begin(Purpose::Loads);
    BodyMap::outward(tree.bodies.len(), |body, _| {
        graph.enter(body);
        Wrench {
            force: given::force(graph, tree, body),
            moment: given::moment(graph, tree, body),
        }
    })
}

/// `m_K (a_G_K - g)` and `I_K alpha_K + tilde(w_K) I_K w_K`: what a body needs to move as it does.
fn inertia_and_weight(
    graph: &mut ExprGraph,
    tree: &Tree,
    accelerations: Accelerations<'_>,
) -> BodyMap<Wrench> {
    graph.begin(Purpose::Needed);
    let motion = velocity::accelerations(graph, tree, accelerations);
    let weights = gravity_in_bodies(graph, tree, &motion.rotational.relative);
    BodyMap::outward(tree.bodies.len(), |body, _| {
        graph.enter(body);
        let mass = given::mass(graph, tree.body(body));
        let felt = graph.sub_vectors(motion.mass_center[body], weights[body]);
        let inertia = given::inertia(graph, tree.body(body));
        let moment = euler(
            graph,
            &inertia,
            motion.rotational.w[body],
            motion.alpha[body],
        );
        Wrench {
            force: graph.scale(mass, felt),
            moment,
        }
    })
}

/// `I alpha + tilde(w) I w`.
pub(super) fn euler(
    graph: &mut ExprGraph,
    inertia: &Symmetric,
    w: Vector,
    alpha: Vector,
) -> Vector {
    let momentum = graph.mul_symmetric(inertia, w);
    let accelerating = graph.mul_symmetric(inertia, alpha);
    let gyroscopic = graph.cross(w, momentum);
    graph.add_vectors(accelerating, gyroscopic)
}

/// Gravity in the components of every body.
pub(super) fn gravity_in_bodies(
    graph: &mut ExprGraph,
    tree: &Tree,
    relative: &BodyMap<Matrix>,
) -> BodyMap<Vector> {
    graph.begin(Purpose::Weight);
    let inertial = given::acting_gravity(graph, tree);
    BodyMap::outward(tree.bodies.len(), |body, gravity: &BodyMap<Vector>| {
        graph.enter(body);
        let below = tree.lower(body).map_or(inertial, |lower| gravity[lower]);
        let g = graph.mul_vector(&relative[body], below);
        graph.name_vector(g, "g");
        g
    })
}

/// `sum_K V_G_K^T F_K + W_K^T M_K` of any wrenches, one entry a speed.
fn generalized(graph: &mut ExprGraph, tree: &Tree, wrenches: &BodyMap<Wrench>) -> Vec<Expr> {
    graph.begin(Purpose::Sums);
    let relative = orientation::relative(graph, tree);
    let partials = velocity::partials(graph, tree, &relative);
    let mut sums = vec![graph.zero(); tree.n_speeds];
    for body in tree.body_ids() {
        graph.enter(body);
        add_projections(
            graph,
            tree,
            &mut sums,
            &partials.mass_center[body],
            wrenches[body].force,
        );
        add_projections(
            graph,
            tree,
            &mut sums,
            &partials.angular[body],
            wrenches[body].moment,
        );
    }
    sums
}

fn add_projections(graph: &mut ExprGraph, tree: &Tree, sums: &mut [Expr], row: &Row, v: Vector) {
    for (speed, column) in row.columns(graph, tree) {
        let term = graph.dot(column, v);
        sums[speed.index()] = graph.add(sums[speed.index()], term);
    }
}

/// `|cos(theta_2)|` where `theta_1` and `theta_3` are both free, one elsewhere: the distance from the chart's singularity.
pub fn singularity(graph: &mut ExprGraph, tree: &Tree, body: BodyId) -> Expr {
    graph.enter(body);
    let joint = &tree.body(body).joint;
    if !joint.has_singular_chart() {
        return graph.one();
    }
    let Some(angles) = joint.angles() else {
        return graph.one();
    };
    let cosine = given::orientation::trigonometry(graph, tree, angles).cosines[1];
    graph.abs(cosine)
}
