//! What several subcommands are told: which systems, and what is made of them.

pub(super) mod changes;
pub(super) mod functions;
pub(super) mod options;
pub(super) mod parse;
pub(super) mod selection;
