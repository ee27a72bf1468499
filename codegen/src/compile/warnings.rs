//! What can be asked for in vain.

use super::Compiled;
use crate::{diagnostic::Diagnostic, functions::Request, tree::Tree};

/// What has no entries, and what changes nothing.
pub(crate) fn warnings(tree: &Tree, compiled: &Compiled) -> Vec<Diagnostic> {
    let mut warnings = without_columns(tree, compiled);
    warnings.extend(without_effect(tree, compiled));
    let requests = compiled.functions.iter().map(|one| &one.request);
    warnings.extend(nothing_prescribed(tree, requests));
    warnings
}

/// A warning if speeds are prescribed and no function asks for which.
fn without_effect(tree: &Tree, compiled: &Compiled) -> Option<Diagnostic> {
    let mut functions = compiled.functions.iter();
    let is_heeded = functions.any(|one| one.request.prescribes());
    let is_in_vain = !tree.prescribed.is_empty() && !is_heeded;
    is_in_vain.then(|| {
        Diagnostic::warning("`prescribed` changes nothing: no function is of `hybrid_dynamics`")
            .help("add `hybrid_dynamics` to `functions`, or leave `prescribed` out")
    })
}

/// A warning if accelerations of some speeds can be given, and no speed is prescribed.
pub fn nothing_prescribed<'r>(
    tree: &Tree,
    requests: impl IntoIterator<Item = &'r Request>,
) -> Option<Diagnostic> {
    let asks = requests.into_iter().any(Request::prescribes);
    (asks && tree.prescribed.is_empty()).then(|| {
        Diagnostic::warning("`hybrid_dynamics` is forward dynamics: no joint is prescribed")
            .help("write `prescribed = [\"joint\"]` in kane.toml, or `--prescribed joint`")
    })
}

/// A warning for each function that is differentiated by all values set at run time, where the model has none.
fn without_columns(tree: &Tree, compiled: &Compiled) -> Vec<Diagnostic> {
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
