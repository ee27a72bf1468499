//! The pattern of partitions of every body's partial velocities: Eqs. (16) and (30), and (32) with them.
//!
//! In: a tree. Out: for each body the 2N cells of `W_K`, `V_O_K` and `V_G_K`. Partition J of the notes, for J from 1
//! to N, multiplies the rates of body J's angles; partition N + J those of its translations.

use std::fmt;

use crate::{
    expr::ExprGraph,
    id::{BodyId, BodyMap},
    kane::{orientation, velocity},
    partition::{Block, Partition, Row},
    tree::Tree,
};

/// What stands at a partition.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cell {
    /// Zero: never built, stored or emitted. Also where the joint leaves none of the three coordinates free.
    Zero,
    /// The identity.
    Identity,
    /// `P_K` of Eq. (17), in the body's own partition of `W_K`.
    Own,
    /// Any other block.
    Full,
}

/// The patterns, body after body; each row has 2N cells.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Partitions {
    /// `W_K`, Eq. (16): of the angular velocity.
    pub angular: Vec<Vec<Cell>>,
    /// `V_O_K`, Eq. (30): of the velocity of the body's origin.
    pub origin: Vec<Vec<Cell>>,
    /// `V_G_K`, Eq. (32): of the velocity of the body's mass centre.
    pub mass_center: Vec<Vec<Cell>>,
}

/// The patterns of a tree.
pub fn partitions(tree: &Tree) -> Partitions {
    let mut graph = ExprGraph::default();
    let relative = orientation::relative(&mut graph, tree);
    let rows = velocity::partials(&mut graph, tree, &relative);
    let cells = |rows: &BodyMap<Row>| {
        let row = |(_, row): (_, &Row)| cells(tree, row);
        tree.body_ids().zip(rows.iter()).map(row).collect()
    };
    let mut angular: Vec<Vec<Cell>> = cells(&rows.angular);
    for (row, body) in angular.iter_mut().zip(tree.body_ids()) {
        mark_own(row, body);
    }
    Partitions {
        angular,
        origin: cells(&rows.origin),
        mass_center: cells(&rows.mass_center),
    }
}

fn cells(tree: &Tree, row: &Row) -> Vec<Cell> {
    let n_bodies = tree.bodies.len();
    let mut cells = vec![Cell::Zero; 2 * n_bodies];
    for (partition, block) in row.blocks() {
        cells[Partition::index(partition, n_bodies)] = match block {
            Block::Identity => Cell::Identity,
            Block::Full(_) => Cell::Full,
        };
    }
    cells
}

fn mark_own(row: &mut [Cell], body: BodyId) {
    let own = &mut row[body.index()];
    if *own == Cell::Full {
        *own = Cell::Own;
    }
}

impl fmt::Display for Cell {
    /// `.`, `1`, `P` or `x`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Zero => ".",
            Self::Identity => "1",
            Self::Own => "P",
            Self::Full => "x",
        })
    }
}
