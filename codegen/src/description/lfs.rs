//! Files that Git LFS has not fetched yet.

use crate::diagnostic::{Diagnostic, Span};

/// What a file is that stands for another one.
pub(crate) const FOUND: &str = "is a Git LFS pointer, not the file";

/// What to do about it.
pub(crate) const ADVICE: &str = "run `git lfs pull`";

/// The first line of such a file, but for its end.
const FIRST_LINE: &str = "version https://git-lfs.github.com/spec/v1";

/// True for the contents of a file that stands for another one.
pub(crate) fn is_pointer(bytes: &[u8]) -> bool {
    bytes.starts_with(FIRST_LINE.as_bytes())
}

/// What is wrong with a file whose first byte has the place `base`, if it is such a pointer.
pub(crate) fn pointer(text: &str, base: usize) -> Option<Diagnostic> {
    let fault = || {
        Diagnostic::error(format!("this {FOUND}"))
            .at(Span::from(base..base + FIRST_LINE.len()), "a pointer")
            .help(ADVICE)
    };
    is_pointer(text.as_bytes()).then(fault)
}
