//! What holds of any text whatever that is given to a reader, and of what is generated from it.
//!
//! Fuzzing asserts it of what it invents, tests of what fuzzing found.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "what asserts stops where something does not hold"
)]

use std::io;

use kane_codegen::description::{self, Description, Reading, toml};
use kane_codegen::diagnostic::{Diagnostic, Diagnostics, Source, SourceFile};
use kane_codegen::error::Error;
use kane_codegen::functions::{OF_FRAMES, Parsed};
use kane_codegen::generate::{Generated, generate};
use kane_codegen::options::Options;
use kane_codegen::tree::{self, Changes, Tree, canonical};

use crate::shown::steers;

/// Stands between the files of one text: the model, then those that it may include, as `1.xml`, `2.xml` and so on.
pub const BETWEEN_FILES: char = '\0';

/// A text as a model and the files that it may include.
#[derive(Debug)]
pub struct Files<'t> {
    pub model: Source,
    others: Vec<&'t str>,
}

impl<'t> Files<'t> {
    pub fn new(name: &str, text: &'t str) -> Self {
        let mut files = text.split(BETWEEN_FILES);
        Self {
            model: Source::new(name, files.next().unwrap_or_default()),
            others: files.collect(),
        }
    }

    fn include(&self, path: &str) -> io::Result<Vec<u8>> {
        let number = path.strip_suffix(".xml").and_then(|path| path.parse().ok());
        let number = number.and_then(|number: usize| number.checked_sub(1));
        let file = number.and_then(|number| self.others.get(number));
        let file = file.ok_or(io::ErrorKind::NotFound)?;
        Ok(file.as_bytes().to_vec())
    }
}

/// A model is read and checked, or told what is wrong with it, in places that it has, in characters that can be shown; a
/// model that is right is the same when it is written in our own format and read again.
pub fn reading(files: &Files<'_>, reading: &Reading) {
    let description = description::read(&files.model, reading, &|path| files.include(path));
    places_lie_in_the_files(&description.source, &description.faults);
    match tree::build_with(&description, &Changes::default()) {
        Ok(checked) => {
            assert!(!checked.warnings.has_error());
            can_be_shown(&checked.warnings);
            is_the_same_written(&description, &canonical(&checked.tree));
        }
        Err(faults) => {
            assert!(faults.has_error());
            can_be_shown(&faults);
        }
    }
}

fn places_lie_in_the_files(source: &Source, faults: &[Diagnostic]) {
    for (span, _) in faults.iter().flat_map(|fault| &fault.labels) {
        let lies_in = |file: &SourceFile| {
            let place = |at: usize| at.checked_sub(file.base());
            let (start, end) = (place(span.start), place(span.end));
            // The end of a file is a place, too; of what is missing there.
            start.zip(end).is_some_and(|(start, end)| {
                start <= end && start <= file.text().len() && end <= file.text().len() + 1
            })
        };
        assert!(source.files().any(lies_in), "{span:?} lies in no file");
    }
}

fn can_be_shown(findings: &Diagnostics) {
    places_lie_in_the_files(findings.source(), findings.list());
    let text = findings.to_string();
    assert!(findings.is_empty() || !text.is_empty());
    assert_eq!(text.chars().find(|c| steers(*c)), None, "{text:?}");
}

fn is_the_same_written(description: &Description, tree: &str) {
    let text = toml::write(description).unwrap();
    let again = toml::parse(&Source::new("written.toml", text.clone()));
    assert_eq!(toml::write(&again).unwrap(), text);
    let built = tree::build(&again).unwrap_or_else(|faults| panic!("{faults}"));
    assert_eq!(canonical(&built.tree), tree);
}

/// A module is generated, and each of its files is what it should be; or it is told why not.
pub fn generating(files: &Files<'_>, options: &Options) {
    let include = |path: &str| files.include(path);
    match generate(&files.model, "model", options, &include) {
        Ok(generated) => is_code(&generated, options, &tree_of(files, options)),
        Err(Error::Invalid(faults)) => can_be_shown(&faults),
        Err(error) => {
            let text = error.to_string();
            assert!(!text.contains(|c| c == '\n' || steers(c)), "{text:?}");
        }
    }
}

/// The functions asked for, in texts that can be parsed.
fn is_code(generated: &Generated, options: &Options, tree: &Tree) {
    can_be_shown(&generated.warnings);
    let names: Vec<&str> = generated
        .functions
        .iter()
        .map(|(name, _)| name.as_str())
        .collect();
    let asked = options.functions.requests();
    let asked = asked.iter().map(|asked| asked.on(tree).unwrap());
    let missing = asked
        .map(|asked| asked.name())
        .find(|name| !names.contains(&name.as_str()));
    assert_eq!(missing, None);
    let module = syn::parse_file(&generated.source).unwrap();
    let functions = module.items.iter().filter_map(|item| match item {
        syn::Item::Fn(function) => Some(function.sig.ident.to_string()),
        _ => None,
    });
    let functions: Vec<String> = functions.collect();
    let missing = names
        .iter()
        .find(|name| !functions.iter().any(|found| found == **name));
    assert_eq!(missing, None);
    for companion in &generated.companions {
        match companion.ending {
            ".json" => drop(serde_json::from_str::<serde_json::Value>(&companion.text).unwrap()),
            ".h" => assert!(!companion.text.contains(steers)),
            _ => drop(syn::parse_file(&companion.text).unwrap()),
        }
    }
}

/// The tree of a model that is right.
fn tree_of(files: &Files<'_>, options: &Options) -> Tree {
    let include = |path: &str| files.include(path);
    let description = description::read(&files.model, &options.reading, &include);
    let checked = tree::build_with(&description, &options.changes);
    checked.unwrap_or_else(|faults| panic!("{faults}")).tree
}

/// All functions of the frame of this name, as they are asked for: each in every kind of axes that it can have.
pub fn of_frame(name: &str) -> Vec<String> {
    let name = name.replace('"', "\"\"");
    let asked = OF_FRAMES.iter().flat_map(|function| {
        let axes = ["", ", local"];
        axes.map(|axes| format!("{}(\"{name}\"{axes})", function.name))
    });
    asked.filter(|asked| Parsed::read(asked).is_ok()).collect()
}

/// As many of these requests as one function can serve, joined from this one on; `None` if there are none. Of functions with
/// arguments of their own, such as points, it serves one.
pub fn joined(asked: &[String], first: usize) -> Option<String> {
    let first = first.checked_rem(asked.len())?;
    let others = asked[first + 1..].iter().chain(&asked[..first]);
    let joined = others.fold(asked[first].clone(), |joined, other| {
        let longer = format!("{joined}+{other}");
        match Parsed::read(&longer) {
            Ok(_) => longer,
            Err(_) => joined,
        }
    });
    Some(joined)
}

/// The name of one of the frames of a model, where it is right.
pub fn frame(files: &Files<'_>, reading: &Reading, choice: usize) -> Option<String> {
    let description = description::read(&files.model, reading, &|path| files.include(path));
    let tree = tree::build(&description).ok()?.tree;
    let frames: Vec<_> = tree.named_frames().collect();
    let frame = frames.get(choice.checked_rem(frames.len())?)?;
    Some(tree.frame_name(*frame).to_owned())
}

/// The bodies of a model, as far as they can be read.
pub fn n_bodies(files: &Files<'_>, reading: &Reading) -> usize {
    let description = description::read(&files.model, reading, &|path| files.include(path));
    description.bodies.len()
}

#[cfg(test)]
mod tests {
    use super::{Parsed, joined, of_frame};

    #[test]
    fn functions_of_a_frame_are_joined_from_any_on() {
        let asked = of_frame("a \"hand\"+");
        let has_own = |asked: &&String| {
            [
                "point_jacobian",
                "generalized_force",
                "linear_generalized_force",
            ]
            .iter()
            .any(|own| asked.starts_with(own))
        };
        let n_own = asked.iter().filter(has_own).count();
        assert!(n_own > 1, "{asked:?}");
        for (first, name) in asked.iter().enumerate() {
            let joined = joined(&asked, first).unwrap() + "(sin_cos)";
            assert!(joined.starts_with(name.as_str()));
            let parts = joined.matches("(\"a \"\"hand\"\"+\"").count();
            assert_eq!(parts, asked.len() - n_own + 1, "{joined}");
            assert!(Parsed::read(&joined).is_ok(), "{joined}");
        }
        assert_eq!(joined(&[], 3), None);
    }
}
