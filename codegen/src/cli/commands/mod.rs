//! One subcommand each: its arguments with their documentation, and `run`.

pub(super) mod check;
pub(super) mod completions;
pub(super) mod convert;
pub(super) mod diff;
pub(super) mod eval;
pub(super) mod generate;
pub(super) mod info;
pub(super) mod new;
pub(super) mod verify;
