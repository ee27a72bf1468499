//! The command `kane`: arguments in, one call, errors to stderr, exit code out.

mod cli;

use std::{io, process::ExitCode};

use clap::Parser as _;

fn main() -> ExitCode {
    let arguments = cli::Arguments::parse();
    let mut out = cli::Pipe::new(io::stdout().lock());
    match cli::run(&arguments, &mut out) {
        Ok(outcome) => outcome.into(),
        Err(failures) => {
            cli::say(&failures);
            ExitCode::from(cli::BAD_INPUT)
        }
    }
}
