//! How a command ended, and the exit code that says so.

use std::process::ExitCode;

/// Exit code: nothing to complain about.
const DONE: u8 = 0;
/// Exit code: a generated file differs, is missing, is over budget, or is produced by nothing; a promise is broken.
const DIFFERS: u8 = 1;
/// Exit code: bad input or a file that cannot be accessed.
pub(crate) const BAD_INPUT: u8 = 2;

/// How a command ended that was not given bad input.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Outcome {
    /// Done, or everything is the same.
    Done,
    /// Something differs.
    Differs,
    /// A promise is broken.
    Broken,
}

impl From<Outcome> for ExitCode {
    fn from(outcome: Outcome) -> Self {
        Self::from(match outcome {
            Outcome::Done => DONE,
            Outcome::Differs | Outcome::Broken => DIFFERS,
        })
    }
}
