//! Derivatives of accelerations: of the forces that they need, solved for column by column.

use super::{
    bias::bias_of,
    forces::add_mechanics,
    turned::{turned_roots, turning_roots},
};
use crate::{
    expr::{Expr, ExprGraph, LANES},
    functions::{argument::Argument, function::ByArguments, roots::dynamics},
    given::{Accelerations, Loads, mechanics},
    recursive::{
        Plan, Technique,
        accelerations::inverse_mass,
        derivatives::{self, Derivatives, Wanted},
    },
    solve::{self, Carriers, Factors, Inversion, LockstepSolver, SpeedMatrix},
    tree::Tree,
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
) -> ByArguments {
    of_accelerations(graph, tree, plan, Loads::Absent)
}

pub(in crate::functions) fn loaded_forward_dynamics(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> ByArguments {
    of_accelerations(graph, tree, plan, Loads::Given)
}

/// By coordinates `-M^-1` times how the mass matrix times these accelerations changes; by forces `M^-1`.
pub(in crate::functions) fn mass_matrix_solve(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> ByArguments {
    let tau = dynamics::applied(graph, tree);
    let u_dot = inverse_mass::solution(graph, tree, plan, tau);
    let inverse = inverse_mass::inverse(graph, tree, plan);
    let accelerations = Accelerations::Values(&u_dot);
    let needed = derivatives::of_mass_matrix_product(graph, tree, plan, accelerations);
    let columns = solve::transposed(&needed.by_q).into_iter();
    let columns = columns.map(|own| solve::negated(solve::product(graph, &inverse, &own)));
    let columns: Vec<Vec<Expr>> = columns.collect();
    ByArguments {
        by: vec![
            (Argument::Q, solve::transposed(&columns)),
            (Argument::Tau, inverse),
        ],
        values: Some(u_dot),
        mass: None,
    }
}

/// By coordinates and speeds `-M^-1` times how the forces change at these accelerations; by forces `M^-1`.
fn of_accelerations(graph: &mut ExprGraph, tree: &Tree, plan: &Plan, loads: Loads) -> ByArguments {
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
    let roots = turning_roots(tree);
    for (speed, column) in turned_roots(graph, tree, &roots, &u_dot, &inverse) {
        for (row, entry) in by_q.iter_mut().zip(column) {
            row[speed.index()] = entry;
        }
    }
    ByArguments {
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
        let negative = columns.into_iter().map(solve::negated).collect::<Vec<_>>();
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
        let of_q: Vec<Vec<Expr>> = late.by_ref().take(n).map(solve::negated).collect();
        let mut of_u = solve::zero_matrix(graph, n);
        let solved = late.by_ref().take(later.len());
        for (own, column) in beside.into_iter().chain(later).zip(early.chain(solved)) {
            of_u[own] = solve::negated(column);
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
