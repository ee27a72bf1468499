//! Writing: from a model to the text of a module and of what stands beside it.

mod build_script;
mod diffs;
mod header;
mod helpers;
mod interface;
mod listing;
mod long;
mod module;
mod names;
mod nesting;
mod reserved;
mod writing;
