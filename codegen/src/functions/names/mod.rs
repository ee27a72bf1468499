//! Names: those of what is generated, and those that other tools have for it.

mod absent;
pub(super) mod dictionary;
pub(super) mod elsewhere;
pub(super) mod generated_name;

/// What stands for all functions of the system.
pub const ALL: &str = "all";
/// What stands for the default set.
pub const DEFAULT: &str = "default";

/// True for a name that stands for several functions.
pub fn is_set(name: &str) -> bool {
    [ALL, DEFAULT].contains(&name)
}
