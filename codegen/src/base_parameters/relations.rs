//! Which columns others give.

use super::{columns::Columns, span::Span};
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
    for body in tree.body_ids() {
        let mut span = Span::default();
        for place in relatives(tree, body, &relations) {
            let column = columns.at(place);
            let projected = span.project(column);
            if column.is_known && !projected.is_within(column) {
                span.add(place, column, &projected);
            }
        }
        for place in ORDER.map(|own| body.index() * N_INERTIAL + own) {
            let column = columns.at(place);
            if !column.is_known {
                continue;
            }
            let projected = span.project(column);
            let is_within = projected.is_within(column);
            if is_given(place, is_within) {
                relations[place] = Relation::Given(span.terms(column, &projected));
            } else if !is_within {
                span.add(place, column, &projected);
            }
        }
    }
    relations
}

/// The columns that may give those of a body: of its lower body, those that are left before those that are given. Where joints
/// follow others, two branches may move alike: then also of all bodies before it.
fn relatives(tree: &Tree, body: BodyId, relations: &[Relation]) -> Vec<usize> {
    let of = |body: BodyId| (0..N_INERTIAL).map(move |own| body.index() * N_INERTIAL + own);
    let is_left = |place: &usize| relations[*place] == Relation::Left;
    let lower = tree.lower(body);
    let (left, given): (Vec<usize>, Vec<usize>) = lower.into_iter().flat_map(of).partition(is_left);
    let others = (0..body.index()).map(BodyId::new);
    let others = others.filter(|other| tree.has_followers() && Some(*other) != lower);
    let others: Vec<usize> = others.flat_map(of).filter(is_left).collect();
    [left, given, others].concat()
}
