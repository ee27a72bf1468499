//! `kane completions`.

use std::io::Write;

use clap::{Args, Command};
use clap_complete::Shell;

use crate::cli::{Failures, Outcome};

/// Print a completion script for a shell
#[derive(Args, Debug)]
#[command(after_long_help = "Examples:\n  \
    kane completions bash > ~/.local/share/bash-completion/completions/kane\n  \
    kane completions fish > ~/.config/fish/completions/kane.fish")]
pub(crate) struct Arguments {
    /// The shell
    #[arg(value_name = "SHELL", value_enum)]
    shell: Shell,
}

/// Prints what completes this command.
pub(crate) fn run(
    arguments: &Arguments,
    mut command: Command,
    out: &mut dyn Write,
) -> Result<Outcome, Failures> {
    let mut text = Vec::new();
    clap_complete::generate(arguments.shell, &mut command, "kane", &mut text);
    out.write_all(&text)?;
    Ok(Outcome::Done)
}
