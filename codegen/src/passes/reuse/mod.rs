//! Reuse. Needs: nothing. Afterwards: hardly a value of the loop equals another one, or the sum, difference or product of two others if it
//! takes several operations of its own; or of three. The others are those of the value's body, what these are computed from, what bodies
//! on the path to it compute of nothing from farther out, and those of bodies farther out. Bodies are left as they are that have too many
//! values (`search::MOST`), too many to choose from (`search::MOST_PAIRS`, `known::MOST_BEYOND`) or too many bodies on their path
//! (`search::DEEPEST`).
//!
//! Keeps: the value of every root, up to rounding. The terms of a value are no larger than before, so terms that cancel cost no digits that
//! they did not cost before. A value that is small beside its own terms may be rounded differently. Never raises the number of operations. Does not: look
//! at numbers, but at 2 and a half, or at bodies beside one: a changed mass changes no more than numbers, and a new body no more than what
//! is of its path. A helper is a graph of its own.
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
use crate::{
    expr::{Expr, ExprGraph, Rebuilt},
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
    // What is built is simplified anew: a new factor may join others, and part what was shared.
    replaced(&work, found).or_else(|| replaced(&work, sums))
}

/// The graph with values replaced by these, but for those of bodies in which operations on parameters alone would come in, as where a
/// number joins a parameter.
fn replaced(work: &Work<'_>, mut found: Vec<Found>) -> Option<((ExprGraph, Vec<Expr>), Scopes)> {
    let before = work.on_parameters();
    while !found.is_empty() {
        let mut replacing = work.clone();
        let changed = replacing.replace(found.clone());
        let next = rebuilt(&replacing);
        let after = Work::new(&next.0, &next.1);
        let more: Scopes = after
            .on_parameters()
            .into_iter()
            .filter(|(body, count)| before.get(body).is_none_or(|before| count > before))
            .map(|(body, _)| body)
            .collect();
        if more.is_empty() {
            let is_better = after.total() < work.total();
            return is_better.then_some((next, changed));
        }
        let n_before = found.len();
        found.retain(|found| !more.contains(&work.graph.scope(found.id)));
        if found.len() == n_before {
            return None;
        }
    }
    None
}

/// The graph built anew, operands first.
fn rebuilt(work: &Work<'_>) -> (ExprGraph, Vec<Expr>) {
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
    let roots = work.roots.iter().map(|&root| rebuilt.expr(root)).collect();
    (graph, roots)
}
