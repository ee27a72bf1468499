//! Reuse. Needs: nothing. Afterwards: in a body of up to 1500 values, with up to 64 bodies on its path, hardly a value of the loop
//! equals another one, or the sum, difference or product of two others if it takes several operations of its own; or of three. The
//! others are those of the body, what these are computed from, what bodies on the path to it compute of nothing from farther out, and
//! those of bodies farther out if these are at most 4000. Keeps: the value of every root, up to rounding, which takes no more of it
//! than before: no terms that cancel come in. Never raises the number of operations. Does not: look at numbers, but at 2 and a half, or
//! at bodies beside one: a changed mass changes no more than numbers, and a new body no more than what is of its path. A helper is a
//! graph of its own.
//!
//! What can be reused is found by evaluating: inputs and numbers of the graph are drawn, modulo a prime, sine and cosine of an angle as
//! a point of the circle, and what holds at two such points holds. So two ways to derive the same thing are found to be the same,
//! however little their operations are alike.

mod index;
mod known;
mod made;
mod points;
mod rests;
mod search;
mod value;
mod work;

use std::collections::BTreeSet;

use self::{
    known::Reach,
    made::{Found, Made},
    search::Others,
    work::Work,
};
use super::rebuild::Rebuilt;
use crate::{
    expr::{Expr, ExprGraph},
    id::BodyId,
    tree::Tree,
};

/// Bodies to which values belong, and `None` for what belongs to none.
type Scopes = BTreeSet<Option<BodyId>>;

/// The graph with values made of others that are there, and its roots.
pub fn run(tree: &Tree, mut graph: ExprGraph, roots: Vec<Expr>) -> (ExprGraph, Vec<Expr>) {
    graph.change_helpers(|graph, roots| alone(tree, graph.clone(), roots.to_vec()));
    alone(tree, graph, roots)
}

/// The same, but for the helpers that are called.
fn alone(tree: &Tree, graph: ExprGraph, roots: Vec<Expr>) -> (ExprGraph, Vec<Expr>) {
    let mut now = (graph, roots);
    for (first, reach) in [
        (Others::OneOrTwo, Reach::Path),
        (Others::Three, Reach::Path),
        (Others::OneOrTwo, Reach::Beyond),
        (Others::Three, Reach::Beyond),
    ] {
        let (mut others, mut among) = (first, None);
        // Each round lowers the number of operations, so the rounds end.
        while let Some((next, changed)) = once(tree, &now, others, reach, among.as_ref()) {
            (now, others, among) = (next, Others::OneOrTwo, Some(changed));
        }
    }
    now
}

/// One round among the values of these bodies, or of all, and the bodies of which values were replaced; `None` where no operation falls
/// away.
fn once(
    tree: &Tree,
    (graph, roots): &(ExprGraph, Vec<Expr>),
    others: Others,
    reach: Reach,
    among: Option<&Scopes>,
) -> Option<((ExprGraph, Vec<Expr>), Scopes)> {
    let work = Work::new(graph, roots);
    let found = search::all(tree, &work, others, reach, among);
    let sums = found.iter().filter(|found| !found.made.multiplies());
    let sums: Vec<Found> = sums.copied().collect();
    let replaced = |found: Vec<Found>| {
        if found.is_empty() {
            return None;
        }
        let mut replacing = Work::new(graph, roots);
        let changed = replacing.replace(found);
        let next = rebuilt(&replacing, roots);
        let after = Work::new(&next.0, &next.1);
        let is_better =
            after.total() < work.total() && after.n_on_parameters() <= work.n_on_parameters();
        is_better.then_some((next, changed))
    };
    // What is built is simplified anew: a new factor may join others, and part what was shared, or parameters from the state.
    replaced(found).or_else(|| replaced(sums))
}

/// The graph built anew, operands first.
fn rebuilt(work: &Work<'_>, roots: &[Expr]) -> (ExprGraph, Vec<Expr>) {
    let old = work.graph;
    let mut graph = ExprGraph::with_capacity(old.len());
    let mut rebuilt = Rebuilt::new(old);
    for &id in &work.order {
        graph.enter_like(old, id);
        let expr = match work.made(id) {
            None => rebuilt.copy(&mut graph, old, id),
            Some(made) => made.build(&mut graph, |expr| rebuilt.expr(expr)),
        };
        if !work.made(id).is_some_and(Made::is_same) {
            graph.name_like(expr, old, id);
        }
        rebuilt.set(id, expr);
    }
    let roots = roots.iter().map(|&root| rebuilt.expr(root)).collect();
    (graph, roots)
}
