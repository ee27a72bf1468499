//! Modules that pages name, such as `recursive::totals::energy`.

use std::{
    fs,
    path::{Path, PathBuf},
};

use crate::page::{self, repository};

/// The paths in a text that begin with a folder of the generator, those with braces one by one.
fn named(text: &str) -> Vec<String> {
    let spans = text.split('`').skip(1).step_by(2);
    let spans = spans.filter(|span| {
        let mut segments = span.split("::");
        let is_folder = |first: &str| {
            let first = first.trim();
            !first.is_empty() && repository("codegen/src").join(first).is_dir()
        };
        segments.next().is_some_and(is_folder) && span.contains("::")
    });
    spans
        .flat_map(|span| match span.split_once('{') {
            Some((before, within)) => {
                let within = within.trim_end_matches('}').split(',');
                within
                    .map(|own| format!("{before}{}", own.trim()))
                    .collect()
            }
            None => vec![span.to_owned()],
        })
        .collect()
}

/// True where it is of the generator, or of the runtime crate, which has the name of a folder there.
fn is_there(path: &str) -> bool {
    let of_runtime = path.strip_prefix("kane::");
    leads_on(repository("codegen/src"), path)
        || of_runtime.is_some_and(|path| leads_on(repository("src"), path))
}

/// True where modules lead to the last segment, or to files that have it.
fn leads_on(mut at: PathBuf, path: &str) -> bool {
    let plain = path.split(['<', '(']).next().unwrap_or_default();
    for segment in plain.split("::") {
        let below = at.join(segment);
        if !below.is_dir() && !below.with_extension("rs").is_file() {
            return files(&at).iter().any(|text| has(text, segment));
        }
        at = below;
    }
    true
}

/// The texts of a module: its file, and those of its folder, of which it may show what they have.
fn files(module: &Path) -> Vec<String> {
    let below = fs::read_dir(module).into_iter().flatten().flatten();
    let below = below.map(|entry| entry.path());
    let all = std::iter::once(module.with_extension("rs")).chain(below);
    all.filter_map(|file| fs::read_to_string(file).ok())
        .collect()
}

/// True where the text has it as a word.
fn has(text: &str, item: &str) -> bool {
    let is_of_word = |c: char| c.is_alphanumeric() || c == '_';
    text.split(|c| !is_of_word(c)).any(|word| word == item)
}

#[test]
fn every_module_that_a_page_names_is_there() {
    let (mut n_named, mut absent) = (0, Vec::new());
    for page in page::all() {
        let text = fs::read_to_string(repository(&page.path)).unwrap();
        for path in named(&text) {
            n_named += 1;
            if !is_there(&path) {
                absent.push(format!("{}: `{path}`", page.path));
            }
        }
    }
    assert!(n_named > 100, "{n_named}");
    assert_eq!(absent, [""; 0]);
}

#[test]
fn a_module_that_is_not_there_is_found() {
    let text = "`recursive::totals::{energy, enrgy}`, `functions::roots::jacobians`";
    let found: Vec<bool> = named(text).iter().map(|path| is_there(path)).collect();
    assert_eq!(found, [true, false, false]);
}
