//! Derivatives of hybrid dynamics: of the forces that all accelerations need, solved for by the free speeds.
//!
//! With `f` the free speeds, `p` the prescribed ones and `G` how the forces needed at these accelerations change, `d(u_dot_f) = -M_ff^-1 G_f` and
//! `d(tau_p) = G_p + M_pf d(u_dot_f)`. By what is given, `M_fp` and `M_pp` take the place of `G`, and forces are solved for as they are.

use super::{
    accelerations::{bias_of, negated},
    forces::add_mechanics,
};
use crate::{
    expr::{Expr, ExprGraph, Input},
    functions::{argument::Argument, function::Jacobians, roots::dynamics},
    given::{Accelerations, Loads, mechanics},
    id::SpeedId,
    recursive::{
        Plan,
        derivatives::{self, Wanted},
    },
    solve::{self, FreeSpeeds, Partitioned, SpeedMatrix},
    tree::Tree,
};

/// Rows are those of all accelerations, then of all forces.
pub(in crate::functions) fn hybrid_dynamics(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> Jacobians {
    let (zero, loads) = (Accelerations::Zero, Loads::Absent);
    let wanted = Wanted::BY_SPEEDS_AND_ACCELERATIONS;
    let found = derivatives::of_inverse_dynamics(graph, tree, plan, zero, loads, wanted);
    let mut needed = bias_of(graph, tree, plan, loads, &found.by_u);
    mechanics::add_forces(graph, tree, zero, &mut needed);
    let mass = dynamics::with_rotors(graph, tree, found.by_u_dot);
    add_prescribed(graph, tree, &mass, &mut needed);
    let free = FreeSpeeds::new(graph, tree, mass.clone(), &tree.prescribed);
    let columns = Columns {
        tree,
        mass: &mass,
        free: &free,
    };
    let values = columns.values(graph, &needed);
    let given = Accelerations::Values(&values.accelerations);
    let found = derivatives::of_inverse_dynamics(graph, tree, plan, given, loads, Wanted::ALL);
    let mut by = vec![(Argument::Q, found.by_q), (Argument::U, found.by_u)];
    add_mechanics(graph, tree, plan, zero, &mut by);
    let by = by.into_iter();
    let by = by.map(|(argument, matrix)| (argument, columns.of_needed(graph, &matrix)));
    let mut by: Vec<(Argument, SpeedMatrix)> = by.collect();
    by.push((Argument::UDot, columns.by_accelerations(graph)));
    by.push((Argument::Tau, columns.by_forces(graph)));
    Jacobians {
        by,
        values: Some([values.accelerations, values.forces].concat()),
        mass: Some(mass),
    }
}

/// Adds the forces of the given accelerations.
fn add_prescribed(graph: &mut ExprGraph, tree: &Tree, mass: &SpeedMatrix, needed: &mut [Expr]) {
    let bodies = tree.speed_bodies();
    for ((row, needed), body) in mass.iter().zip(needed).zip(bodies) {
        graph.enter(body);
        for &speed in &tree.prescribed {
            let given = graph.input(Input::UDot(speed));
            let term = graph.mul(row[speed.index()], given);
            *needed = graph.add(*needed, term);
        }
    }
}

/// What makes the columns of derivatives.
struct Columns<'a> {
    tree: &'a Tree,
    mass: &'a SpeedMatrix,
    free: &'a FreeSpeeds,
}

impl Columns<'_> {
    /// All accelerations and forces, what is given among them.
    fn values(&self, graph: &mut ExprGraph, needed: &[Expr]) -> Partitioned {
        let Self { tree, free, .. } = self;
        let mut net = dynamics::applied(graph, tree);
        let mut whole = net.clone();
        solve::subtract(graph, tree, &mut net, needed);
        let mut accelerations = free.solve(graph, net);
        let forces = free.forces(graph, tree, needed, &accelerations);
        for speed in &tree.prescribed {
            accelerations[speed.index()] = graph.input(Input::UDot(*speed));
            whole[speed.index()] = forces[speed.index()];
        }
        Partitioned {
            accelerations,
            forces: whole,
        }
    }

    /// By what changes the needed forces so.
    fn of_needed(&self, graph: &mut ExprGraph, needed: &SpeedMatrix) -> SpeedMatrix {
        let columns = solve::transposed(needed);
        let accelerations = self.accelerations(graph, &columns);
        let columns = columns.iter().zip(accelerations);
        let columns = columns.map(|(needed, accelerations)| {
            let forces = self.free.forces(graph, self.tree, needed, &accelerations);
            [accelerations, forces].concat()
        });
        solve::transposed(&columns.collect::<Vec<_>>())
    }

    /// By the given accelerations.
    fn by_accelerations(&self, graph: &mut ExprGraph) -> SpeedMatrix {
        let n = self.tree.n_speeds;
        let prescribed: Vec<SpeedId> = self.tree.prescribed.iter().copied().collect();
        let columns = prescribed.iter().map(|own| self.mass[own.index()].clone());
        let columns: Vec<Vec<Expr>> = columns.collect();
        let accelerations = self.accelerations(graph, &columns);
        let mut found = vec![vec![graph.zero(); n]; 2 * n];
        let columns = prescribed.iter().zip(columns).zip(accelerations);
        for (place, ((own, needed), mut accelerations)) in columns.enumerate() {
            let forces = self.free.forces(graph, self.tree, &needed, &accelerations);
            accelerations[own.index()] = graph.one();
            for (row, entry) in accelerations.into_iter().enumerate() {
                found[row][own.index()] = entry;
            }
            // They are symmetric.
            for other in &prescribed[..=place] {
                let entry = forces[other.index()];
                found[n + own.index()][other.index()] = entry;
                found[n + other.index()][own.index()] = entry;
            }
        }
        found
    }

    /// By the given forces: how the others change with these mirrors how accelerations change with given ones.
    fn by_forces(&self, graph: &mut ExprGraph) -> SpeedMatrix {
        let n = self.tree.n_speeds;
        let mut found = self.free.inverse(graph, self.tree);
        let mirrored = self.by_accelerations(graph);
        found.extend(vec![vec![graph.zero(); n]; n]);
        for own in (0..n).map(SpeedId::new) {
            if !self.tree.prescribed.contains(&own) {
                found[n + own.index()][own.index()] = graph.one();
                continue;
            }
            for other in (0..n).map(SpeedId::new) {
                if !self.tree.prescribed.contains(&other) {
                    found[n + own.index()][other.index()] = -mirrored[other.index()][own.index()];
                }
            }
        }
        found
    }

    /// `-M_ff^-1` times the rows of the free speeds.
    fn accelerations(&self, graph: &mut ExprGraph, columns: &[Vec<Expr>]) -> Vec<Vec<Expr>> {
        let negative = columns.iter().map(|column| {
            let mut column = negated(column.clone());
            for own in &self.tree.prescribed {
                column[own.index()] = graph.zero();
            }
            column
        });
        let negative: Vec<Vec<Expr>> = negative.collect();
        self.free.solutions(graph, self.tree, &negative)
    }
}
