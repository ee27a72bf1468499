//! What can be asked for and has no entries.

use super::Compiled;
use crate::{diagnostic::Diagnostic, tree::Tree};

/// A warning for each function that is differentiated by all values set at run time, where the model has none.
pub(crate) fn warnings(tree: &Tree, compiled: &Compiled) -> Vec<Diagnostic> {
    if !tree.parameters.is_empty() {
        return Vec::new();
    }
    let functions = compiled.functions.iter().map(|one| &one.request);
    let empty = functions.filter(|function| function.is_by_parameters());
    let warning = |text: String| {
        Diagnostic::warning(format!(
            "`{text}` has no column for `parameters`: the model sets no value at run time"
        ))
        .help("write `{ runtime = 1.2 }` for a number of a model in TOML; `kane convert` makes one of any model")
    };
    empty.map(|function| warning(function.text())).collect()
}
