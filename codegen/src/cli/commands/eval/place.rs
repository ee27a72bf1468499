//! Where a value stands in a state: its path, as messages show it, and its place in the text.

use std::{collections::BTreeMap, fmt};

use kane_codegen::diagnostic::{Escaped, Span};
use serde_json::value::RawValue;

/// The path of a value from the whole file: `loads[2].force`.
#[derive(Clone, Debug)]
pub(super) struct Place {
    steps: Vec<Step>,
    shown: String,
}

/// A step inward.
#[derive(Clone, Debug)]
enum Step {
    Key(String),
    Index(usize),
}

impl Place {
    /// That of a key of the file.
    pub(super) fn of(key: &str) -> Self {
        Self {
            steps: vec![Step::Key(key.to_owned())],
            shown: key.escaped(),
        }
    }

    /// That of a key of the object which stands there.
    pub(super) fn key(&self, key: &str) -> Self {
        let shown = format!("{}.{}", self.shown, key.escaped());
        self.then(Step::Key(key.to_owned()), shown)
    }

    /// That of an entry of the list which stands there.
    pub(super) fn index(&self, index: usize) -> Self {
        let shown = format!("{}[{index}]", self.shown);
        self.then(Step::Index(index), shown)
    }

    fn then(&self, step: Step, shown: String) -> Self {
        let mut steps = self.steps.clone();
        steps.push(step);
        Self { steps, shown }
    }

    /// Where in this text, which is JSON, the value stands.
    pub(super) fn span(&self, text: &str) -> Option<Span> {
        let mut value = text;
        for step in &self.steps {
            let inner = match step {
                Step::Key(key) => {
                    let object: BTreeMap<String, &RawValue> = serde_json::from_str(value).ok()?;
                    object.get(key).copied()
                }
                Step::Index(index) => {
                    let list: Vec<&RawValue> = serde_json::from_str(value).ok()?;
                    list.get(*index).copied()
                }
            };
            value = inner?.get();
        }
        // Each is a part of the text before.
        let start = value.as_ptr().addr() - text.as_ptr().addr();
        Some((start..start + value.len()).into())
    }

    /// The same of the key before the value, quotes included.
    pub(super) fn key_span(&self, text: &str) -> Option<Span> {
        let before = text.get(..self.span(text)?.start)?;
        string_span(before.trim_end().strip_suffix(':')?.trim_end())
    }
}

/// The string at the end of a text that is JSON up to there, quotes included.
pub(super) fn string_span(text: &str) -> Option<Span> {
    let inside = text.strip_suffix('"')?;
    let is_escaped = |at: usize| {
        let before = &inside[..at];
        (at - before.trim_end_matches('\\').len()) % 2 == 1
    };
    let mut quotes = inside.rmatch_indices('"').map(|(at, _)| at);
    let start = quotes.find(|at| !is_escaped(*at))?;
    Some((start..text.len()).into())
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.shown)
    }
}
