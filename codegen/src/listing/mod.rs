//! The listing: what a module says and what its functions do, as data, before any language.
//!
//! In: a tree, where it comes from, its programs. Out: a [`Module`]: facts, and functions with their statements in order.
//! Afterwards ([`verify`]): every local is assigned once, before it is read, and is read; every place of an output is stored once;
//! what is read is there; names are unique identifiers in lower snake case. Whatever does not depend on a language is decided here.
//! Does not: write text. Printers do, and escape what their language reserves.

mod base_parameters;
mod code;
pub(crate) mod constants;
mod entries;
mod entry;
mod expression;
mod extent;
mod facts;
mod frame_speeds;
mod function;
mod group;
mod headings;
mod helper;
mod joint;
mod limits;
mod local;
mod loops;
mod module;
mod name;
mod plain;
mod scratch;
mod size;
mod stages;
mod stated;
mod statement;
mod stores;
mod verify;
mod writer;

pub use base_parameters::{BaseParameters, BaseTerm};
pub use constants::{Constant, Data};
pub use entries::{Colors, Entries};
pub use entry::{Entry, Member, Step};
pub use expression::{Expression, Tightness};
pub use extent::Extent;
pub use facts::{Angle, Body, Facts, Pattern};
pub use frame_speeds::FrameSpeeds;
pub use function::Function;
pub use helper::{SHARED, SIDES, SOLVED};
pub use joint::{Frame, Joint, JointChart};
pub use limits::Limits;
pub use local::{Array, ArrayId, Local, LocalId};
pub use module::Module;
pub use name::RESERVED;
pub(crate) use size::N_ANGLES;
pub use size::{Size, Sizes};
pub use stages::{Kept, Stage};
pub use stated::{Counted, nominal, read_nominal};
pub use statement::{Code, Statement};
pub use verify::{Fault, verify, verify_facts};
