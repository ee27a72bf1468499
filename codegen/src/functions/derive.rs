//! The root expressions of each function, put together from the equations.

use super::user_axes;
use crate::{
    expr::{Expr, ExprGraph, Input, Matrix, Vector},
    given::{Accelerations, Loads, mechanics},
    id::BodyMap,
    kane::{angular, dynamics, orientation, position, velocity},
    partition::Row,
    recursive::{self, Plan, composite, gravity, inverse_dynamics},
    solve::{self, Factors, SpeedMatrix},
    tree::Tree,
};

fn vectors(vectors: BodyMap<Vector>) -> Vec<Expr> {
    vectors.into_values().flatten().collect()
}

fn matrices(matrices: BodyMap<Matrix>) -> Vec<Expr> {
    matrices.into_values().flatten().flatten().collect()
}

pub(super) fn relative_rotation(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let relative = orientation::relative(graph, tree);
    matrices(user_axes::relative_rotations(graph, tree, &relative))
}

pub(super) fn rotation(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let relative = orientation::relative(graph, tree);
    let absolute = orientation::absolute(graph, tree, &relative);
    matrices(user_axes::rotations(graph, tree, &absolute))
}

pub(super) fn relative_angular_velocity(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let w_rel = angular::relative_velocity(graph, tree);
    vectors(user_axes::vectors(graph, tree, &w_rel))
}

pub(super) fn angular_velocity(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let w = velocity::rotational(graph, tree).w;
    vectors(user_axes::vectors(graph, tree, &w))
}

pub(super) fn angle_rates(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    vectors(angular::angle_rates(graph, tree))
}

pub(super) fn angular_acceleration(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let rotational = velocity::rotational(graph, tree);
    let velocity::Rotational { relative, w_rel, w } = &rotational;
    let given = Accelerations::Given;
    let alpha = angular::acceleration(graph, tree, relative, w_rel, w, given);
    vectors(user_axes::vectors(graph, tree, &alpha))
}

pub(super) fn partial_angular_velocity(graph: &mut ExprGraph, tree: &Tree) -> BodyMap<Row> {
    let relative = orientation::relative(graph, tree);
    let partial = angular::partial(graph, tree, &relative);
    user_axes::rows(graph, tree, partial)
}

pub(super) fn partial_angular_velocity_dot(graph: &mut ExprGraph, tree: &Tree) -> BodyMap<Row> {
    let dot = partials_dot(graph, tree).angular;
    user_axes::rows(graph, tree, dot)
}

pub(super) fn origin_position(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let relative = orientation::relative(graph, tree);
    let origins = position::origin(graph, tree, &relative);
    vectors(user_axes::origins(graph, tree, &origins))
}

pub(super) fn mass_center_position(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let relative = orientation::relative(graph, tree);
    let origins = position::origin(graph, tree, &relative);
    let centers = position::mass_center(graph, tree, &origins);
    vectors(user_axes::vectors(graph, tree, &centers))
}

pub(super) fn origin_velocity(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let rotational = velocity::rotational(graph, tree);
    let velocities = velocity::origin(graph, tree, &rotational);
    vectors(user_axes::origin_velocities(
        graph,
        tree,
        &rotational,
        &velocities,
    ))
}

pub(super) fn mass_center_velocity(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let rotational = velocity::rotational(graph, tree);
    let origin = velocity::origin(graph, tree, &rotational);
    let velocities = velocity::mass_center(graph, tree, &rotational, &origin);
    vectors(user_axes::vectors(graph, tree, &velocities))
}

fn partials(graph: &mut ExprGraph, tree: &Tree) -> velocity::Partials {
    let relative = orientation::relative(graph, tree);
    velocity::partials(graph, tree, &relative)
}

fn partials_dot(graph: &mut ExprGraph, tree: &Tree) -> velocity::Partials {
    let rotational = velocity::rotational(graph, tree);
    let partials = velocity::partials(graph, tree, &rotational.relative);
    velocity::partials_dot(graph, tree, &rotational, &partials)
}

pub(super) fn partial_velocity_origin(graph: &mut ExprGraph, tree: &Tree) -> BodyMap<Row> {
    let relative = orientation::relative(graph, tree);
    let partials = velocity::partials(graph, tree, &relative);
    user_axes::origin_rows(graph, tree, &relative, &partials.angular, &partials.origin)
}

pub(super) fn partial_velocity_origin_dot(graph: &mut ExprGraph, tree: &Tree) -> BodyMap<Row> {
    let rotational = velocity::rotational(graph, tree);
    let partials = velocity::partials(graph, tree, &rotational.relative);
    let dot = velocity::partials_dot(graph, tree, &rotational, &partials);
    let angular = (&partials.angular, &dot.angular);
    user_axes::origin_rows_dot(graph, tree, &rotational, angular, &dot.origin)
}

pub(super) fn partial_velocity(graph: &mut ExprGraph, tree: &Tree) -> BodyMap<Row> {
    let partial = partials(graph, tree).mass_center;
    user_axes::rows(graph, tree, partial)
}

pub(super) fn partial_velocity_dot(graph: &mut ExprGraph, tree: &Tree) -> BodyMap<Row> {
    let dot = partials_dot(graph, tree).mass_center;
    user_axes::rows(graph, tree, dot)
}

pub(super) fn mass_center_acceleration(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let accelerations = velocity::accelerations(graph, tree, Accelerations::Given).mass_center;
    vectors(user_axes::vectors(graph, tree, &accelerations))
}

pub(super) fn q_dot(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    angular::coordinate_rates(graph, tree)
}

pub(super) fn normalize(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    orientation::normalized(graph, tree)
}

pub(super) fn with_rotors(graph: &mut ExprGraph, tree: &Tree, mut a: SpeedMatrix) -> SpeedMatrix {
    mechanics::add_rotors(graph, tree, &mut a);
    a
}

/// With what is needed beside the motion of bodies: for springs, dampers and rotors, less what lifts bodies, which is found by the
/// notes' equations where there is no plan.
pub(super) fn with_forces(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: Option<&Plan>,
    accelerations: Accelerations<'_>,
    mut tau: Vec<Expr>,
) -> Vec<Expr> {
    mechanics::add_forces(graph, tree, accelerations, &mut tau);
    if tree.lifts_some() {
        let lifting = match plan {
            None => dynamics::lifting_forces(graph, tree),
            Some(plan) => gravity::lifting_forces(graph, tree, plan),
        };
        solve::subtract(graph, tree, &mut tau, &lifting);
    }
    tau
}

pub(super) fn matrix(graph: &mut ExprGraph, tree: &Tree) -> SpeedMatrix {
    let a = dynamics::mass_matrix(graph, tree);
    with_rotors(graph, tree, a)
}

fn matrix_recursive(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> SpeedMatrix {
    let a = composite::mass_matrix(graph, tree, plan);
    with_rotors(graph, tree, a)
}

pub(super) fn mass_matrix(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    matrix(graph, tree).concat()
}

pub(super) fn mass_matrix_recursive(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Vec<Expr> {
    matrix_recursive(graph, tree, plan).concat()
}

pub(super) fn mass_matrix_packed(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    packed(tree, &matrix(graph, tree))
}

pub(super) fn mass_matrix_packed_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Vec<Expr> {
    packed(tree, &matrix_recursive(graph, tree, plan))
}

fn packed(tree: &Tree, a: &SpeedMatrix) -> Vec<Expr> {
    let places = tree.coupled_speeds().into_iter();
    places.map(|[row, column]| a[row][column]).collect()
}

pub(super) fn generalized_forces(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    dynamics::generalized_forces(graph, tree)
}

pub(super) fn generalized_forces_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Vec<Expr> {
    inverse_dynamics::generalized_forces(graph, tree, plan)
}

pub(super) fn forcing(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let f = dynamics::forcing(graph, tree);
    less_forces(graph, tree, None, f)
}

pub(super) fn forcing_recursive(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Vec<Expr> {
    let f = inverse_dynamics::forcing(graph, tree, plan);
    less_forces(graph, tree, Some(plan), f)
}

fn less_forces(graph: &mut ExprGraph, tree: &Tree, plan: Option<&Plan>, f: Vec<Expr>) -> Vec<Expr> {
    let minus = f.into_iter().map(|entry| -entry).collect();
    let sum = with_forces(graph, tree, plan, Accelerations::Zero, minus);
    sum.into_iter().map(|entry| -entry).collect()
}

pub(super) fn bias(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let tau = dynamics::inverse_dynamics(graph, tree, Accelerations::Zero);
    with_forces(graph, tree, None, Accelerations::Zero, tau)
}

pub(super) fn bias_recursive(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Vec<Expr> {
    let tau = inverse_dynamics::inverse_dynamics(graph, tree, plan, Accelerations::Zero);
    with_forces(graph, tree, Some(plan), Accelerations::Zero, tau)
}

pub(super) fn gravity_forces(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    dynamics::gravity_forces(graph, tree)
}

pub(super) fn gravity_forces_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Vec<Expr> {
    gravity::gravity_forces(graph, tree, plan)
}

pub(super) fn inverse_dynamics(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let tau = dynamics::inverse_dynamics(graph, tree, Accelerations::Given);
    with_forces(graph, tree, None, Accelerations::Given, tau)
}

pub(super) fn inverse_dynamics_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Vec<Expr> {
    let tau = inverse_dynamics::inverse_dynamics(graph, tree, plan, Accelerations::Given);
    with_forces(graph, tree, Some(plan), Accelerations::Given, tau)
}

pub(super) fn forward_dynamics(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let bias = bias(graph, tree);
    accelerated(graph, tree, &bias)
}

/// The accelerations by what is left of `tau` beside what a motion without any needs.
pub(super) fn accelerated(graph: &mut ExprGraph, tree: &Tree, needed: &[Expr]) -> Vec<Expr> {
    let factors = factors(graph, tree);
    let mut net = applied(graph, tree);
    solve::subtract(graph, tree, &mut net, needed);
    factors.solve(graph, net)
}

pub(super) fn forward_dynamics_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Vec<Expr> {
    accelerated_recursive(graph, tree, plan, Loads::Absent)
}

pub(super) fn accelerated_recursive(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    loads: Loads,
) -> Vec<Expr> {
    let mut net = applied(graph, tree);
    let zero = vec![graph.zero(); net.len()];
    let taken = with_forces(graph, tree, Some(plan), Accelerations::Zero, zero);
    solve::subtract(graph, tree, &mut net, &taken);
    recursive::forward_dynamics::forward_dynamics(graph, tree, plan, net, loads)
}

/// `tau`, each entry in the scope of its body.
pub(super) fn applied(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let mut tau = vec![graph.zero(); tree.n_speeds];
    for body in tree.body_ids() {
        graph.enter(body);
        for (_, speed) in tree.body(body).joint.speeds() {
            tau[speed.index()] = graph.input(Input::Tau(speed));
        }
    }
    tau
}

pub(super) fn factors(graph: &mut ExprGraph, tree: &Tree) -> Factors {
    let a = matrix(graph, tree);
    solve::factorise(graph, tree, a)
}

pub(super) fn factors_recursive(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Factors {
    let a = matrix_recursive(graph, tree, plan);
    solve::factorise(graph, tree, a)
}

pub(super) fn pivots(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    factors(graph, tree).pivots
}

pub(super) fn pivots_recursive(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Vec<Expr> {
    factors_recursive(graph, tree, plan).pivots
}

pub(super) fn singularity(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    tree.body_ids()
        .map(|body| dynamics::singularity(graph, tree, body))
        .collect()
}
