//! What the user is told beside results, on standard error: little, unless more is asked for.

use std::{
    fmt,
    io::{self, Write},
};

use clap::Args;
use kane_codegen::diagnostic::{Diagnostic, Diagnostics, Severity, printable};

/// How much is told.
#[derive(Args, Clone, Copy, Debug)]
pub(crate) struct Voice {
    /// Print everything: each warning and note in full, and each file
    #[arg(
        long,
        short,
        global = true,
        conflicts_with = "quiet",
        display_order = 900
    )]
    verbose: bool,

    /// Print neither notes nor warnings, except those that may explain an error
    #[arg(long, short, global = true, display_order = 901)]
    quiet: bool,
}

impl Voice {
    /// Tells something.
    pub(crate) fn say(self, text: impl fmt::Display) {
        if !self.quiet {
            say(text);
        }
    }

    /// Tells something to those who want to know everything.
    pub(crate) fn detail(self, text: impl fmt::Display) {
        if self.verbose {
            say(text);
        }
    }

    /// True where nothing but errors is told.
    pub(crate) fn is_quiet(self) -> bool {
        self.quiet
    }

    /// True where everything is told.
    pub(crate) fn is_verbose(self) -> bool {
        self.verbose
    }

    /// Tells what should be known about a model: a line a kind, or each at full length.
    pub(crate) fn warn(self, warnings: &Diagnostics) {
        self.warn_of(warnings, |_| true);
    }

    /// The same without notes, where the result says it, or is asked for again and again.
    pub(crate) fn warn_without_notes(self, warnings: &Diagnostics) {
        self.warn_of(warnings, |one| one.severity != Severity::Note);
    }

    /// The same with those notes alone that say which numbers are computed with, where numbers are shown.
    pub(crate) fn warn_of_numbers(self, warnings: &Diagnostics) {
        self.warn_of(warnings, |one| {
            one.severity != Severity::Note || one.changes_numbers
        });
    }

    fn warn_of(self, warnings: &Diagnostics, is_told: impl Fn(&Diagnostic) -> bool) {
        if warnings.is_empty() {
            return;
        }
        if self.verbose {
            self.say(format_args!("{warnings}\n"));
            return;
        }
        let told = warnings.list().iter().filter(|one| is_told(one));
        let told = Diagnostics::new(warnings.source().clone(), told.cloned().collect());
        let brief = told.brief();
        let lines = brief.lines.iter();
        let lines: Vec<&str> = lines.map(|(_, line)| line.as_str()).collect();
        if lines.is_empty() {
            return;
        }
        let more = if brief.is_shortened {
            " (all: --verbose)"
        } else {
            ""
        };
        self.say(format_args!("{}{more}", lines.join("\n")));
    }
}

/// Tells the user something, whatever was asked for. Where nobody can hear it, it is not worth stopping for.
pub(crate) fn say(text: impl fmt::Display) {
    let text = text.to_string();
    drop(writeln!(io::stderr(), "{}", printable(&text)));
}
