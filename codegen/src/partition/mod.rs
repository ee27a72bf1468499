//! Rows of partitions: partial velocities as Eqs. (16) and (30) show them.
//!
//! In: 3x3 blocks and vectors of expressions. Out: [`Row`]s, maps from partition to block.
//! Afterwards: which partitions a row holds follows from the tree and its free coordinates, never from
//! values; a partition that is absent is zero and was never built, multiplied or stored.
//! Does not: know the equations; they are in `kane`.

use std::collections::BTreeMap;

use crate::{
    expr::{ExprGraph, Matrix, Vector, transpose},
    id::{BodyId, SpeedId},
    tree::{Motion, Tree},
};

/// One column block of a 3 x 6N matrix of partial velocities.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Partition {
    /// The rates of the body's three angles: partition K of the notes.
    Angles(BodyId),
    /// The rates of the body's three translations: partition N + K.
    Translations(BodyId),
}

/// A block that is not zero.
#[derive(Clone, Copy, Debug)]
pub enum Block {
    /// The identity.
    Identity,
    /// Nine expressions, by rows.
    Full(Matrix),
}

/// A 3 x 6N matrix that holds only its non-zero partitions, in the order of the notes.
#[derive(Clone, Debug, Default)]
pub struct Row {
    blocks: BTreeMap<Partition, Block>,
}

impl Partition {
    /// The body whose speeds the partition multiplies.
    pub fn body(self) -> BodyId {
        let (Self::Angles(body) | Self::Translations(body)) = self;
        body
    }

    /// The partition's place among the 2N of the notes, from 0.
    pub fn index(self, n_bodies: usize) -> usize {
        match self {
            Self::Angles(body) => body.index(),
            Self::Translations(body) => n_bodies + body.index(),
        }
    }

    /// The three motions of the partition.
    pub fn motions(self, tree: &Tree) -> [Option<Motion>; 3] {
        let joint = &tree.body(self.body()).joint;
        match self {
            Self::Angles(_) => joint.turns(),
            Self::Translations(_) => joint.shifts(),
        }
    }

    /// The columns of the partition that speeds move.
    pub fn free_columns(self, tree: &Tree) -> impl Iterator<Item = (usize, Motion)> {
        let motions = self.motions(tree).into_iter().enumerate();
        motions.filter_map(|(column, motion)| Some((column, motion?)))
    }
}

impl Row {
    /// The row whose one block is `block` at `partition`; no block at all where nothing there is free.
    pub fn single(tree: &Tree, partition: Partition, block: Block) -> Self {
        let free = partition.free_columns(tree).next().is_some();
        Self {
            blocks: free.then_some((partition, block)).into_iter().collect(),
        }
    }

    /// The partitions that are not zero, in the order of the notes.
    pub fn partitions(&self) -> impl Iterator<Item = Partition> + '_ {
        self.blocks.keys().copied()
    }

    /// The blocks that are not zero.
    pub fn blocks(&self) -> impl Iterator<Item = (Partition, Block)> + '_ {
        self.blocks
            .iter()
            .map(|(&partition, &block)| (partition, block))
    }

    /// `self + other`: only blocks that both rows hold are added.
    #[must_use]
    pub fn plus(mut self, graph: &mut ExprGraph, other: Self) -> Self {
        for (partition, block) in other.blocks {
            let sum = match self.blocks.get(&partition) {
                None => block,
                Some(present) => {
                    let (a, b) = (present.matrix(graph), block.matrix(graph));
                    Block::Full(std::array::from_fn(|i| graph.add_vectors(a[i], b[i])))
                }
            };
            self.blocks.insert(partition, sum);
        }
        self
    }

    /// `m self`; the identity becomes `m` without an operation.
    #[must_use]
    pub fn premultiplied(&self, graph: &mut ExprGraph, m: &Matrix) -> Self {
        self.map(|block| match block {
            Block::Identity => *m,
            Block::Full(matrix) => graph.mul_matrices(m, &matrix),
        })
    }

    /// `-tilde(v) self`: column by column, the cross product with `v` from the right.
    #[must_use]
    pub fn crossed(&self, graph: &mut ExprGraph, v: Vector) -> Self {
        self.map(|block| {
            let matrix = block.matrix(graph);
            let columns = std::array::from_fn(|j| graph.cross(matrix.map(|row| row[j]), v));
            transpose(&columns)
        })
    }

    /// A column for every motion of the partitions that the row holds, with its speed. A speed that moves several
    /// joints has several: their sum is its own.
    pub fn columns(&self, graph: &mut ExprGraph, tree: &Tree) -> Vec<(SpeedId, Vector)> {
        let mut columns = Vec::new();
        for (partition, block) in self.blocks() {
            let matrix = block.matrix(graph);
            for (j, Motion { speed, factor }) in partition.free_columns(tree) {
                let factor = graph.number(factor);
                let column = graph.scale(factor, matrix.map(|row: Vector| row[j]));
                columns.push((speed, column));
            }
        }
        columns
    }

    /// The column of every speed that the row holds.
    pub fn merged_columns(&self, graph: &mut ExprGraph, tree: &Tree) -> Vec<(SpeedId, Vector)> {
        let mut places: BTreeMap<SpeedId, usize> = BTreeMap::new();
        let mut merged: Vec<(SpeedId, Vector)> = Vec::new();
        for (speed, column) in self.columns(graph, tree) {
            if let Some(&place) = places.get(&speed) {
                merged[place].1 = graph.add_vectors(merged[place].1, column);
            } else {
                places.insert(speed, merged.len());
                merged.push((speed, column));
            }
        }
        merged
    }

    /// Labels every entry with `text`, the partition's body and its place.
    pub fn name(&self, graph: &mut ExprGraph, tree: &Tree, text: &str) {
        for (partition, block) in self.blocks() {
            if let Block::Full(matrix) = block {
                let body = tree.body(partition.body());
                let first = if matches!(partition, Partition::Angles(_)) {
                    0
                } else {
                    3
                };
                let names = body.joint.motion_names();
                let body = &body.identifier;
                for (column, _) in partition.free_columns(tree) {
                    let text = format!("{text}_{body}_{}", names[first + column]);
                    graph.name_vector(matrix.map(|row: Vector| row[column]), &text);
                }
            }
        }
    }

    fn map(&self, mut f: impl FnMut(Block) -> Matrix) -> Self {
        let blocks = self
            .blocks
            .iter()
            .map(|(&partition, &block)| (partition, Block::Full(f(block))))
            .collect();
        Self { blocks }
    }
}

impl Block {
    /// The nine expressions.
    pub fn matrix(self, graph: &mut ExprGraph) -> Matrix {
        match self {
            Self::Identity => graph.identity(),
            Self::Full(matrix) => matrix,
        }
    }
}
