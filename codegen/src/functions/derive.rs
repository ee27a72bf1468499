//! The root expressions of each function, put together from the equations.

use crate::{
    expr::{Expr, ExprGraph, Matrix, Vector},
    id::BodyMap,
    kane::{Accelerations, angular, dynamics, energy, given, orientation, position, velocity},
    partition::Row,
    recursive::{composite, inverse_dynamics},
    solve::{self, Factors},
    tree::Tree,
};

fn vectors(vectors: BodyMap<Vector>) -> Vec<Expr> {
    vectors.into_values().flatten().collect()
}

fn matrices(matrices: BodyMap<Matrix>) -> Vec<Expr> {
    matrices.into_values().flatten().flatten().collect()
}

pub(super) fn relative_rotation(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    matrices(orientation::relative(graph, tree))
}

pub(super) fn rotation(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let relative = orientation::relative(graph, tree);
    matrices(orientation::absolute(graph, tree, &relative))
}

pub(super) fn relative_angular_velocity(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    vectors(angular::relative_velocity(graph, tree))
}

pub(super) fn angular_velocity(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    vectors(velocity::rotational(graph, tree).w)
}

pub(super) fn angle_rates(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    vectors(angular::angle_rates(graph, tree))
}

pub(super) fn angular_acceleration(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let rotational = velocity::rotational(graph, tree);
    let velocity::Rotational { relative, w_rel, w } = &rotational;
    vectors(angular::acceleration(
        graph,
        tree,
        relative,
        w_rel,
        w,
        Accelerations::Given,
    ))
}

pub(super) fn partial_angular_velocity(graph: &mut ExprGraph, tree: &Tree) -> BodyMap<Row> {
    let relative = orientation::relative(graph, tree);
    angular::partial(graph, tree, &relative)
}

pub(super) fn partial_angular_velocity_dot(graph: &mut ExprGraph, tree: &Tree) -> BodyMap<Row> {
    partials_dot(graph, tree).angular
}

pub(super) fn origin_position(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let relative = orientation::relative(graph, tree);
    vectors(position::origin(graph, tree, &relative))
}

pub(super) fn mass_center_position(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let relative = orientation::relative(graph, tree);
    let origins = position::origin(graph, tree, &relative);
    vectors(position::mass_center(graph, tree, &origins))
}

pub(super) fn origin_velocity(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let rotational = velocity::rotational(graph, tree);
    vectors(velocity::origin(graph, tree, &rotational))
}

pub(super) fn mass_center_velocity(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let rotational = velocity::rotational(graph, tree);
    let origin = velocity::origin(graph, tree, &rotational);
    vectors(velocity::mass_center(graph, tree, &rotational, &origin))
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
    partials(graph, tree).origin
}

pub(super) fn partial_velocity_origin_dot(graph: &mut ExprGraph, tree: &Tree) -> BodyMap<Row> {
    partials_dot(graph, tree).origin
}

pub(super) fn partial_velocity(graph: &mut ExprGraph, tree: &Tree) -> BodyMap<Row> {
    partials(graph, tree).mass_center
}

pub(super) fn partial_velocity_dot(graph: &mut ExprGraph, tree: &Tree) -> BodyMap<Row> {
    partials_dot(graph, tree).mass_center
}

pub(super) fn mass_center_acceleration(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    vectors(velocity::accelerations(graph, tree, Accelerations::Given).mass_center)
}

pub(super) fn q_dot(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let mut rates = vec![graph.zero(); tree.n_coordinates];
    for body in tree.body_ids() {
        graph.enter(body);
        for coordinate in tree.body(body).joint.coordinates() {
            if let crate::tree::Coordinate::Free {
                coordinate: place, ..
            } = coordinate
            {
                rates[place.index()] = given::rate(graph, coordinate);
            }
        }
    }
    rates
}

pub(super) fn mass_matrix(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    dynamics::mass_matrix(graph, tree)
        .into_iter()
        .flatten()
        .collect()
}

pub(super) fn mass_matrix_recursive(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    composite::mass_matrix(graph, tree)
        .into_iter()
        .flatten()
        .collect()
}

pub(super) fn bias(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    dynamics::inverse_dynamics(graph, tree, Accelerations::Zero)
}

pub(super) fn bias_recursive(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    inverse_dynamics::inverse_dynamics(graph, tree, Accelerations::Zero)
}

pub(super) fn inverse_dynamics(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    dynamics::inverse_dynamics(graph, tree, Accelerations::Given)
}

pub(super) fn inverse_dynamics_recursive(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    inverse_dynamics::inverse_dynamics(graph, tree, Accelerations::Given)
}

pub(super) fn forward_dynamics(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let bias = bias(graph, tree);
    let factors = factors(graph, tree);
    solve_forward(graph, tree, &factors, &bias)
}

pub(super) fn forward_dynamics_recursive(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    let bias = bias_recursive(graph, tree);
    let factors = factors_recursive(graph, tree);
    solve_forward(graph, tree, &factors, &bias)
}

/// `u_dot` with `M u_dot = tau - bias`.
fn solve_forward(
    graph: &mut ExprGraph,
    tree: &Tree,
    factors: &Factors,
    bias: &[Expr],
) -> Vec<Expr> {
    let mut net = bias.to_vec();
    for body in tree.body_ids() {
        graph.enter(body);
        for speed in tree
            .body(body)
            .joint
            .coordinates()
            .into_iter()
            .filter_map(crate::tree::Coordinate::speed)
        {
            let tau = graph.input(crate::expr::Input::Tau(speed));
            net[speed.index()] = graph.sub(tau, bias[speed.index()]);
        }
    }
    factors.solve(graph, net)
}

fn factors(graph: &mut ExprGraph, tree: &Tree) -> Factors {
    let a = dynamics::mass_matrix(graph, tree);
    solve::factorise(graph, tree, a)
}

fn factors_recursive(graph: &mut ExprGraph, tree: &Tree) -> Factors {
    let a = composite::mass_matrix(graph, tree);
    solve::factorise(graph, tree, a)
}

pub(super) fn pivots(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    factors(graph, tree).pivots
}

pub(super) fn pivots_recursive(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    factors_recursive(graph, tree).pivots
}

pub(super) fn singularity(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    tree.body_ids()
        .map(|body| dynamics::singularity(graph, tree, body))
        .collect()
}

pub(super) fn kinetic_energy(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    vec![energy::kinetic(graph, tree)]
}

pub(super) fn potential_energy(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    vec![energy::potential(graph, tree)]
}

pub(super) fn linear_momentum(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    energy::linear_momentum(graph, tree).to_vec()
}

pub(super) fn angular_momentum(graph: &mut ExprGraph, tree: &Tree) -> Vec<Expr> {
    energy::angular_momentum(graph, tree).to_vec()
}
