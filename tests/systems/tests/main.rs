//! Generated systems, compiled, against references and identities, and what their text consists of.

mod common;
mod identities;
mod parameters;
mod references;
mod text;
