//! Faults of an input file, in the user's words, with the place where each stands.
//!
//! In: a [`Source`] and what is wrong with it. Out: text that shows `file:line:column`, the line and a
//! label below it, of each file that it is about; or, of what is no error, a line a kind. Afterwards: the faults stand in
//! the order of the file. Does not: decide what is a fault.
//!
//! Messages are lower case, without a final stop, with the user's own names, and say what was found and what was expected.

mod brief;
mod fault;
mod list;
mod near;
mod render;
mod source;
mod words;

pub use brief::Brief;
pub use fault::{Diagnostic, Entry, Kind, Severity};
pub use list::{Diagnostics, Faults};
pub use near::{NearNames, nearest};
pub use source::{Source, SourceFile, Span, Spanned};
pub use words::{Escaped, count, first_few, printable};
pub(crate) use words::{backquoted, is_unprintable, shown, shown_name};
