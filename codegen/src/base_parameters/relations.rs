//! Which columns others give.

use super::{
    columns::{Column, Columns},
    span::{Projected, Span},
};
use crate::{
    id::BodyId,
    tree::{InertialParameter, N_INERTIAL, Tree},
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

/// How columns are related.
pub(super) struct Relations {
    /// Of each column whether others give it.
    pub(super) of: Vec<Relation>,
    /// Of each column whether it was taken after the others of its body: it was nearly given, so that they may give it, and it them only
    /// by huge factors.
    has_waited: Vec<bool>,
}

/// Of each column whether earlier ones give it.
pub(super) fn found(tree: &Tree, columns: &Columns) -> Relations {
    related(tree, columns, None)
}

/// The factors with which the columns of other values give those that are given in `pattern`.
pub(super) fn like(tree: &Tree, columns: &Columns, pattern: &Relations) -> Relations {
    related(tree, columns, Some(pattern))
}

fn related(tree: &Tree, columns: &Columns, pattern: Option<&Relations>) -> Relations {
    let mut relating = Relating {
        columns,
        pattern,
        has_followers: tree.has_followers(),
        relations: Relations {
            of: vec![Relation::Left; columns.len()],
            has_waited: vec![false; columns.len()],
        },
        left: Span::default(),
    };
    for body in tree.body_ids() {
        let mut near = of_lower(tree, columns, body, &relating.relations.of);
        let mut waiting = ORDER
            .map(|place| InertialParameter { body, place }.column())
            .to_vec();
        waiting.retain(|&place| relating.waits(&mut near, place));
        for place in waiting {
            relating.relate(&mut near, place);
        }
    }
    relating.relations
}

/// The relations of the columns that were taken.
struct Relating<'a> {
    columns: &'a Columns,
    /// Whose columns are given.
    pattern: Option<&'a Relations>,
    has_followers: bool,
    relations: Relations,
    /// All that are left: where joints follow others, two branches may move alike.
    left: Span<'a>,
}

impl<'a> Relating<'a> {
    /// Whether a column is to be taken after the others of its body. If not, it is taken.
    fn waits(&mut self, near: &mut Span<'a>, place: usize) -> bool {
        let column = self.columns.at(place);
        let waits = match self.pattern {
            Some(pattern) => pattern.has_waited[place],
            None => column.is_known && self.is_nearly_given(near, column),
        };
        self.relations.has_waited[place] = waits;
        if !waits {
            self.relate(near, place);
        }
        waits
    }

    fn is_nearly_given(&self, near: &Span<'_>, column: &Column) -> bool {
        let (by_near, by_left) = self.project(near, column);
        let nearest = by_left.unwrap_or(by_near);
        !nearest.is_within(column) && nearest.is_nearly_within(column)
    }

    /// A column beside those that are near it and, where these do not give it and others may, beside all that are left.
    fn project(&self, near: &Span<'_>, column: &Column) -> (Projected, Option<Projected>) {
        let by_near = near.project(column);
        let is_far = self.has_followers && !by_near.is_within(column);
        let by_left = is_far.then(|| self.left.project(column));
        (by_near, by_left)
    }

    /// Relates a column to those that are near it and to those that are left.
    fn relate(&mut self, near: &mut Span<'a>, place: usize) {
        let column = self.columns.at(place);
        if !column.is_known {
            return;
        }
        let (by_near, by_left) = self.project(near, column);
        let nearest = by_left.as_ref().unwrap_or(&by_near);
        let is_within = nearest.is_within(column);
        let is_given = self
            .pattern
            .map_or(is_within, |pattern| pattern.of[place] != Relation::Left);
        if is_given {
            let terms = match &by_left {
                Some(by_left) => self.left.terms(column, by_left),
                None => near.terms(column, &by_near),
            };
            self.relations.of[place] = Relation::Given(terms);
        } else if !is_within {
            near.add(place, column, &by_near);
            if let Some(by_left) = &by_left {
                self.left.add(place, column, by_left);
            }
        }
    }
}

/// What the columns of a body's lower body span: first those that are left, then those that are given.
fn of_lower<'a>(
    tree: &Tree,
    columns: &'a Columns,
    body: BodyId,
    relations: &[Relation],
) -> Span<'a> {
    let lower = tree.lower(body).into_iter();
    let places = lower.flat_map(|lower| {
        (0..N_INERTIAL).map(move |place| InertialParameter { body: lower, place }.column())
    });
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
