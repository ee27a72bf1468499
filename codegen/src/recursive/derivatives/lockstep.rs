//! Columns that have come to one place pass inward four at a time: what a column goes through is derived once, on sides in the place
//! of its numbers, and called for four.

use super::{
    ahead::{Place, SendAhead},
    begun::Begins,
    carried::Carried,
    column::DerivativeColumn,
    found::Derivatives,
    passing::Passing,
    sides::on_sides,
    wanted::Wanted,
    way::Went,
};
use crate::{
    expr::{Expr, ExprGraph, LANES},
    id::BodyMap,
    recursive::{links::linkage::Linkage, matrices::shortcut::Shortcuts},
};

/// The way inward of columns that nothing joins.
pub(super) struct Inward<'a> {
    pub(super) linkage: &'a Linkage<'a>,
    pub(super) ways: &'a BodyMap<Went>,
    pub(super) wanted: Wanted,
}

/// An entry that is read off a column on its way.
struct Read {
    /// Of which matrix.
    matrix: usize,
    /// The speed of the motion that reads it.
    speed: usize,
    /// False for the mirrored one, a row of the column's speed.
    is_column: bool,
    value: Expr,
}

impl Read {
    /// Where what is read off a column stands.
    fn entry<'a>(&self, found: &'a mut Derivatives, column: &DerivativeColumn) -> &'a mut Expr {
        let own = column.carrying.motion.speed.index();
        let matrix = &mut *found.matrices_mut()[self.matrix];
        if self.is_column {
            &mut matrix[self.speed][own]
        } else {
            &mut matrix[own][self.speed]
        }
    }
}

impl SendAhead for Inward<'_> {
    /// As long as there are enough of a kind.
    fn send(
        &self,
        graph: &mut ExprGraph,
        from: Place,
        columns: &mut Vec<DerivativeColumn>,
        shortcuts: &mut Shortcuts<'_>,
        found: &mut Derivatives,
    ) {
        while let Some(group) = taken(columns) {
            self.send_group(graph, from, &group, shortcuts, found);
        }
    }
}

impl Inward<'_> {
    fn send_group(
        &self,
        graph: &mut ExprGraph,
        from: Place,
        group: &[DerivativeColumn; LANES],
        shortcuts: &mut Shortcuts<'_>,
        found: &mut Derivatives,
    ) {
        let (one, sides) = on_sides(graph, group, |column| column.parts_mut().collect());
        let alike = group.map(|own| one.of_motion(&own));
        let reads = self.reads(graph, from, &alike, shortcuts).into_iter();
        let (reads, others): (Vec<Read>, Vec<Read>) =
            reads.partition(|read| self.wanted.matrices()[read.matrix]);
        for read in others {
            for column in group {
                *read.entry(found, column) = graph.one();
            }
        }
        let values: Vec<Expr> = reads.iter().map(|read| read.value).collect();
        graph.enter(from.body);
        let lanes = graph.call_outlined(&values, &sides);
        for (column, lane) in group.iter().zip(lanes) {
            for (read, value) in reads.iter().zip(lane) {
                let entry = read.entry(found, column);
                *entry = graph.add(*entry, value);
            }
        }
    }

    /// What is read off the first of columns on their way from a link to the inertial frame.
    fn reads(
        &self,
        graph: &mut ExprGraph,
        from: Place,
        alike: &[DerivativeColumn; LANES],
        shortcuts: &mut Shortcuts<'_>,
    ) -> Vec<Read> {
        let tree = self.linkage.tree;
        let mut found = Derivatives::zero(graph, tree);
        let own = alike[0].carrying.motion.speed.index();
        // All four: whether a shortcut pays depends on how many take it.
        let mut columns = alike.to_vec();
        let mut next = Some(from);
        while let Some(Place { body, step: entry }) = next {
            let mut carried = Carried {
                passing: Passing::nothing(graph, body, &self.ways[body].at_motions),
                shortcuts: &mut *shortcuts,
                columns,
                found: &mut found,
                begins: &mut Begins::Nowhere,
                step: 0,
                entry,
                ahead: None,
            };
            self.linkage.passages[body].inward(graph, &mut carried);
            columns = carried.columns;
            let lower = tree.lower(body);
            for (column, lower) in columns.iter().take(1).zip(lower) {
                column.hint(graph, tree, lower);
            }
            next = lower.map(Place::at_link);
        }
        let mut reads = Vec::new();
        for (matrix, of) in found.matrices_mut().into_iter().enumerate() {
            for speed in (0..tree.n_speeds).filter(|speed| *speed != own) {
                let both = [(true, of[speed][own]), (false, of[own][speed])];
                let both = both.into_iter().filter(|(_, value)| !graph.is_zero(*value));
                reads.extend(both.map(|(is_column, value)| Read {
                    matrix,
                    speed,
                    is_column,
                    value,
                }));
            }
        }
        reads
    }
}

/// Four columns of a kind, the first, taken from those at a link; in the order of their speeds, in which matrices have them.
fn taken(columns: &mut Vec<DerivativeColumn>) -> Option<[DerivativeColumn; LANES]> {
    let group = columns.iter().enumerate().find_map(|(first, column)| {
        let alike = (first..columns.len()).filter(|&other| column.is_like(&columns[other]));
        let alike: Vec<usize> = alike.take(LANES).collect();
        <[usize; LANES]>::try_from(alike).ok()
    })?;
    let mut taken = group.map(|place| columns[place]);
    taken.sort_by_key(|column| column.carrying.motion.speed);
    for place in group.into_iter().rev() {
        columns.remove(place);
    }
    Some(taken)
}
