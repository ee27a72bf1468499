//! Whether every free coordinate moves mass.

#![expect(
    clippy::unwrap_used,
    clippy::panic,
    reason = "helpers of tests fail as tests do"
)]

mod followers;
pub(crate) mod mass_matrix;
mod rank;
mod trees;
