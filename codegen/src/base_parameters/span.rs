//! What columns span: an orthonormal basis, and what it is in the columns.

use super::columns::{Column, norm};

/// Columns that are independent, in the order in which they were added.
#[derive(Default)]
pub(super) struct Span<'a> {
    columns: Vec<(usize, &'a Column)>,
    basis: Vec<Vec<f64>>,
    /// Each vector of the basis as a sum of the columns up to its own.
    of_columns: Vec<Vec<f64>>,
}

/// A column beside a span.
pub(super) struct Projected {
    along: Vec<f64>,
    rest: Vec<f64>,
}

/// A rest that is smaller is rounding, of a column of unit length.
const NOTHING: f64 = 1e-9;

/// A rest that is smaller is little: what rounded angles leave.
const LITTLE: f64 = 1e-4;

/// A rest that is smaller than so many times what rounding can have done is rounding, too.
const ROUNDINGS: f64 = 10.0;

/// How often factors are refined, and what they may lack: more than the rounding of common columns.
const REFINEMENTS: usize = 3;
const LACKING: f64 = 1e-13;

/// A factor is nothing where its term is smaller, relative to the column.
const NO_TERM: f64 = 1e-11;

/// How many times farther than those that were found factors may lead that are meant.
const FITS: f64 = 4.0;

/// How near a factor is to a number with few digits that is meant, relative to it.
const MEANT: f64 = 1e-12;

impl<'a> Span<'a> {
    pub(super) fn project(&self, column: &Column) -> Projected {
        let mut along = vec![0.0; self.basis.len()];
        let mut rest = column.unit.clone();
        // Twice is enough for a rest that is orthogonal to all digits.
        for _ in 0..2 {
            for (total, unit) in along.iter_mut().zip(&self.basis) {
                let part = dot(&rest, unit);
                for (entry, own) in rest.iter_mut().zip(unit) {
                    *entry -= part * own;
                }
                *total += part;
            }
        }
        Projected { along, rest }
    }

    /// Adds a column that is none of the span.
    pub(super) fn add(&mut self, place: usize, column: &'a Column, projected: &Projected) {
        let length = projected.length();
        let mut of_columns = vec![0.0; self.columns.len() + 1];
        for (part, earlier) in projected.along.iter().zip(&self.of_columns) {
            for (sum, entry) in of_columns.iter_mut().zip(earlier) {
                *sum -= part * entry / length;
            }
        }
        of_columns[self.columns.len()] = 1.0 / length;
        let unit = projected.rest.iter().map(|entry| entry / length);
        self.basis.push(unit.collect());
        self.of_columns.push(of_columns);
        self.columns.push((place, column));
    }

    /// What the columns of the span give of a column: places with factors.
    pub(super) fn terms(&self, column: &Column, projected: &Projected) -> Vec<(usize, f64)> {
        let of_units = self.refined(column, self.of_units(&projected.along));
        let pairs = of_units.iter().zip(&self.columns);
        let found = pairs.map(|(of_unit, (_, other))| of_unit * column.length / other.length);
        let found: Vec<f64> = found.collect();

        let plain = found.iter().zip(&of_units).map(|(factor, of_unit)| {
            if of_unit.abs() <= NO_TERM {
                0.0
            } else {
                meant(*factor)
            }
        });
        let plain: Vec<f64> = plain.collect();
        // What is meant gives the column as well as what was found.
        let bound = FITS * (self.distance(column, &found) + f64::EPSILON);
        let fits = self.distance(column, &plain) <= bound;
        let factors = if fits { plain } else { found };
        let terms = self.columns.iter().zip(factors);
        let terms = terms.map(|(&(place, _), factor)| (place, factor));
        terms.filter(|(_, factor)| *factor != 0.0).collect()
    }

    /// The factors of columns of unit length, of those of the basis.
    fn of_units(&self, along: &[f64]) -> Vec<f64> {
        let mut of_units = vec![0.0; self.columns.len()];
        for (part, earlier) in along.iter().zip(&self.of_columns) {
            for (sum, entry) in of_units.iter_mut().zip(earlier) {
                *sum += part * entry;
            }
        }
        of_units
    }

    /// With what these factors lack, where that is more than rounding: short columns have told the basis less than they know.
    fn refined(&self, column: &Column, mut of_units: Vec<f64>) -> Vec<f64> {
        for _ in 0..REFINEMENTS {
            let rest = self.rest(column, &of_units);
            if norm(rest.iter().copied()) < LACKING {
                break;
            }
            let along = self.basis.iter().map(|unit| dot(&rest, unit));
            let more = self.of_units(&along.collect::<Vec<_>>());
            for (sum, more) in of_units.iter_mut().zip(more) {
                *sum += more;
            }
        }
        of_units
    }

    /// What a column is beside the sum of those of unit length with these factors.
    fn rest(&self, column: &Column, of_units: &[f64]) -> Vec<f64> {
        let mut rest = column.unit.clone();
        for (factor, (_, other)) in of_units.iter().zip(&self.columns) {
            for (entry, own) in rest.iter_mut().zip(&other.unit) {
                *entry -= factor * own;
            }
        }
        rest
    }

    /// How far the sum of the columns with these factors is from a column, relative to its length.
    fn distance(&self, column: &Column, factors: &[f64]) -> f64 {
        let pairs = factors.iter().zip(&self.columns);
        let of_units = pairs.map(|(factor, (_, other))| factor * other.length / column.length);
        norm(
            self.rest(column, &of_units.collect::<Vec<_>>())
                .iter()
                .copied(),
        )
    }
}

impl Projected {
    fn length(&self) -> f64 {
        norm(self.rest.iter().copied())
    }

    /// True for a column that the span holds.
    pub(super) fn is_within(&self, column: &Column) -> bool {
        self.length() <= NOTHING.max(ROUNDINGS * column.error)
    }

    /// True for a column of which little is not in the span, beside the longest of its kind.
    pub(super) fn is_nearly_within(&self, column: &Column) -> bool {
        self.length() * column.share <= LITTLE
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// A factor without its noise, where a number with few digits is meant.
fn meant(factor: f64) -> f64 {
    let short: f64 = format!("{factor:.9e}").parse().unwrap_or(factor);
    if (short - factor).abs() <= MEANT * factor.abs() {
        short
    } else {
        factor
    }
}
