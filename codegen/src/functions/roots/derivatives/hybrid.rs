//! Derivatives of hybrid dynamics: of the forces that all accelerations need, solved for by the free speeds.
//!
//! With `f` the free speeds, `p` the prescribed ones and `G` how the forces needed at these accelerations change, `d(u_dot_f) = -M_ff^-1 G_f` and
//! `d(tau_p) = G_p + M_pf d(u_dot_f)`. By what is given, `M_fp` and `M_pp` take the place of `G`, and forces are solved for as they are.

use super::{
    bias::bias_of,
    forces::add_mechanics,
    turned::{TurningRoot, turned_roots, turning_roots},
};
use crate::{
    expr::{Expr, ExprGraph, Input},
    functions::{
        argument::Argument,
        function::ByArguments,
        roots::{dynamics, hybrid::whole},
    },
    given::{Accelerations, Loads, mechanics},
    id::SpeedId,
    recursive::{
        Plan, Technique,
        derivatives::{self, Wanted},
    },
    solve::{self, FreeSpeeds, SpeedMatrix},
    tree::Tree,
};

/// Columns by the turns of a root are cheaper without a solution where at most one speed of so many is prescribed.
const SPEEDS_PER_PRESCRIBED: usize = 4;

/// Rows are those of all accelerations, then of all forces.
pub(in crate::functions) fn hybrid_dynamics(
    graph: &mut ExprGraph,
    tree: &Tree,
    plan: &Plan,
) -> ByArguments {
    let (zero, loads) = (Accelerations::Zero, Loads::Absent);
    let in_lockstep = plan.uses(Technique::Lockstep);
    // Columns pass twice and share what they have in common, which calls do not.
    let plan = &plan.with(Technique::Lockstep, in_lockstep && plan.calls_twice());
    let of_inverse_dynamics = |graph: &mut ExprGraph, given: Accelerations<'_>, wanted: Wanted| {
        derivatives::of_inverse_dynamics(graph, tree, plan, given, loads, wanted)
    };
    let found = of_inverse_dynamics(graph, zero, Wanted::BY_SPEEDS_AND_ACCELERATIONS);
    let mut needed = bias_of(graph, tree, plan, loads, &found.by_u);
    mechanics::add_forces(graph, tree, zero, &mut needed);
    let mass = dynamics::with_rotors(graph, tree, found.by_u_dot);
    add_prescribed(graph, tree, &mass, &mut needed);
    let free = FreeSpeeds::new(graph, tree, mass.clone(), &tree.prescribed);
    let net = dynamics::applied(graph, tree);
    let partitioned = free.partitioned(graph, tree, net, &needed);
    let values = whole(graph, tree, partitioned);
    let u_dot = &values[..tree.n_speeds];
    let given = Accelerations::Values(u_dot);
    let at_given = of_inverse_dynamics(graph, given, Wanted::BY_COORDINATES);
    let mut needed = [(Argument::Q, at_given.by_q), (Argument::U, found.by_u)];
    add_mechanics(graph, tree, plan, zero, &mut needed);
    let [(_, by_q), (_, by_u)] = needed;
    let columns = Columns {
        tree,
        mass: &mass,
        free: &free,
        in_lockstep,
    };
    let by_u_dot = columns.by_accelerations(graph);
    let mut by_tau = columns.by_forces(graph, &by_u_dot);
    let [by_q, by_u] = columns.by_coordinates_and_speeds(graph, [by_q, by_u], u_dot, &by_tau);
    columns.copy_given(graph, &mut by_tau);
    ByArguments {
        by: vec![
            (Argument::Q, by_q),
            (Argument::U, by_u),
            (Argument::UDot, by_u_dot),
            (Argument::Tau, by_tau),
        ],
        values: Some(values),
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

/// A row for each acceleration, then for each force.
type Rows = Vec<Vec<Expr>>;

/// What makes the columns of derivatives.
struct Columns<'a> {
    tree: &'a Tree,
    mass: &'a SpeedMatrix,
    free: &'a FreeSpeeds,
    /// Whether several go side by side.
    in_lockstep: bool,
}

impl Columns<'_> {
    /// By coordinates, of which some are known without a solution where roots float freely, and by speeds.
    fn by_coordinates_and_speeds(
        &self,
        graph: &mut ExprGraph,
        needed: [SpeedMatrix; 2],
        u_dot: &[Expr],
        by_forces: &Rows,
    ) -> [Rows; 2] {
        let prescribed = &self.tree.prescribed;
        let is_free = |(body, _): &TurningRoot| {
            let mut speeds = self.tree.body(*body).joint.speeds().into_iter();
            speeds.all(|(_, speed)| !prescribed.contains(&speed))
        };
        // They need how prescribed forces change with given ones.
        let is_worth_it = prescribed.len() * SPEEDS_PER_PRESCRIBED <= self.tree.n_speeds;
        let mut roots = turning_roots(self.tree);
        roots.retain(|root| is_worth_it && is_free(root));
        let [mut by_q, by_u] = needed.map(|needed| solve::transposed(&needed));
        for speed in roots.iter().flat_map(|(_, speeds)| speeds) {
            by_q[speed.index()].fill(graph.zero());
        }
        let [mut by_q, by_u] = if self.in_lockstep {
            // Together, so that fewer lanes stay empty.
            let found = self.of_needed(graph, &[by_q, by_u].concat());
            let (by_q, by_u) = found.split_at(self.tree.n_speeds);
            [by_q, by_u].map(solve::transposed)
        } else {
            [by_q, by_u].map(|columns| solve::transposed(&self.of_needed(graph, &columns)))
        };
        for (speed, column) in turned_roots(graph, self.tree, &roots, u_dot, by_forces) {
            for (row, entry) in by_q.iter_mut().zip(column) {
                row[speed.index()] = entry;
            }
        }
        [by_q, by_u]
    }

    /// Accelerations, then forces, by each of what changes the needed forces so.
    fn of_needed(&self, graph: &mut ExprGraph, columns: &[Vec<Expr>]) -> Vec<Vec<Expr>> {
        let accelerations = self.accelerations(graph, columns);
        let columns = columns.iter().zip(accelerations);
        let columns = columns.map(|(needed, accelerations)| {
            let forces = self.free.forces(graph, self.tree, needed, &accelerations);
            [accelerations, forces].concat()
        });
        columns.collect()
    }

    /// By the given accelerations.
    fn by_accelerations(&self, graph: &mut ExprGraph) -> Rows {
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

    /// What the given forces make, which are not among it: how the others change with these mirrors how accelerations change with given
    /// ones.
    fn by_forces(&self, graph: &mut ExprGraph, by_accelerations: &Rows) -> Rows {
        let n = self.tree.n_speeds;
        let mut found = self.free.inverse(graph, self.tree, self.in_lockstep);
        found.extend(vec![vec![graph.zero(); n]; n]);
        for own in self.tree.prescribed.iter().map(|own| own.index()) {
            for other in (0..n).map(SpeedId::new) {
                if !self.tree.prescribed.contains(&other) {
                    found[n + own][other.index()] = -by_accelerations[other.index()][own];
                }
            }
        }
        found
    }

    /// Adds the given forces to what they make.
    fn copy_given(&self, graph: &mut ExprGraph, by_forces: &mut Rows) {
        let n = self.tree.n_speeds;
        for own in (0..n).map(SpeedId::new) {
            if !self.tree.prescribed.contains(&own) {
                by_forces[n + own.index()][own.index()] = graph.one();
            }
        }
    }

    /// `-M_ff^-1` times the rows of the free speeds.
    fn accelerations(&self, graph: &mut ExprGraph, columns: &[Vec<Expr>]) -> Vec<Vec<Expr>> {
        let negative = columns.iter().cloned().map(solve::negated);
        self.free
            .solutions(graph, self.tree, negative.collect(), self.in_lockstep)
    }
}
