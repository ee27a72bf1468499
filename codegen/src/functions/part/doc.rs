//! What the documentation of a generated function says of a part.

use std::collections::BTreeMap;

use super::Part;
use crate::{
    diagnostic::Escaped,
    functions::{
        function::Output,
        subject::{Subject, View},
    },
};

impl Part {
    /// Lines of documentation.
    pub fn doc(&self) -> Vec<String> {
        let of = self.doc_of_values();
        let Some(derivative) = &self.derivative else {
            return of;
        };
        let mut lines = derivative.doc(
            &self.asked().text_of_values(),
            &self.outputs(),
            &self.places_constant(),
        );
        lines.extend([String::new(), "Of that function:".to_owned(), String::new()]);
        lines.extend(of);
        lines
    }

    fn doc_of_values(&self) -> Vec<String> {
        let lines = self.function.doc.iter();
        lines.map(|line| self.said(line)).collect()
    }

    /// What one of its outputs means, in words.
    pub(in crate::functions) fn meaning(&self, output: &Output) -> String {
        match (&self.derivative, output.meaning.as_ref()) {
            (None, "") => self.said(&first_sentence(self.function.doc)),
            (None, own) => self.said(own),
            (Some(_), own) => own.to_owned(),
        }
    }

    /// A text of the catalogue, with words in place of those in braces.
    fn said(&self, text: &str) -> String {
        let outputs = self.function.outputs.iter();
        let units = outputs.map(|output| (output.name.as_ref(), output.unit.text()));
        let words = self.subject.iter().flat_map(|subject| self.words(subject));
        let known: BTreeMap<&str, String> = words.chain(units).collect();
        let mut said = String::new();
        let mut rest = text;
        // What is put in may have braces of its own.
        while let Some((before, after)) = rest.split_once('{') {
            let (word, after) = after.split_once('}').unwrap_or((after, ""));
            said += before;
            match known.get(word) {
                Some(own) => said += own,
                None => said.extend(["{", word, "}"]),
            }
            rest = after;
        }
        said + rest
    }

    /// What the frames are, and how they are seen.
    fn words(&self, subject: &Subject) -> [(&'static str, String); 7] {
        let names = subject.frames.iter();
        let names: Vec<String> = names
            .map(|frame| format!("`{}`", frame.name.escaped()))
            .collect();
        let (frames, from) = match (subject.view, &names[..]) {
            (View::Other, [frame, other]) => (frame.clone(), other.as_str()),
            _ => (names.join(", "), "the inertial frame"),
        };
        let axes = match subject.view {
            View::Inertial => "inertial components".to_owned(),
            View::Local => "components along the frame's own axes".to_owned(),
            View::Other => format!("components along the axes of {from}"),
        };
        let is_other = subject.view == View::Other;
        [
            ("frame", frames),
            (
                "seen",
                match subject.view {
                    View::Other => {
                        format!("as it is seen from {from}, which may move itself, {axes}")
                    }
                    View::Inertial | View::Local => format!("in {from}, {axes}"),
                },
            ),
            (
                "from",
                if is_other {
                    format!(" as it is seen from {from}")
                } else {
                    String::new()
                },
            ),
            (
                "base",
                if is_other {
                    format!("{from}'s")
                } else {
                    "inertial".to_owned()
                },
            ),
            (
                "origin",
                if is_other {
                    format!("{from}'s")
                } else {
                    "the inertial origin".to_owned()
                },
            ),
            ("axes", axes),
            ("speeds", format!("`{}`", self.speeds_constant())),
        ]
    }
}

/// The first sentence of lines of documentation, without its full stop. `Eq. (4)` ends none.
fn first_sentence(lines: &[&str]) -> String {
    let text = lines.join(" ");
    let ends = text.match_indices(". ").map(|(place, _)| place);
    let mut ends = ends.filter(|place| !text[place + 2..].starts_with('('));
    let end = ends.next().unwrap_or(text.len());
    text[..end].trim_end_matches('.').to_owned()
}
