//! A system in which some speeds have given accelerations, and the others given forces.

use std::collections::BTreeSet;

use super::{SpeedMatrix, carried::factorised, carriers::Carriers, elimination_order, subtract};
use crate::{
    expr::{Expr, ExprGraph, Purpose},
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

/// Solves `A_ff x_f = tau_f - needed_f` for the free speeds, then `f_p = needed_p + A_pf x_f` for the prescribed ones, whose
/// own accelerations are in `needed` already.
pub fn partitioned(
    graph: &mut ExprGraph,
    tree: &Tree,
    a: SpeedMatrix,
    prescribed: &BTreeSet<SpeedId>,
    mut tau: Vec<Expr>,
    needed: &[Expr],
) -> Partitioned {
    graph.begin(Purpose::Solution);
    let mut order = elimination_order(tree);
    order.retain(|own| !prescribed.contains(&own.speed));
    // From the inertial frame outward, as accelerations follow.
    let free: Vec<_> = order.iter().rev().copied().collect();
    let beside: Vec<Vec<Expr>> = prescribed
        .iter()
        .map(|own| free.iter().map(|k| a[own.index()][k.index()]).collect())
        .collect();
    let factors = factorised(graph, tree, a, order, &Carriers::default());
    subtract(graph, tree, &mut tau, needed);
    let accelerations = factors.solve(graph, tau);
    let bodies = tree.speed_bodies();
    let mut forces = vec![graph.zero(); tree.n_speeds];
    for (own, row) in prescribed.iter().zip(beside) {
        graph.enter(bodies[own.index()]);
        let mut sum = needed[own.index()];
        for (k, entry) in free.iter().zip(row) {
            let term = graph.mul(entry, accelerations[k.index()]);
            sum = graph.add(sum, term);
        }
        forces[own.index()] = sum;
    }
    Partitioned {
        accelerations,
        forces,
    }
}
