//! What a function computes, before any pass.

use crate::{
    expr::{Expr, ExprGraph},
    id::BodyMap,
    partition::{Partition, Row},
    tree::Tree,
};

/// What a function computes: expressions in a graph.
#[derive(Clone, Debug, Default)]
pub struct Derived {
    /// The graph.
    pub graph: ExprGraph,
    /// The outputs' entries, row-major, one output after the other.
    pub roots: Vec<Expr>,
    /// For a compact output: the non-zero partitions, body after body.
    pub blocks: Vec<CompactBlock>,
}

/// A non-zero partition of a body's partial velocities in a compact output.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CompactBlock {
    /// The body whose velocity it is, from 0.
    pub body: usize,
    /// The partition among the 2N of the notes, from 0.
    pub partition: usize,
    /// The first of its speeds, from 0.
    pub speed: usize,
    /// How many speeds, hence columns, it has.
    pub columns: usize,
    /// The place of its first column in the compact output.
    pub first: usize,
}

/// The non-zero partitions of every body's row.
pub fn pattern(tree: &Tree, rows: &BodyMap<Row>) -> Vec<CompactBlock> {
    let mut blocks = Vec::new();
    let mut first = 0;
    for (body, row) in rows.iter().enumerate() {
        for partition in row.partitions() {
            let speeds: Vec<_> = partition
                .free_columns(tree)
                .map(|(_, motion)| motion.speed.index())
                .collect();
            let index = Partition::index(partition, tree.bodies.len());
            blocks.push(CompactBlock {
                body,
                partition: index,
                speed: speeds[0],
                columns: speeds.len(),
                first,
            });
            first += speeds.len();
        }
    }
    blocks
}
