//! Base inertial parameters: combinations of the bodies' inertial parameters, as few as forces depend on.
//!
//! In: a tree. Out: the combinations, in the order of the bodies. From the inertial frame outward, the regressor's columns of a body are
//! compared with those of its lower body. A part of an inertia that the joint does not move needs the same forces as if the lower body had it
//! (Khalil and Kleinfinger 1987), and a part that no joint moves needs no force. The comparison is of numbers at seeded states, so
//! axes in line, gravity along an axis, and joints that follow others need no rules of their own. The columns that remain are the same
//! for nearly all values at run time. The factors are those of the nominal values, with gravity in every direction that may have it.
//! Does not: read masses, or any mass centre.

mod columns;
mod relations;
mod span;
mod text;

use std::collections::BTreeMap;

use crate::{
    drawn::parameters,
    tree::{BaseParameter, InertialParameter, Tree, Value},
};
use columns::Columns;
use relations::Relation;

pub use text::text;

/// The combinations on which the forces of the tree's motions depend.
pub fn of(tree: &Tree) -> &[BaseParameter] {
    tree.base_parameters.get_or_find(|| found(tree))
}

/// Finds them, for copies of the tree with other numbers.
pub(crate) fn find_now(tree: &Tree) {
    let _ = of(tree);
}

fn found(tree: &Tree) -> Vec<BaseParameter> {
    let nominal = parameters::nominal(tree);
    if tree.parameters.is_empty() {
        let columns = Columns::new(tree, &nominal);
        return combined(&relations::found(tree, &columns).of, &columns);
    }
    let changed = parameters::changed(tree, 1);
    let pattern = relations::found(tree, &Columns::new(tree, &changed));
    let columns = Columns::new(tree, &with_gravity(tree, nominal, &changed));
    combined(&relations::like(tree, &columns, &pattern).of, &columns)
}

/// The nominal values, but with gravity of others. Where the nominal one is zero or along an axis, columns that gravity alone
/// makes would be zero, and missing where they give others. No factor depends on gravity, but where joints follow others: there
/// components that are not zero stay.
fn with_gravity(tree: &Tree, nominal: Vec<f64>, others: &[f64]) -> Vec<f64> {
    let (mut values, is_free) = (nominal, !tree.has_followers());
    for component in tree.gravity {
        if let Value::Runtime(parameter) = component {
            let value = &mut values[parameter.index()];
            if is_free || *value == 0.0 {
                *value = others[parameter.index()];
            }
        }
    }
    values
}

/// A term that is smaller beside its column is rounding.
const NO_TERM: f64 = 1e-14;

/// What each column that is left stands for: its own parameter, and those whose columns it helps to give.
fn combined(relations: &[Relation], columns: &Columns) -> Vec<BaseParameter> {
    let mut shares: Vec<BTreeMap<usize, f64>> = Vec::with_capacity(relations.len());
    for (column, relation) in relations.iter().enumerate() {
        let mut share = BTreeMap::new();
        match relation {
            Relation::Left => {
                share.insert(column, 1.0);
            }
            Relation::Given(terms) => {
                for &(other, factor) in terms {
                    let of_other = match relations[other] {
                        Relation::Left => vec![(other, 1.0)],
                        Relation::Given(_) => shares[other].clone().into_iter().collect(),
                    };
                    for (left, own) in of_other {
                        *share.entry(left).or_default() += factor * own;
                    }
                }
            }
        }
        shares.push(share);
    }
    let mut terms: BTreeMap<usize, Vec<(InertialParameter, f64)>> = BTreeMap::new();
    for (column, share) in shares.iter().enumerate() {
        let length = |place: usize| columns.at(place).length;
        let is_term = |&(&left, factor): &(&usize, &f64)| {
            left == column || factor.abs() * length(left) > NO_TERM * length(column)
        };
        for (&left, &factor) in share.iter().filter(is_term) {
            let own = terms.entry(left).or_default();
            let term = (InertialParameter::of_column(column), factor);
            if column == left {
                own.insert(0, term);
            } else {
                own.push(term);
            }
        }
    }
    let terms = terms.into_values();
    terms.map(|terms| BaseParameter { terms }).collect()
}
