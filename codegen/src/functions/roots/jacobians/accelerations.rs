//! Derivatives of accelerations: of the forces that they need, solved for column by column.

use super::forces::add_mechanics;
use crate::{
    expr::{Expr, ExprGraph, Input, LANES, Purpose},
    functions::{argument::Argument, formulation::Way, function::Jacobians, roots::dynamics},
    given::{self, Accelerations, Loads, mechanics, orientation},
    id::{BodyId, SpeedId},
    recursive::{
        Plan, Technique,
        accelerations::inverse_mass,
        derivatives::{self, Derivatives, Wanted},
        forces::{gravity, inverse_dynamics},
    },
    solve::{self, Carriers, Factors, Inversion, LockstepSolver, SpeedMatrix},
    tree::{Mechanics, Tree},
};

/// Accelerations, the inverse of the mass matrix, and its product with columns.
struct Solved {
    u_dot: Vec<Expr>,
    inverse: SpeedMatrix,
    /// By coordinates, by speeds.
    by: [SpeedMatrix; 2],
}

/// How the forces change that are needed at given accelerations, by coordinates and by speeds.
struct Needed<'a> {
    tree: &'a Tree,
    plan: &'a Plan,
    loads: Loads,
}

pub(in crate::functions) fn forward_dynamics(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Jacobians {
    of_accelerations(graph, tree, plan, Loads::Absent)
}

pub(in crate::functions) fn loaded_forward_dynamics(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Jacobians {
    of_accelerations(graph, tree, plan, Loads::Given)
}

/// By coordinates `-M^-1` times how the mass matrix times these accelerations changes; by forces `M^-1`.
pub(in crate::functions) fn mass_matrix_solve(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Jacobians {
    let tau = dynamics::applied(graph, tree);
    let u_dot = inverse_mass::solution(graph, tree, plan, tau);
    let inverse = inverse_mass::inverse(graph, tree, plan);
    let accelerations = Accelerations::Values(&u_dot);
    let needed = derivatives::of_mass_matrix_product(graph, tree, plan, accelerations);
    let columns = solve::transposed(&needed.by_q).into_iter();
    let columns = columns.map(|own| negated(solve::product(graph, &inverse, &own)));
    let columns: Vec<Vec<Expr>> = columns.collect();
    Jacobians {
        by: vec![
            (Argument::Q, solve::transposed(&columns)),
            (Argument::Tau, inverse),
        ],
        values: Some(u_dot),
        mass: None,
    }
}

/// By coordinates and speeds `-M^-1` times how the forces change at these accelerations; by forces `M^-1`.
fn of_accelerations(graph: &mut ExprGraph, tree: &Tree, plan: &Plan, loads: Loads) -> Jacobians {
    let zero = Accelerations::Zero;
    let in_lockstep = plan.uses(Technique::Lockstep);
    // Columns pass twice and share what they have in common, which calls do not.
    let plan = &plan.with(Technique::Lockstep, in_lockstep && plan.calls_twice());
    let needed = Needed { tree, plan, loads };
    // What is said of the mass matrix does not depend on accelerations, so that it is there for them.
    let wanted = Wanted::BY_SPEEDS_AND_ACCELERATIONS;
    let found = derivatives::of_inverse_dynamics(graph, tree, plan, zero, loads, wanted);
    let mut bias = bias_of(graph, tree, plan, loads, &found.by_u);
    mechanics::add_forces(graph, tree, zero, &mut bias);
    let mut net = dynamics::applied(graph, tree);
    solve::subtract(graph, tree, &mut net, &bias);
    let matrix = dynamics::with_rotors(graph, tree, found.by_u_dot.clone());
    let factors = solve::factorise(graph, tree, matrix.clone());
    let Solved {
        u_dot,
        inverse,
        by: [mut by_q, by_u],
    } = if in_lockstep {
        needed.solved_in_lockstep(graph, &factors, net, found)
    } else {
        needed.solved(graph, &factors, net)
    };
    for (speed, column) in turned_roots(graph, tree, &u_dot, &inverse) {
        for (row, entry) in by_q.iter_mut().zip(column) {
            row[speed.index()] = entry;
        }
    }
    Jacobians {
        by: vec![
            (Argument::Q, by_q),
            (Argument::U, by_u),
            (Argument::Tau, inverse),
        ],
        values: Some(u_dot),
        mass: Some(matrix),
    }
}

impl Needed<'_> {
    /// Columns by coordinates, but for those that are known without a solution, and by speeds.
    fn columns(&self, graph: &mut ExprGraph, found: Derivatives) -> [Vec<Vec<Expr>>; 2] {
        let Self { tree, plan, .. } = *self;
        let mut all = [(Argument::Q, found.by_q), (Argument::U, found.by_u)];
        add_mechanics(graph, tree, plan, Accelerations::Zero, &mut all);
        let [mut by_q, by_u] = all.map(|(_, matrix)| solve::transposed(&matrix));
        let known = turning_roots(tree).into_iter();
        for speed in known.flat_map(|(_, speeds)| speeds) {
            by_q[speed.index()] = vec![graph.zero(); tree.n_speeds];
        }
        [by_q, by_u]
    }

    /// The same at accelerations.
    fn columns_at(
        &self,
        graph: &mut ExprGraph,
        u_dot: &[Expr],
        wanted: Wanted,
    ) -> [Vec<Vec<Expr>>; 2] {
        let given = Accelerations::Values(u_dot);
        let Self {
            tree, plan, loads, ..
        } = *self;
        let found = derivatives::of_inverse_dynamics(graph, tree, plan, given, loads, wanted);
        self.columns(graph, found)
    }

    fn solved(&self, graph: &mut ExprGraph, factors: &Factors, net: Vec<Expr>) -> Solved {
        let u_dot = factors.solve(graph, net);
        let inverse = factors.inverse(graph, self.tree, Inversion::by(&Carriers::default()));
        let columns = self.columns_at(graph, &u_dot, Wanted::ALL).concat();
        let negative = columns.into_iter().map(negated).collect::<Vec<_>>();
        let solved = factors.solutions(graph, self.tree, &negative);
        let (by_q, by_u) = solved.split_at(self.tree.n_speeds);
        Solved {
            u_dot,
            inverse,
            by: [by_q, by_u].map(solve::transposed),
        }
    }

    /// Several columns side by side. The accelerations take a lane beside columns by speeds, which do not depend on them, and columns
    /// of the inverse take lanes that would stay empty. `found` is what changes without accelerations.
    fn solved_in_lockstep(
        &self,
        graph: &mut ExprGraph,
        factors: &Factors,
        net: Vec<Expr>,
        found: Derivatives,
    ) -> Solved {
        let (tree, none) = (self.tree, Carriers::default());
        let n = tree.n_speeds;
        let mut solver = LockstepSolver::new(factors, tree, &none);
        let [by_q, by_u] = self.columns(graph, found);
        let beside = solver.beside(graph, &by_u);
        let mut early = vec![net];
        early.extend(beside.iter().map(|own| by_u[*own].clone()));
        let later: Vec<usize> = (0..n).filter(|own| !beside.contains(own)).collect();
        let of_later = |by_q: Vec<Vec<Expr>>| {
            let by_u = later.iter().map(|own| by_u[*own].clone());
            by_q.into_iter().chain(by_u).collect::<Vec<_>>()
        };
        let filling = solver.foresee(graph, &of_later(by_q));
        let mut early = solver.solve(graph, &early).into_iter();
        let u_dot = early
            .next()
            .expect("accelerations: accelerations are solved for");
        factors.name_accelerations(graph, &u_dot);
        let how = Inversion {
            carriers: &none,
            left_out: &filling,
            // No more lanes stay empty than are taken.
            in_lockstep: Some(LANES / 2),
        };
        let mut inverse = factors.inverse(graph, tree, how);
        let [by_q, _] = self.columns_at(graph, &u_dot, Wanted::BY_COORDINATES);
        let mut late = of_later(by_q);
        late.extend(filling.iter().map(|own| solver.unit(graph, *own)));
        let mut late = solver.solve(graph, &late).into_iter();
        let of_q: Vec<Vec<Expr>> = late.by_ref().take(n).map(negated).collect();
        let mut of_u = solve::zero_matrix(graph, n);
        let solved = late.by_ref().take(later.len());
        for (own, column) in beside.into_iter().chain(later).zip(early.chain(solved)) {
            of_u[own] = negated(column);
        }
        for (own, column) in filling.into_iter().zip(late) {
            for (row, entry) in column.into_iter().enumerate() {
                inverse[own.index()][row] = entry;
                inverse[row][own.index()] = entry;
            }
        }
        Solved {
            u_dot,
            inverse,
            by: [of_q, of_u].map(|columns| solve::transposed(&columns)),
        }
    }
}

/// The forces that bodies need where no speed changes: weight, less what lifts and the loads, and what motion needs. That is
/// quadratic in the speeds: half of its derivatives by them, times the speeds.
pub(super) fn bias_of(
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
    let zero = Accelerations::Zero;
    let none = vec![graph.zero(); tree.n_speeds];
    let taken = dynamics::with_forces(graph, tree, Way::Notes, zero, none);
    let mut net = dynamics::applied(graph, tree);
    solve::subtract(graph, tree, &mut net, &taken);
    let gravity = given::acting_gravity(graph, tree);
    let mut turned = Vec::new();
    for (body, speeds) in turning_roots(tree) {
        graph.enter(body);
        let joint = &tree.body(body).joint;
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

/// The roots that move freely against the inertial frame, without rotors and alone, with the speeds of their turns.
fn turning_roots(tree: &Tree) -> Vec<(BodyId, [SpeedId; 3])> {
    let turning = |body: BodyId| {
        let joint = &tree.body(body).joint;
        let speeds = joint.angular_velocity()?;
        let is_free = joint.translations.iter().all(|own| own.is_free());
        let has_rotors = joint.mechanics.iter().any(Mechanics::has_rotor);
        (tree.lower(body).is_none() && is_free && !has_rotors).then_some((body, speeds))
    };
    if tree.lifts_some() || tree.has_followers() {
        return Vec::new();
    }
    tree.body_ids().filter_map(turning).collect()
}

pub(super) fn negated(column: Vec<Expr>) -> Vec<Expr> {
    column.into_iter().map(|entry| -entry).collect()
}
