//! Names that nothing has.

use crate::description::xml::Reader;
use crate::diagnostic::{Diagnostic, Severity, Spanned, nearest};

/// As many names are too many to look for the one that was meant.
const MANY: usize = 1_000;

/// Tells with these words that nothing has the name, and which one may be meant.
pub(super) fn unknown<'n>(
    reader: &mut Reader,
    message: String,
    name: Spanned<&str>,
    names: impl ExactSizeIterator<Item = &'n str>,
) {
    let mut fault = Diagnostic::error(message).at(name.span, "unknown");
    // Looking through very many names very often would take too long.
    if names.len() < MANY && !reader.faults.is_full(Severity::Error) {
        let names: Vec<&str> = names.collect();
        if let Some(near) = nearest(name.value, &names) {
            fault = fault.help(format!("did you mean `{near}`?"));
        }
    }
    reader.faults.push(fault);
}
