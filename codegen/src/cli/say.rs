//! What the user is told beside results.

use std::{
    fmt,
    io::{self, Write},
};

use kane_codegen::diagnostic::printable;

/// Tells the user something on standard error. Where nobody can hear it, it is not worth stopping for.
pub(crate) fn say(text: impl fmt::Display) {
    let text = text.to_string();
    drop(writeln!(io::stderr(), "{}", printable(&text)));
}
