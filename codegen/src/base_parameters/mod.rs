//! Base inertial parameters: combinations of the bodies' inertial parameters, as few as forces depend on.
//!
//! In: a tree. Out: the combinations, in the order of the bodies. Outward, the columns that the regressor has of a body are
//! compared with those of its lower body: what a joint does not move of an inertia needs as much as if the lower body had it
//! (Khalil and Kleinfinger 1987), and what no joint below moves needs nothing. Compared are numbers, at seeded states, so that
//! axes in line, gravity along an axis, and joints that follow others need no rules of their own. Which columns are left holds
//! for values at run time in general; the factors are those of the nominal ones. Does not: read masses, or any mass centre.

mod columns;
mod relations;
mod span;
mod text;

use std::collections::BTreeMap;

use crate::{
    drawn::parameters,
    id::BodyId,
    tree::{BaseParameter, InertialParameter, N_INERTIAL, Tree},
};
use columns::Columns;
use relations::Relation;

pub use text::text;

/// The combinations on which the forces of the tree's motions depend.
pub fn of(tree: &Tree) -> &[BaseParameter] {
    tree.base_parameters.get_or_find(|| found(tree))
}

fn found(tree: &Tree) -> Vec<BaseParameter> {
    let nominal = Columns::new(tree, &parameters::nominal(tree));
    let relations = if tree.parameters.is_empty() {
        relations::found(tree, &nominal)
    } else {
        let general = Columns::new(tree, &parameters::changed(tree, 1));
        let pattern = relations::found(tree, &general);
        relations::like(tree, &nominal, &pattern)
    };
    combined(&relations)
}

/// What each column that is left stands for: its own parameter, and those whose columns it helps to give.
fn combined(relations: &[Relation]) -> Vec<BaseParameter> {
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
        for (&left, &factor) in share.iter().filter(|(_, factor)| **factor != 0.0) {
            let own = terms.entry(left).or_default();
            let term = (parameter(column), factor);
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

/// The parameter of a column, counted body by body.
fn parameter(column: usize) -> InertialParameter {
    InertialParameter {
        body: BodyId::new(column / N_INERTIAL),
        place: column % N_INERTIAL,
    }
}
