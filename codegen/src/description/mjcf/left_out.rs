//! What is left out: the warnings, and how the user asks for it.

use crate::description::xml::Reader;
use crate::diagnostic::{Diagnostic, Escaped, Span};

/// Warns of something that is left out; the kind is that of [`Diagnostic::one_of`].
pub(super) fn left_out(reader: &mut Reader, message: String, span: Span, kind: (&str, &str)) {
    let warning = Diagnostic::warning(message).at(span, "left out");
    let (plural, subject) = kind;
    reader.faults.push(warning.one_of(plural, subject));
}

/// How the user leaves out what has this name.
pub(super) fn advice(name: &str) -> String {
    let name = name.escaped();
    format!(
        "`--leave-out {name}` leaves it out, and so does `leave_out = [\"{name}\"]` in `kane.toml`"
    )
}
