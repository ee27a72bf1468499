//! Which entries of a derivative the tree makes zero, whatever numbers the model has.
//!
//! In: what is differentiated, derived of a tree of drawn numbers, and how its inputs change with the variables. Out: a
//! [`Sparsity`]. It is evaluated at a drawn point modulo a prime, where what cancels is exactly zero: an entry that is left out is
//! zero for all numbers of the model and all states. So patterns follow from the topology and the free coordinates alone.

use std::{
    collections::{BTreeMap, BTreeSet},
    sync::{Arc, Mutex, PoisonError},
};

use super::coloring;
use crate::{
    differentiate::{Seeds, tangents},
    drawn::Field,
    expr::{Expr, ExprGraph, Input, Node},
    id::SpeedId,
    tree::{self, Tree},
};

/// The entries of a derivative that are not structurally zero.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sparsity {
    /// The row and column of each, row after row: rows are the entries of all outputs one after the other, columns those of all
    /// variables in the order asked for. Of a second derivative those with `column <= row`.
    pub places: Vec<[usize; 2]>,
    /// For each column a colour, from 0: two columns of one colour share no row. `None` of a second derivative.
    pub colors: Option<Vec<usize>>,
}

impl Sparsity {
    /// That of a first derivative with so many columns.
    pub(super) fn of_first(rows: &[BTreeSet<usize>], n_columns: usize) -> Self {
        let rows = rows.iter().enumerate();
        let places = rows.flat_map(|(row, columns)| columns.iter().map(move |&at| [row, at]));
        let places: Vec<[usize; 2]> = places.collect();
        Self {
            colors: Some(coloring::colors(&places, n_columns)),
            places,
        }
    }

    /// That of a second derivative, whose rows may be given from either side.
    pub(super) fn of_second(rows: &[BTreeSet<usize>]) -> Self {
        let rows = rows.iter().enumerate();
        let places = rows.flat_map(|(row, columns)| {
            let ordered = move |&at: &usize| [row.max(at), row.min(at)];
            columns.iter().map(ordered)
        });
        let mut places: Vec<[usize; 2]> = places.collect();
        places.sort_unstable();
        places.dedup();
        Self {
            places,
            colors: None,
        }
    }
}

/// The sparsity on each tree on which it was asked for. Copies share it. It says nothing that the derivative and the tree do not, so that all
/// compare as equal.
#[derive(Clone, Debug, Default)]
pub(super) struct LazySparsity(Arc<Mutex<BTreeMap<OfTree, Arc<Sparsity>>>>);

/// What a sparsity depends on: the text of a tree, and which speeds are prescribed.
type OfTree = (String, BTreeSet<SpeedId>);

impl LazySparsity {
    /// The one that is known on this tree, or what `find` finds.
    pub(super) fn get_or_find(
        &self,
        tree: &Tree,
        find: impl FnOnce() -> Sparsity,
    ) -> Arc<Sparsity> {
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let own = known.entry((tree::canonical(tree), tree.prescribed.clone()));
        Arc::clone(own.or_insert_with(|| Arc::new(find())))
    }
}

impl PartialEq for LazySparsity {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl Eq for LazySparsity {}

/// For each root the columns of the variables on which it depends.
pub(super) fn dependences(
    graph: &ExprGraph,
    roots: &[Expr],
    (tree, seeds): (&Tree, &Seeds),
) -> Vec<Vec<usize>> {
    let point = point(graph, tree);
    let of_input = |input: Input| point.get(&input).copied().unwrap_or(Field::ZERO);
    let slopes: Vec<Expr> = seeds.values().flatten().map(|&(_, slope)| slope).collect();
    let mut values = graph.evaluate(&slopes, of_input).into_iter();
    let numbers = seeds.iter().map(|(&input, row)| {
        let known = row
            .iter()
            .zip(&mut values)
            .map(|(&(place, _), value)| (place, value));
        let known = known.filter(|(_, value)| *value != Field::ZERO);
        (input, known.collect())
    });
    let numbers: BTreeMap<Input, Vec<(usize, Field)>> = numbers.collect();
    let rows = tangents(graph, roots, of_input, &numbers).into_iter();
    rows.map(|row| row.into_iter().map(|(column, _)| column).collect())
        .collect()
}

/// A number for every input of the graph; quaternions have length one.
fn point(graph: &ExprGraph, tree: &Tree) -> BTreeMap<Input, Field> {
    let mut point = BTreeMap::new();
    let input = |id| match graph.node(id) {
        Node::Input(input) => Some(input),
        _ => None,
    };
    for input in graph.ids().filter_map(input) {
        let n_known = u64::try_from(point.len()).unwrap_or(u64::MAX);
        point.entry(input).or_insert_with(|| Field::drawn(n_known));
    }
    for (_, [scalar, vector @ ..]) in tree.quaternions() {
        // A point of the sphere, from the plane through its middle.
        let drawn = vector.map(|own| point.get(&Input::Q(own)).copied().unwrap_or(Field::ONE));
        let square = drawn.map(|own| own * own).into_iter();
        let square = square.fold(Field::ZERO, |sum, own| sum + own);
        let length = Field::ONE / (Field::ONE + square);
        point.insert(Input::Q(scalar), (Field::ONE + -square) * length);
        let units = vector.into_iter().zip(drawn);
        point.extend(units.map(|(at, own)| (Input::Q(at), (own + own) * length)));
    }
    point
}
