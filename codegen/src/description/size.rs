//! How large a model may be.

use crate::diagnostic::{Diagnostic, Source};
use crate::limits::{BODIES, INPUT_BYTES};

/// What is wrong where a file, with those that it includes, is larger than may be.
pub(crate) fn too_large(source: &Source) -> Option<Diagnostic> {
    let n_bytes: usize = source.files().map(|file| file.text().len()).sum();
    let message = format!("the model has {n_bytes} bytes; expected at most {INPUT_BYTES}");
    (n_bytes > INPUT_BYTES).then(|| Diagnostic::error(message))
}

/// What is wrong where there are more bodies, or entries of a list, than may be.
pub(crate) fn too_many(what: &str, count: usize) -> Option<Diagnostic> {
    let message = format!("{what} {count}; expected at most {BODIES}");
    (count > BODIES).then(|| Diagnostic::error(message))
}
