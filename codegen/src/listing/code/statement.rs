//! What a function does, statement by statement.

use super::{Array, ArrayId, Entry, Expression, Local, LocalId};

/// The statements of a function, in order, and the locals that they assign.
#[derive(Clone, Debug, Default)]
pub struct Code {
    /// The locals, in the order in which they are assigned.
    pub locals: Vec<Local>,
    /// The local arrays, in the order in which they are assigned.
    pub arrays: Vec<Array>,
    /// What is done.
    pub statements: Vec<Statement>,
}

/// One step.
#[derive(Clone, Debug, PartialEq)]
pub enum Statement {
    /// A local is given a value: what an argument holds, or what is computed.
    Assign {
        /// The local.
        local: LocalId,
        /// The value.
        value: Expression,
    },
    /// The sine and cosine of one angle.
    SinCos {
        /// The angle.
        angle: Expression,
        /// What its sine is given to, where that is used.
        sine: Option<LocalId>,
        /// The same of its cosine.
        cosine: Option<LocalId>,
    },
    /// Sines and cosines of several angles together, so that they vectorise.
    SinCosArray {
        /// The angles.
        angles: Vec<Expression>,
        /// Their sines.
        sines: ArrayId,
        /// Their cosines.
        cosines: ArrayId,
    },
    /// The same, to where they are to be stored.
    StoreSinCos {
        /// The angles.
        angles: Vec<Expression>,
        /// Where their sines go.
        sines: Vec<Entry>,
        /// Where their cosines go.
        cosines: Vec<Entry>,
    },
    /// A helper of the function is run on several columns.
    Call {
        /// The helper, by its place.
        helper: usize,
        /// What all columns share, an argument by its place, if there is any.
        shared: Option<usize>,
        /// What is of each: a row for each number, with one of every lane.
        sides: usize,
        /// What it computes, in such rows.
        solved: ArrayId,
    },
    /// A number goes to its place in an output.
    Store {
        /// The place.
        place: Entry,
        /// The number.
        value: Expression,
        /// True where a compiler is not to join it with stores after it.
        is_apart: bool,
    },
    /// No instruction: words about the statements that follow.
    Heading(String),
}

impl Code {
    /// A local.
    pub fn local(&self, id: LocalId) -> &Local {
        &self.locals[id.index()]
    }

    /// A local array.
    pub fn array(&self, id: ArrayId) -> &Array {
        &self.arrays[id.index()]
    }
}

impl Statement {
    /// The locals that it assigns.
    pub fn assigned(&self) -> impl Iterator<Item = LocalId> + use<> {
        let pair = match self {
            Self::Assign { local, .. } => [Some(*local), None],
            Self::SinCos { sine, cosine, .. } => [*sine, *cosine],
            Self::SinCosArray { .. }
            | Self::StoreSinCos { .. }
            | Self::Call { .. }
            | Self::Store { .. }
            | Self::Heading(_) => [None; 2],
        };
        pair.into_iter().flatten()
    }

    /// The arrays that it fills.
    pub fn filled(&self) -> impl Iterator<Item = ArrayId> + use<> {
        let pair = match self {
            Self::SinCosArray { sines, cosines, .. } => [Some(*sines), Some(*cosines)],
            Self::Call { solved, .. } => [Some(*solved), None],
            _ => [None; 2],
        };
        pair.into_iter().flatten()
    }

    /// What it computes.
    pub fn values(&self) -> &[Expression] {
        match self {
            Self::Assign { value, .. } | Self::Store { value, .. } => std::slice::from_ref(value),
            Self::SinCos { angle, .. } => std::slice::from_ref(angle),
            Self::SinCosArray { angles, .. } | Self::StoreSinCos { angles, .. } => angles,
            Self::Call { .. } | Self::Heading(_) => &[],
        }
    }

    /// The places to which it stores.
    pub fn stored(&self) -> impl Iterator<Item = &Entry> {
        let (one, sines, cosines): (_, &[_], &[_]) = match self {
            Self::Store { place, .. } => (Some(place), &[], &[]),
            Self::StoreSinCos { sines, cosines, .. } => (None, sines, cosines),
            _ => (None, &[], &[]),
        };
        one.into_iter().chain(sines).chain(cosines)
    }
}
