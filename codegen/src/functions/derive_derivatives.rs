//! Derivatives of dynamics, put together from composite bodies and from what acts in joints.

use super::{argument::Argument, derive, function::Told, variable::Variable};
use crate::{
    differentiate::{Seeds, forward},
    expr::{Expr, ExprGraph, Input, Purpose},
    given::{self, Accelerations, Loads, mechanics, orientation},
    id::{BodyId, SpeedId},
    recursive::{Plan, Technique, derivatives, gravity, inverse_dynamics},
    solve::{self, Carriers, SpeedMatrix},
    tree::{Orientation, Tree, Value},
};

pub(super) fn of_inverse_dynamics(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Told {
    of_forces(graph, tree, plan, (Accelerations::Given, Loads::Absent))
}

pub(super) fn loaded_inverse_dynamics(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Told {
    of_forces(graph, tree, plan, (Accelerations::Given, Loads::Given))
}

pub(super) fn bias(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Told {
    of_forces(graph, tree, plan, (Accelerations::Zero, Loads::Absent))
}

pub(super) fn forward_dynamics(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Told {
    of_accelerations(graph, tree, plan, Loads::Absent)
}

pub(super) fn loaded_forward_dynamics(graph: &mut ExprGraph, tree: &Tree, plan: &Plan) -> Told {
    of_accelerations(graph, tree, plan, Loads::Given)
}

/// By coordinates and speeds `-M^-1` times how the forces change at these accelerations; by forces `M^-1`.
fn of_accelerations(graph: &mut ExprGraph, tree: &Tree, plan: &Plan, loads: Loads) -> Told {
    let zero = Accelerations::Zero;
    // Columns pass twice and share what they have in common, which calls would not.
    let in_lockstep = plan.uses(Technique::Lockstep);
    let plan = &plan.with(Technique::Lockstep, false);
    // What is said of the mass matrix does not depend on accelerations, so that it is there for them.
    let found = derivatives::of_inverse_dynamics(graph, tree, plan, zero, loads);
    let mut bias = bias_of(graph, tree, plan, loads, &found.by_u);
    mechanics::add_forces(graph, tree, zero, &mut bias);
    let matrix = derive::with_rotors(graph, tree, found.by_u_dot);
    let factors = solve::factorise(graph, tree, matrix);
    let mut net = derive::applied(graph, tree);
    solve::subtract(graph, tree, &mut net, &bias);
    let u_dot = factors.solve(graph, net);
    let inverse = factors.inverse(graph, tree, &Carriers::default());
    let given = Accelerations::Values(&u_dot);
    let found = derivatives::of_inverse_dynamics(graph, tree, plan, given, loads);
    let mut all = vec![(Argument::Q, found.by_q), (Argument::U, found.by_u)];
    add_mechanics(graph, tree, plan, zero, &mut all);
    let turned = turned_roots(graph, tree, &u_dot, &inverse);
    for column in turned.iter().map(|(speed, _)| speed.index()) {
        // They are known without a solution.
        for row in &mut all[0].1 {
            row[column] = graph.zero();
        }
    }
    let columns = all.iter().flat_map(|(_, matrix)| transposed(matrix));
    let needed = columns.map(|column| column.into_iter().map(|entry| -entry).collect());
    let needed: Vec<_> = needed.collect();
    let solved = if in_lockstep {
        factors.solutions_in_lockstep(graph, tree, &needed)
    } else {
        factors.solutions(graph, tree, &needed)
    };
    for ((_, matrix), columns) in all.iter_mut().zip(solved.chunks(tree.n_speeds)) {
        *matrix = transposed(columns);
    }
    for (speed, column) in turned {
        for (row, entry) in all[0].1.iter_mut().zip(column) {
            row[speed.index()] = entry;
        }
    }
    all.push((Argument::Tau, inverse));
    Told {
        by: all,
        values: Some(u_dot),
    }
}

/// The forces that bodies need where no speed changes: weight, less what lifts and the loads, and what motion needs. That is
/// quadratic in the speeds: half of its derivatives by them, times the speeds.
fn bias_of(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    loads: Loads,
    by_u: &SpeedMatrix,
) -> Vec<Expr> {
    let mut bias = gravity::gravity_forces(graph, tree, plan);
    if loads == Loads::Given {
        let given = inverse_dynamics::generalized_forces(graph, tree, plan);
        solve::subtract(graph, tree, &mut bias, &given);
    }
    graph.begin(Purpose::Forces);
    let half = graph.number(0.5);
    let speeds = |body: BodyId| tree.body(body).joint.speeds().into_iter();
    for body in tree.body_ids() {
        graph.enter(body);
        for (_, speed) in speeds(body) {
            let u = graph.input(Input::U(speed));
            let u = graph.mul(half, u);
            for (row, bias) in by_u.iter().zip(&mut bias) {
                let term = graph.mul(row[speed.index()], u);
                *bias = graph.add(*bias, term);
            }
        }
    }
    bias
}

/// How accelerations change as a root that floats is turned, speed by speed: with it turns all that it carries, but neither
/// gravity nor the forces that act along its translations. None is where bodies are lifted, whose forces do not turn with it.
///
/// For a turn about `e` it is `M^-1` times the forces `F × e` there, and `e × (s_ddot - g)` of the translations themselves.
fn turned_roots(
    graph: &mut ExprGraph,
    tree: &Tree,
    u_dot: &[Expr],
    inverse: &SpeedMatrix,
) -> Vec<(SpeedId, Vec<Expr>)> {
    if tree.lifts_some() {
        return Vec::new();
    }
    let zero = Accelerations::Zero;
    let none = vec![graph.zero(); tree.n_speeds];
    let taken = derive::with_forces(graph, tree, None, zero, none);
    let mut net = derive::applied(graph, tree);
    solve::subtract(graph, tree, &mut net, &taken);
    let gravity = given::acting_gravity(graph, tree);
    let mut turned = Vec::new();
    for body in tree.body_ids().filter(|body| floats(tree, *body)) {
        graph.enter(body);
        let joint = &tree.body(body).joint;
        let Orientation::AngularVelocity { speeds, .. } = joint.orientation else {
            continue;
        };
        let along = joint
            .shifts()
            .map(|motion| motion.map_or(0, |motion| motion.speed.index()));
        let force = along.map(|place| net[place]);
        let to_joint = given::constant(graph, &joint.rotation);
        let gravity = graph.mul_vector(&to_joint, gravity);
        let falling = [0, 1, 2].map(|axis| graph.sub(u_dot[along[axis]], gravity[axis]));
        let axes = orientation::of_joint(graph, tree, joint);
        for (speed, e) in speeds.into_iter().zip(axes) {
            let moved = graph.cross(force, e);
            let mut column = Vec::with_capacity(tree.n_speeds);
            for row in inverse {
                let terms = [0, 1, 2].map(|axis| graph.mul(row[along[axis]], moved[axis]));
                let sum = graph.add(terms[0], terms[1]);
                column.push(graph.add(sum, terms[2]));
            }
            let carried = graph.cross(e, falling);
            for (place, own) in along.into_iter().zip(carried) {
                column[place] = graph.add(column[place], own);
            }
            turned.push((speed, column));
        }
    }
    turned
}

/// True for a body that moves freely against the inertial frame, without rotors and alone.
fn floats(tree: &Tree, body: BodyId) -> bool {
    let joint = &tree.body(body).joint;
    let zero = Value::Baked(0.0);
    let is_free = matches!(joint.orientation, Orientation::AngularVelocity { .. })
        && joint.translations.iter().all(|own| own.is_free());
    let has_rotors = joint.mechanics.iter().any(|own| own.armature != zero);
    tree.lower(body).is_none() && is_free && !has_rotors && !tree.has_followers()
}

fn transposed(matrix: &[Vec<Expr>]) -> SpeedMatrix {
    let columns = 0..matrix.len();
    let column = |column| matrix.iter().map(|row| row[column]).collect();
    columns.map(column).collect()
}

fn of_forces(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    (accelerations, loads): (Accelerations<'_>, Loads),
) -> Told {
    let found = derivatives::of_inverse_dynamics(graph, tree, plan, accelerations, loads);
    let mut all = vec![(Argument::Q, found.by_q), (Argument::U, found.by_u)];
    if accelerations == Accelerations::Given {
        all.push((Argument::UDot, found.by_u_dot));
    }
    add_mechanics(graph, tree, plan, accelerations, &mut all);
    Told {
        by: all,
        values: None,
    }
}

/// Adds how springs, dampers, rotors and what lifts bodies change.
fn add_mechanics(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
    accelerations: Accelerations<'_>,
    all: &mut [(Argument, SpeedMatrix)],
) {
    let none = vec![graph.zero(); tree.n_speeds];
    let acting = derive::with_forces(graph, tree, Some(plan), accelerations, none);
    let mut seeds = Seeds::new();
    for (place, (argument, _)) in all.iter().enumerate() {
        let first = place * tree.n_speeds;
        Variable::Given(*argument).seed(graph, tree, first, &mut seeds);
    }
    let rows = forward(graph, &acting, &seeds);
    for (row, entries) in rows.into_iter().enumerate() {
        for (place, entry) in entries {
            let (matrix, column) = (place / tree.n_speeds, place % tree.n_speeds);
            let sum = &mut all[matrix].1[row][column];
            *sum = graph.add(*sum, entry);
        }
    }
}
