//! Names: those of what is generated, and those that other tools have for it.

mod absent;
pub(super) mod dictionary;
pub(super) mod elsewhere;
pub(super) mod generated_name;
