//! The catalogue of functions a user can ask for.
//!
//! In: a name. Out: a [`Function`], which says what it is given, what it writes, what that means, and how it is
//! derived; or names joined, and a [`Request`]. Afterwards: every request derives its outputs in a graph of its own, so its
//! text depends on the model and the options, never on what else is asked for. Does not: emit.

mod catalogue;
mod derive;
mod frames;
mod request;
mod signature;
mod terms;

use std::fmt;

pub use catalogue::CATALOGUE;
pub use request::{Output, Request, RequestError};
pub use signature::{Access, Declared, Element, Length, PACKED_LEN, PACKED_PLACES, Signature};

use crate::{
    expr::{Expr, ExprGraph},
    id::BodyMap,
    partition::{Partition, Row},
    recursive::Plan,
    tree::Tree,
};

/// A function of the generated module.
#[derive(Debug)]
pub struct Function {
    /// The name, of the free function and of the trait's method.
    pub name: &'static str,
    /// The runtime crate's trait; `None` for `q_dot` and `normalize`, which are part of `System`.
    pub trait_name: Option<&'static str>,
    /// What it is given besides the parameters, in order.
    pub arguments: &'static [Argument],
    /// The name of the output argument.
    pub output: &'static str,
    /// The shape of the output.
    pub shape: Shape,
    /// True for a function of the default set.
    pub is_default: bool,
    /// Lines of documentation: meaning, equation, frame, unit, signs, the aliases people search for.
    pub doc: &'static [&'static str],
    derive: Derivation,
}

/// An argument of a function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Argument {
    /// `q: &[R; NQ]`.
    Q,
    /// `u: &[R; NU]`.
    U,
    /// `u_dot: &[R; NU]`.
    UDot,
    /// `tau: &[R; NU]`.
    Tau,
    /// `loads: &[Load<R>; NB]`.
    Loads,
    /// `w_rel: &[[R; 3]; NB]`.
    RelativeAngularVelocity,
}

/// The shape of an output, row-major.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// One number.
    Scalar,
    /// `[R; 3]`.
    Vector,
    /// `[R; NQ]`.
    Coordinates,
    /// `[R; NU]`.
    Speeds,
    /// `[[R; NU]; NU]`.
    SpeedMatrix,
    /// `[R; MASS_MATRIX_PACKED_LEN]`: one number for every pair of [`Tree::coupled_speeds`].
    SpeedPairs,
    /// `[R; NB]`.
    BodyScalars,
    /// `[[R; 3]; NB]`.
    BodyVectors,
    /// `[[[R; 3]; 3]; NB]`.
    BodyMatrices,
    /// `[[R; 3]; NAME_COLUMNS]`: the columns of non-zero partitions, with their pattern beside the function.
    Columns,
}

/// How the sums over bodies are associated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Formulation {
    /// The notes' equations as they stand.
    Notes,
    /// Re-associated along the tree.
    Recursive,
}

/// What a function computes: expressions in a graph.
#[derive(Clone, Debug)]
pub struct Derived {
    /// The graph.
    pub graph: ExprGraph,
    /// The output's entries, row-major.
    pub roots: Vec<Expr>,
    /// For [`Shape::Columns`]: the non-zero partitions, body after body.
    pub blocks: Vec<Block>,
}

/// A non-zero partition of a body's partial velocities in a compact output.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Block {
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

type Entries = fn(&mut ExprGraph, &Tree) -> Vec<Expr>;
type PlannedEntries = fn(&mut ExprGraph, &Tree, &Plan) -> Vec<Expr>;
type Rows = fn(&mut ExprGraph, &Tree) -> BodyMap<Row>;

#[derive(Clone, Copy)]
enum Derivation {
    /// One formulation serves.
    Only(Entries),
    /// The sums over bodies can be associated in two ways.
    Either {
        notes: Entries,
        recursive: PlannedEntries,
        /// How many terms the literal sums have at least.
        literal_terms: fn(&Tree) -> usize,
    },
    /// Compact partial velocities.
    Compact(Rows),
}

impl Function {
    /// The function with this name.
    pub fn find(name: &str) -> Option<&'static Self> {
        CATALOGUE.iter().find(|function| function.name == name)
    }

    /// The formulations in which the function can be derived.
    pub fn formulations(&self) -> &'static [Formulation] {
        match self.derive {
            Derivation::Either { .. } => &[Formulation::Notes, Formulation::Recursive],
            Derivation::Only(_) | Derivation::Compact(_) => &[Formulation::Notes],
        }
    }

    /// How many terms the notes' sums have at least: where the re-associated ones need fewer operations than that,
    /// the literal ones need not be derived to know which is cheaper.
    pub fn literal_terms(&self, tree: &Tree) -> usize {
        match self.derive {
            Derivation::Either { literal_terms, .. } => literal_terms(tree),
            Derivation::Only(_) | Derivation::Compact(_) => 0,
        }
    }

    /// Derives the function; one that has a single formulation takes no notice of `formulation`, and only the recursive one
    /// of `plan`.
    pub fn derive(&self, tree: &Tree, formulation: Formulation, plan: &Plan) -> Derived {
        let mut derived = Derived {
            graph: ExprGraph::default(),
            roots: Vec::new(),
            blocks: Vec::new(),
        };
        self.derive_in(&mut derived, tree, formulation, plan);
        derived
    }

    /// Derives the function after others, in the same graph.
    fn derive_in(&self, derived: &mut Derived, tree: &Tree, formulation: Formulation, plan: &Plan) {
        let graph = &mut derived.graph;
        match (self.derive, formulation) {
            (Derivation::Only(entries), _)
            | (Derivation::Either { notes: entries, .. }, Formulation::Notes) => {
                derived.roots.extend(entries(graph, tree));
            }
            (Derivation::Either { recursive, .. }, Formulation::Recursive) => {
                derived.roots.extend(recursive(graph, tree, plan));
            }
            (Derivation::Compact(rows), _) => {
                let rows = rows(graph, tree);
                derived.blocks = pattern(tree, &rows);
                for row in rows.iter() {
                    let columns = row.columns(graph, tree);
                    let columns = columns.into_iter().flat_map(|(_, column)| column);
                    derived.roots.extend(columns);
                }
            }
        }
    }

    /// The constant that holds the pattern of a compact output.
    pub fn blocks_constant(&self) -> String {
        format!("{}_BLOCKS", self.name.to_uppercase())
    }

    /// The constant that holds the number of columns of a compact output.
    pub fn columns_constant(&self) -> String {
        format!("{}_COLUMNS", self.name.to_uppercase())
    }
}

/// The non-zero partitions of every body's row.
pub fn pattern(tree: &Tree, rows: &BodyMap<Row>) -> Vec<Block> {
    let mut blocks = Vec::new();
    let mut first = 0;
    for (body, row) in rows.iter().enumerate() {
        for partition in row.partitions() {
            let speeds: Vec<_> = partition
                .free_columns(tree)
                .map(|(_, motion)| motion.speed.index())
                .collect();
            let index = Partition::index(partition, tree.bodies.len());
            blocks.push(Block {
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

impl Argument {
    /// All of them, in the order in which functions are given them.
    pub const ALL: [Self; 6] = [
        Self::Q,
        Self::U,
        Self::UDot,
        Self::Tau,
        Self::Loads,
        Self::RelativeAngularVelocity,
    ];

    /// The argument's name in generated code.
    pub fn name(self) -> &'static str {
        match self {
            Self::Q => "q",
            Self::U => "u",
            Self::UDot => "u_dot",
            Self::Tau => "tau",
            Self::Loads => "loads",
            Self::RelativeAngularVelocity => "w_rel",
        }
    }
}

impl Shape {
    /// The lengths of the nested arrays, outermost first.
    pub fn lengths(self, tree: &Tree, n_columns: usize) -> Vec<usize> {
        let (n_bodies, n_speeds) = (tree.bodies.len(), tree.n_speeds);
        match self {
            Self::Scalar => vec![],
            Self::Vector => vec![3],
            Self::Coordinates => vec![tree.n_coordinates],
            Self::Speeds => vec![n_speeds],
            Self::SpeedMatrix => vec![n_speeds; 2],
            Self::SpeedPairs => vec![tree.coupled_speeds().len()],
            Self::BodyScalars => vec![n_bodies],
            Self::BodyVectors => vec![n_bodies, 3],
            Self::BodyMatrices => vec![n_bodies, 3, 3],
            Self::Columns => vec![n_columns, 3],
        }
    }
}

impl Formulation {
    /// "notes" or "recursive".
    pub fn name(self) -> &'static str {
        match self {
            Self::Notes => "notes",
            Self::Recursive => "recursive",
        }
    }
}

impl fmt::Debug for Derivation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Only(_) => "Only",
            Self::Either { .. } => "Either",
            Self::Compact(_) => "Compact",
        })
    }
}
