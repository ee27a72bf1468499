//! `L^T D L`: factorisation and solution of `A x = b` along the tree, written out.
//!
//! In: a symmetric matrix whose entries couple speeds along paths to the inertial frame, and a right-hand
//! side. Out: the solution, and the pivots. Afterwards: no entry outside that pattern was built (Featherstone 2005:
//! eliminating from the leaves inward fills nothing), but where joints follow others on several branches; and each pivot is
//! inverted once.
//! Does not: search pivots; a matrix that is not positive definite shows in its pivots.

mod blocks;
mod carried;
mod carriers;
mod entries;
mod felt;
mod inverse;
mod lockstep;
mod partitioned;
mod projected;
mod reduced;
mod solutions;

use std::collections::{BTreeMap, BTreeSet};

pub use carried::{factorise, factorise_on_carriers};
pub use carriers::{Carriers, RootMotion};
pub use inverse::Inversion;
pub use lockstep::LockstepSolver;
pub use partitioned::{FreeSpeeds, Partitioned};

use crate::{
    expr::{Expr, ExprGraph, Purpose},
    id::{BodyId, SpeedId},
    tree::Tree,
};

/// Entries of a symmetric matrix over speeds, by rows; what is structurally zero is the number zero.
pub type SpeedMatrix = Vec<Vec<Expr>>;

/// The matrix of zeros over so many speeds.
pub fn zero_matrix(graph: &mut ExprGraph, n_speeds: usize) -> SpeedMatrix {
    vec![vec![graph.zero(); n_speeds]; n_speeds]
}

/// A matrix times a column.
pub fn product(graph: &mut ExprGraph, matrix: &SpeedMatrix, column: &[Expr]) -> Vec<Expr> {
    let rows = matrix.iter().map(|row| {
        let mut sum = graph.zero();
        for (&entry, &factor) in row.iter().zip(column) {
            let term = graph.mul(entry, factor);
            sum = graph.add(sum, term);
        }
        sum
    });
    rows.collect()
}

/// A column with the other sign.
pub fn negated(column: Vec<Expr>) -> Vec<Expr> {
    column.into_iter().map(|entry| -entry).collect()
}

/// Rows of a matrix as its columns.
pub fn transposed(matrix: &[Vec<Expr>]) -> Vec<Vec<Expr>> {
    let columns = 0..matrix.first().map_or(0, Vec::len);
    let column = |column| matrix.iter().map(|row| row[column]).collect();
    columns.map(column).collect()
}

/// The factors of `A = L^T D L`.
#[derive(Debug)]
pub struct Factors {
    /// Speeds from the leaves inward: all, or those that are solved for.
    order: Vec<BodySpeed>,
    /// For each entry of `order`: the coupled speeds still to be eliminated, with the entry of L.
    couplings: Vec<Vec<(BodySpeed, Expr)>>,
    /// D, by speed.
    pub pivots: Vec<Expr>,
}

/// A row of L: a speed with what resists it, and the entries of those that are eliminated after it.
#[derive(Clone, Debug)]
pub struct FactorRow {
    /// The speed that is eliminated.
    pub speed: SpeedId,
    /// Its entry of D.
    pub pivot: Expr,
    /// Entries of L, none twice.
    pub entries: Vec<(SpeedId, Expr)>,
}

/// A speed, the body that moves with it, and its coordinate among that body's.
#[derive(Clone, Copy, Debug)]
struct BodySpeed {
    body: BodyId,
    speed: SpeedId,
    coordinate: &'static str,
}

impl BodySpeed {
    fn index(self) -> usize {
        self.speed.index()
    }
}

/// About how many operations factorisation and solution need for all speeds but the prescribed ones, where all entries along
/// paths to the inertial frame are there.
pub fn operations(tree: &Tree, prescribed: &BTreeSet<SpeedId>) -> usize {
    let mut coupled: Vec<usize> = Vec::with_capacity(tree.bodies.len());
    let mut sum = 0;
    for body in &tree.bodies {
        let below = body.lower.map_or(0, |lower| coupled[lower.index()]);
        let own = body.joint.speeds().into_iter();
        let own = own.filter(|(_, speed)| !prescribed.contains(speed)).count();
        // Each speed with n coupled ones below it: n factors, n (n + 1) / 2 updates, and 2 n terms of the solution.
        sum += (below..below + own).map(|n| n * (n + 6)).sum::<usize>();
        coupled.push(below + own);
    }
    sum
}

/// Subtracts from generalized forces what is needed beside accelerations, each in the scope of its body.
pub fn subtract(graph: &mut ExprGraph, tree: &Tree, tau: &mut [Expr], needed: &[Expr]) {
    for body in tree.body_ids() {
        graph.enter(body);
        for (_, speed) in tree.body(body).joint.speeds() {
            let force = &mut tau[speed.index()];
            *force = graph.sub(*force, needed[speed.index()]);
        }
    }
}

impl Factors {
    /// How many speeds the system has.
    fn n_speeds(&self) -> usize {
        self.pivots.len()
    }

    /// Those of a row for every speed, in the order in which they were eliminated.
    pub fn of_rows(tree: &Tree, rows: &[FactorRow]) -> Self {
        let mut speeds = elimination_order(tree);
        speeds.sort_by_key(|own| own.speed);
        let pivots = rows.iter().map(|row| (row.speed, row.pivot));
        let pivots: BTreeMap<SpeedId, Expr> = pivots.collect();
        let entries = |row: &FactorRow| {
            let entries = row.entries.iter();
            let entries = entries.map(|&(speed, entry)| (speeds[speed.index()], entry));
            entries.collect()
        };
        Self {
            order: rows.iter().map(|row| speeds[row.speed.index()]).collect(),
            couplings: rows.iter().map(entries).collect(),
            pivots: pivots.into_values().collect(),
        }
    }

    /// D on the diagonal, beside it the entries of L, each at the place of its two speeds and at the mirrored one.
    pub fn entries(&self, graph: &mut ExprGraph) -> SpeedMatrix {
        let n = self.pivots.len();
        let mut entries = zero_matrix(graph, n);
        for (&k, row) in self.order.iter().zip(&self.couplings) {
            entries[k.index()][k.index()] = self.pivots[k.index()];
            for &(speed, factor) in row {
                entries[k.index()][speed.index()] = factor;
                entries[speed.index()][k.index()] = factor;
            }
        }
        entries
    }

    /// `L^-T b`: the first half of a solution.
    fn eliminated(&self, graph: &mut ExprGraph, b: Vec<Expr>) -> Vec<Expr> {
        let mut columns = [b];
        self.eliminate(graph, &mut columns);
        let [half] = columns;
        half
    }

    /// The same of several columns, row by row.
    fn eliminate(&self, graph: &mut ExprGraph, columns: &mut [Vec<Expr>]) {
        graph.begin(Purpose::Solution);
        for (&k, row) in self.order.iter().zip(&self.couplings) {
            for &(speed, factor) in row {
                graph.enter(speed.body);
                for b in &mut *columns {
                    let term = graph.mul(factor, b[k.index()]);
                    b[speed.index()] = graph.sub(b[speed.index()], term);
                }
            }
        }
    }

    /// `D^-1 b`.
    fn scaled(&self, graph: &mut ExprGraph, b: &[Expr]) -> Vec<Expr> {
        graph.begin(Purpose::Solution);
        let mut scaled = b.to_vec();
        for &k in &self.order {
            graph.enter(k.body);
            let inverse = inverse(graph, k, self.pivots[k.index()]);
            scaled[k.index()] = graph.mul(b[k.index()], inverse);
        }
        scaled
    }

    /// The accelerations `x` with `A x = b`.
    pub fn solve(&self, graph: &mut ExprGraph, b: Vec<Expr>) -> Vec<Expr> {
        let mut b = self.eliminated(graph, b);
        for (&k, row) in self.order.iter().zip(&self.couplings).rev() {
            graph.enter(k.body);
            let inverse = inverse(graph, k, self.pivots[k.index()]);
            let mut x = graph.mul(b[k.index()], inverse);
            for &(speed, factor) in row {
                let term = graph.mul(factor, b[speed.index()]);
                x = graph.sub(x, term);
            }
            name_acceleration(graph, k, x);
            b[k.index()] = x;
        }
        b
    }

    /// Names a solution `theta1_ddot` and so on.
    pub fn name_accelerations(&self, graph: &mut ExprGraph, solved: &[Expr]) {
        for &k in &self.order {
            graph.enter(k.body);
            name_acceleration(graph, k, solved[k.index()]);
        }
    }
}

/// The speeds in the order in which they are eliminated.
pub fn elimination(tree: &Tree) -> Vec<usize> {
    let order = elimination_order(tree).into_iter();
    order.map(BodySpeed::index).collect()
}

/// The pairs of speeds, `[row, column]` with `column <= row`, row after row, at which the factors of a mass matrix may have
/// entries: those that are coupled, and where joints follow others on several branches those that elimination couples.
pub fn factor_places(tree: &Tree) -> BTreeSet<[usize; 2]> {
    let mut places = tree.coupled_speeds();
    if !tree.has_followers() {
        return places;
    }
    let pair = |a: usize, b: usize| [a.max(b), a.min(b)];
    let order = elimination(tree);
    for (place, &k) in order.iter().enumerate() {
        let coupled = order[place + 1..].iter().copied();
        let coupled: Vec<usize> = coupled
            .filter(|&own| places.contains(&pair(k, own)))
            .collect();
        for (i, &own) in coupled.iter().enumerate() {
            places.extend(coupled[..i].iter().map(|&other| pair(own, other)));
        }
    }
    places
}

/// The pairs of speeds, as above, at which the inverse of a mass matrix may have entries.
pub fn inverse_places(tree: &Tree) -> BTreeSet<[usize; 2]> {
    let group = groups(tree);
    let pairs = (0..tree.n_speeds).flat_map(|row| (0..=row).map(move |column| [row, column]));
    pairs
        .filter(|&[row, column]| group[row] == group[column])
        .collect()
}

/// Of each speed the first of all that are coupled with it, directly or by others: those of one tree at the root, and of trees that a
/// joint which follows another couples.
fn groups(tree: &Tree) -> Vec<usize> {
    let mut group: Vec<usize> = (0..tree.n_speeds).collect();
    for [row, column] in tree.coupled_speeds() {
        let (low, high) = (group[row].min(group[column]), group[row].max(group[column]));
        if low == high {
            continue;
        }
        for own in &mut group {
            if *own == high {
                *own = low;
            }
        }
    }
    group
}

fn name_acceleration(graph: &mut ExprGraph, k: BodySpeed, acceleration: Expr) {
    graph.name(acceleration, format!("{}_ddot", k.coordinate));
}

/// One over the pivot of a speed.
fn inverse(graph: &mut ExprGraph, k: BodySpeed, pivot: Expr) -> Expr {
    let inverse = graph.reciprocal(pivot);
    graph.name(inverse, format!("inverse_{}", k.coordinate));
    inverse
}

/// Bodies from the leaves inward; in a body its translations first, for they are not coupled with one another
/// before a body that it carries is eliminated, then its rotations. A speed that others follow has its own body's place.
fn elimination_order(tree: &Tree) -> Vec<BodySpeed> {
    let places = |body| {
        let joint = &tree.body(body).joint;
        let names = joint.motion_names();
        let speeds = joint.speeds().into_iter().rev();
        speeds.map(move |(motion, speed)| BodySpeed {
            body,
            speed,
            coordinate: names[motion],
        })
    };
    tree.body_ids().rev().flat_map(places).collect()
}
