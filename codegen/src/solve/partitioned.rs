//! A system in which some speeds have given accelerations, and the others given forces.

use std::collections::BTreeSet;

use super::{
    BodySpeed, Factors, Inversion, LockstepSolver, SpeedMatrix, carried::factorised,
    carriers::Carriers, elimination_order, subtract,
};
use crate::{
    expr::{Expr, ExprGraph, LANES, Purpose},
    id::SpeedId,
    tree::Tree,
};

/// The accelerations `x` and forces `f` with `A x + needed = f`, by speed.
#[derive(Clone, Debug)]
pub struct Partitioned {
    /// Those of the free speeds; what others have here says nothing.
    pub accelerations: Vec<Expr>,
    /// Those of the prescribed speeds; zero at others.
    pub forces: Vec<Expr>,
}

/// The mass matrix of the free speeds, factorised, and what couples the prescribed ones with these.
#[derive(Debug)]
pub struct FreeSpeeds {
    factors: Factors,
    /// From the inertial frame outward, as accelerations follow.
    free: Vec<BodySpeed>,
    /// By prescribed speed, its entries of the mass matrix with the free ones.
    beside: Vec<(SpeedId, Vec<Expr>)>,
}

impl FreeSpeeds {
    /// Factorises `A_ff`.
    pub fn new(
        graph: &mut ExprGraph,
        tree: &Tree,
        a: SpeedMatrix,
        prescribed: &BTreeSet<SpeedId>,
    ) -> Self {
        graph.begin(Purpose::Solution);
        let mut order = elimination_order(tree);
        order.retain(|own| !prescribed.contains(&own.speed));
        let free: Vec<BodySpeed> = order.iter().rev().copied().collect();
        let row = |own: &SpeedId| free.iter().map(|k| a[own.index()][k.index()]).collect();
        let beside = prescribed.iter().map(|own| (*own, row(own))).collect();
        Self {
            factors: factorised(graph, tree, a, order, &Carriers::default()),
            free,
            beside,
        }
    }

    /// The accelerations of the free speeds for each of several columns of forces; those of prescribed speeds are neither read nor
    /// other than zero. Columns go side by side where they go `in_lockstep`.
    pub fn solutions(
        &self,
        graph: &mut ExprGraph,
        tree: &Tree,
        mut columns: Vec<Vec<Expr>>,
        in_lockstep: bool,
    ) -> Vec<Vec<Expr>> {
        for column in &mut columns {
            for (own, _) in &self.beside {
                column[own.index()] = graph.zero();
            }
        }
        if in_lockstep {
            let none = Carriers::default();
            LockstepSolver::new(&self.factors, tree, &none).solve(graph, &columns)
        } else {
            self.factors.solutions(graph, tree, &columns)
        }
    }

    /// `A_ff^-1`, zero elsewhere; its columns side by side where they go `in_lockstep`.
    pub fn inverse(&self, graph: &mut ExprGraph, tree: &Tree, in_lockstep: bool) -> SpeedMatrix {
        let none = Carriers::default();
        let how = Inversion {
            // As in a solution: a call pays where at least half its lanes are taken.
            in_lockstep: in_lockstep.then_some(LANES / 2),
            ..Inversion::by(&none)
        };
        self.factors.inverse(graph, tree, how)
    }

    /// The forces of the prescribed speeds, zero at others: what is needed, and what these accelerations of the free ones need more.
    pub fn forces(
        &self,
        graph: &mut ExprGraph,
        tree: &Tree,
        needed: &[Expr],
        accelerations: &[Expr],
    ) -> Vec<Expr> {
        let bodies = tree.speed_bodies();
        let mut forces = vec![graph.zero(); tree.n_speeds];
        for (own, row) in &self.beside {
            graph.enter(bodies[own.index()]);
            let mut sum = needed[own.index()];
            for (k, entry) in self.free.iter().zip(row) {
                let term = graph.mul(*entry, accelerations[k.index()]);
                sum = graph.add(sum, term);
            }
            forces[own.index()] = sum;
        }
        forces
    }

    /// Solves `A_ff x_f = tau_f - needed_f` for the free speeds, then `f_p = needed_p + A_pf x_f` for the prescribed ones, whose own
    /// accelerations are in `needed` already.
    pub fn partitioned(
        &self,
        graph: &mut ExprGraph,
        tree: &Tree,
        mut tau: Vec<Expr>,
        needed: &[Expr],
    ) -> Partitioned {
        subtract(graph, tree, &mut tau, needed);
        let accelerations = self.factors.solve(graph, tau);
        let forces = self.forces(graph, tree, needed, &accelerations);
        Partitioned {
            accelerations,
            forces,
        }
    }
}
