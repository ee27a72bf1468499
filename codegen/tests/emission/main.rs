//! Writing: from a model to the text of a module and of what stands beside it.

mod diffs;
mod interface;
mod module;
mod writing;
