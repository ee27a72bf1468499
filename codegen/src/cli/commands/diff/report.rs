//! What differs between two models or modules, and between what.

use std::collections::BTreeMap;

use kane_codegen::{
    diagnostic::Diagnostics,
    origin,
    report::{self, Comparison, Differences, FormChange, Meaning, Redeclared},
};

use super::side::Described;
use crate::cli::text::{lines::ChangedLines, text_diff::TextDiff};

/// How modules of one model came to differ.
#[derive(Clone, Copy)]
pub(super) enum Rewriting {
    /// They are one text in two layouts.
    Layout,
    /// Their banners name the same input.
    SameInput,
    /// Generators of these formats wrote them.
    Formats([u32; 2]),
}

/// What differs, and between what.
pub(super) struct Report {
    /// As the user wrote them, or as git would write them.
    pub(super) names: [String; 2],
    pub(super) fingerprints: [Option<u64>; 2],
    pub(super) differences: Differences,
    pub(super) functions: Comparison,
    /// Functions that are gone, or have other arguments.
    pub(super) redeclared: Vec<Redeclared>,
    /// Places that mean something else.
    pub(super) meanings: Vec<Meaning>,
    /// How base parameters differ, where code need not change for it.
    pub(super) base: Option<Meaning>,
    /// Of two modules, the arrays that hold something else.
    pub(super) held: Vec<Meaning>,
    /// Where bodies and places are the same, long functions that are written in another form.
    pub(super) forms: Vec<FormChange>,
    /// What should be known about the new model, and not about the old one.
    pub(super) warnings: Option<Diagnostics>,
    /// How the texts came to differ, where they say it.
    pub(super) rewriting: Option<Rewriting>,
    /// Options that the texts do not have alike, by their keys, but for functions, which are told one by one.
    pub(super) options: BTreeMap<String, [Option<String>; 2]>,
    /// The models that the texts name, where these differ.
    pub(super) moved: Option<[String; 2]>,
    /// The unified diff of the texts; empty where they are the same.
    pub(super) diff: String,
    /// How much of it there is; `None` where the texts are the same.
    pub(super) lines: Option<ChangedLines>,
}

impl Report {
    pub(super) fn new(names: [&str; 2], [old, new]: [&Described; 2]) -> Self {
        let modules = [old, new].map(|known| &known.module);
        let mut meanings = modules[0].meanings(modules[1]);
        let differences = report::differences(&old.outline, &new.outline);
        meanings.extend(report::turned(&old.outline, &new.outline, &differences));
        let texts = [old, new].map(|known| known.text.as_str());
        let base = modules[0].base_parameters_changed(modules[1]);
        let is_told = |own: &Meaning| own.name.starts_with("BASE_PARAMETERS");
        let base = base.filter(|_| !meanings.iter().any(is_told));
        let are_models = old.warnings.is_some() || new.warnings.is_some();
        let held = if are_models {
            Vec::new()
        } else {
            modules[0].held(modules[1])
        };
        let forms = if differences.has_same_bodies() {
            modules[0].forms(modules[1])
        } else {
            Vec::new()
        };
        let diff = TextDiff::new(texts[0], texts[1]);
        let is_same = texts[0] == texts[1];
        let mut options = origin::changed_options(texts);
        options.remove("functions");
        let lines = (!is_same).then(|| ChangedLines::of(&diff, texts[0], texts[1]));
        let diff = diff.unified([(names[0], "old"), (names[1], "new")]);
        Self {
            names: names.map(str::to_owned),
            fingerprints: [old, new].map(|known| known.outline.fingerprint),
            differences,
            functions: modules[0].compare(modules[1]),
            redeclared: modules[0].redeclared(modules[1]),
            meanings,
            base,
            held,
            forms,
            warnings: new.news(old),
            rewriting: lines
                .as_ref()
                .filter(|_| !are_models)
                .and_then(|lines| rewriting(lines, texts)),
            options,
            moved: moved(texts),
            diff,
            lines,
        }
    }

    /// True where an array's places or their names changed, or mean something else, or where a function is gone or has other arguments.
    pub(super) fn is_breaking(&self) -> bool {
        self.differences.is_breaking() || !(self.redeclared.is_empty() && self.meanings.is_empty())
    }

    pub(super) fn is_same(&self) -> bool {
        self.differences == Differences::default() && self.diff.is_empty()
    }
}

/// How two modules came to differ in these lines.
fn rewriting(lines: &ChangedLines, texts: [&str; 2]) -> Option<Rewriting> {
    if lines.are_layout() {
        Some(Rewriting::Layout)
    } else if moved(texts).is_none() && origin::have_one_input(texts) {
        Some(Rewriting::SameInput)
    } else {
        formats(texts).map(Rewriting::Formats)
    }
}

/// The formats of the texts, where these differ.
fn formats(texts: [&str; 2]) -> Option<[u32; 2]> {
    let [Some(old), Some(new)] = texts.map(origin::format_of) else {
        return None;
    };
    (old != new).then_some([old, new])
}

fn moved(texts: [&str; 2]) -> Option<[String; 2]> {
    let [Some(old), Some(new)] = texts.map(|text| origin::model_of(text.as_bytes())) else {
        return None;
    };
    (old != new).then_some([old, new])
}
