//! The listing: what a module says and what its functions do, as data, before any language.
//!
//! In: a tree, where it comes from, its programs. Out: a [`Module`]: facts, and functions with their statements in order.
//! Afterwards ([`verify`]): every local is assigned once, before it is read, and is read; every place of an output is stored once;
//! what is read is there; names of locals are unique identifiers in lower snake case. Whatever does not depend on a language is decided here.
//! Does not: write text. Printers do, and escape what their language reserves.

mod code;
pub(crate) mod constants;
mod facts;
mod function;
mod helper;
mod module;
mod verify;
mod write;

pub use code::{
    Array, ArrayId, Code, Entry, Expression, Kept, Local, LocalId, Member, Stage, Statement, Step,
    Tightness,
};
pub use constants::{Constant, Data};
pub(crate) use facts::N_ANGLES;
pub use facts::{
    Angle, BaseParameters, BaseTerm, Body, Colors, Counted, Extent, Facts, Frame, FrameSpeeds,
    Joint, JointChart, Limits, Mimic, Moved, PackedEntries, Pattern, Size, Sizes, Turned, Units,
    nominal, read_nominal,
};
pub use function::Function;
pub use helper::{Helper, Role};
pub use module::Module;
pub use verify::{Fault, verify, verify_facts};
pub use write::RESERVED;
