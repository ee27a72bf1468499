//! What functions do, as data: statements, what they compute, and where the numbers stand.

mod entry;
mod expression;
mod local;
mod stage;
mod statement;

pub use entry::{Entry, Member, Step};
pub use expression::{Expression, Tightness};
pub use local::{Array, ArrayId, Local, LocalId};
pub use stage::{Kept, Stage};
pub use statement::{Code, Statement};
