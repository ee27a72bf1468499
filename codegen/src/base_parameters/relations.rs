//! Which columns others give.

use super::{
    columns::{self, Columns},
    span::Span,
};
use crate::{
    id::BodyId,
    tree::{N_INERTIAL, Tree},
};

/// A column and the others.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Relation {
    /// None gives it.
    Left,
    /// The sum of these columns, each times its factor.
    Given(Vec<(usize, f64)>),
}

/// The order in which a body's columns are taken. A mass off its axis is given by what comes before it, so that no factor
/// divides by the distance, which may be zero.
const ORDER: [usize; N_INERTIAL] = [4, 5, 6, 7, 8, 9, 1, 2, 3, 0];

/// Of each column whether earlier ones give it.
pub(super) fn found(tree: &Tree, columns: &Columns) -> Vec<Relation> {
    related(tree, columns, |_, is_within| is_within)
}

/// The factors with which the columns of other values give those that are given in `pattern`.
pub(super) fn like(tree: &Tree, columns: &Columns, pattern: &[Relation]) -> Vec<Relation> {
    related(tree, columns, |place, _| pattern[place] != Relation::Left)
}

fn related(
    tree: &Tree,
    columns: &Columns,
    is_given: impl Fn(usize, bool) -> bool,
) -> Vec<Relation> {
    let mut relations = vec![Relation::Left; columns.len()];
    // All that are left: where joints follow others, two branches may move alike.
    let mut left = Span::default();
    for body in tree.body_ids() {
        let mut near = of_lower(tree, columns, body, &relations);
        for place in ORDER.map(|own| columns::place(body, own)) {
            let column = columns.at(place);
            if !column.is_known {
                continue;
            }
            let by_near = near.project(column);
            let is_far = tree.has_followers() && !by_near.is_within(column);
            let by_left = is_far.then(|| left.project(column));
            let is_within = by_left.as_ref().unwrap_or(&by_near).is_within(column);
            if is_given(place, is_within) {
                let terms = match &by_left {
                    Some(by_left) => left.terms(column, by_left),
                    None => near.terms(column, &by_near),
                };
                relations[place] = Relation::Given(terms);
            } else if !is_within {
                near.add(place, column, &by_near);
                if let Some(by_left) = &by_left {
                    left.add(place, column, by_left);
                }
            }
        }
    }
    relations
}

/// What the columns of a body's lower body span: first those that are left, then those that are given.
fn of_lower<'a>(
    tree: &Tree,
    columns: &'a Columns,
    body: BodyId,
    relations: &[Relation],
) -> Span<'a> {
    let lower = tree.lower(body).into_iter();
    let places = lower.flat_map(|lower| (0..N_INERTIAL).map(move |own| columns::place(lower, own)));
    let is_left = |place: &usize| relations[*place] == Relation::Left;
    let (left, given): (Vec<usize>, Vec<usize>) = places.partition(is_left);
    let mut span = Span::default();
    for place in [left, given].concat() {
        let column = columns.at(place);
        let projected = span.project(column);
        if column.is_known && !projected.is_within(column) {
            span.add(place, column, &projected);
        }
    }
    span
}
