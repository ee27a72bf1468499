//! Names that nothing has.

use crate::description::xml::Reader;
use crate::diagnostic::{Diagnostic, Spanned};

/// Tells with these words that nothing has the name, and which one may be meant.
pub(super) fn unknown<'n>(
    reader: &mut Reader,
    message: String,
    name: Spanned<&str>,
    names: impl Iterator<Item = &'n str>,
) {
    let mut fault = Diagnostic::error(message).at(name.span, "unknown");
    if let Some(near) = reader.near.nearest(name.value, names) {
        fault = fault.help(format!("did you mean `{near}`?"));
    }
    reader.faults.push(fault);
}
