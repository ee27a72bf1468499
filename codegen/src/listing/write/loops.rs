//! Long loops as several, one after the other, over the same columns: a compiler makes vectors of those alone that read and write
//! few rows.

use std::collections::BTreeSet;

use super::stages::{cut, for_each, given};
use crate::functions::Signature;
use crate::listing::{Code, Entry, Expression, LocalId, Role, Stage, Statement, Step};

/// The most rows of numbers, one of each column, that a loop reads and writes: of loops with more, LLVM gives up proving that they do
/// not overlap, and makes no vectors.
const MOST_ROWS: usize = 240;

/// The loops of a helper whose arguments are these, in order; none where one is enough.
pub(super) fn of(signature: &Signature, roles: &[Role], code: &Code) -> Vec<Stage> {
    let n_statements = code.statements.len();
    let rows = Rows::of(roles, code);
    let mut ranges = Vec::new();
    let mut start = 0;
    while start < n_statements {
        let end = rows.longest(start);
        ranges.push(start..end);
        start = end;
    }
    if ranges.len() < 2 {
        return Vec::new();
    }
    cut(signature, code, &ranges)
}

/// What statements read and write, row by row.
struct Rows {
    statements: Vec<Touched>,
    /// Where each local is assigned.
    assigned: Vec<usize>,
    /// Where it is read last.
    read: Vec<usize>,
}

/// What a statement reads and writes.
#[derive(Default)]
struct Touched {
    assigned: Vec<LocalId>,
    /// Locals that hold no argument.
    read: Vec<LocalId>,
    /// What columns are given, by argument and place.
    given: Vec<[usize; 2]>,
    n_stored: usize,
}

impl Rows {
    fn of(roles: &[Role], code: &Code) -> Self {
        let given = given(code);
        let statements = code.statements.iter();
        let statements = statements.map(|own| Touched::of(roles, &given, own));
        let mut rows = Self {
            statements: statements.collect(),
            assigned: vec![0; code.locals.len()],
            read: vec![0; code.locals.len()],
        };
        for (place, own) in rows.statements.iter().enumerate() {
            for local in &own.assigned {
                rows.assigned[local.index()] = place;
            }
            for local in &own.read {
                rows.read[local.index()] = place;
            }
        }
        rows
    }

    /// The end of the longest loop from a statement on that has few rows, or of that statement alone.
    fn longest(&self, start: usize) -> usize {
        let (mut given, mut earlier) = (BTreeSet::new(), BTreeSet::new());
        let (mut n_stored, mut n_kept) = (0, 0);
        let mut longest = start + 1;
        for (place, own) in self.statements.iter().enumerate().skip(start) {
            n_stored += own.n_stored;
            given.extend(own.given.iter().copied());
            let mut read: Vec<LocalId> = own.read.clone();
            read.sort_unstable();
            read.dedup();
            for local in read {
                if self.assigned[local.index()] < start {
                    earlier.insert(local);
                } else if self.read[local.index()] == place {
                    n_kept -= 1;
                }
            }
            n_kept += own.assigned.len();
            // These never become fewer.
            let n_rows = given.len() + earlier.len() + n_stored;
            if n_rows > MOST_ROWS {
                break;
            }
            if n_rows + n_kept <= MOST_ROWS {
                longest = place + 1;
            }
        }
        longest
    }
}

impl Touched {
    fn of(roles: &[Role], given: &[Option<&Entry>], statement: &Statement) -> Self {
        let mut touched = Self {
            n_stored: statement.stored().count(),
            ..Self::default()
        };
        let mut of_columns = Vec::new();
        let mut give = |entry: &Entry| {
            if roles[entry.argument] != Role::Shared {
                let place = entry.steps.iter().map(|step| match step {
                    Step::Index(place) => *place,
                    Step::Member(_) => 0,
                });
                of_columns.push([entry.argument, place.sum()]);
            }
        };
        for_each(statement, &mut |expression| match expression {
            Expression::Entry(entry) => give(entry),
            Expression::Local(local) => match given[local.index()] {
                Some(entry) => give(entry),
                None => touched.read.push(*local),
            },
            _ => {}
        });
        touched.given = of_columns;
        let is_given = |local: &LocalId| given[local.index()].is_some();
        touched.assigned = statement.assigned().filter(|own| !is_given(own)).collect();
        touched
    }
}
