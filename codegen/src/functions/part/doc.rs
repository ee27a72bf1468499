//! What the documentation of a generated function says of a part.

use super::Part;
use crate::functions::subject::View;

impl Part {
    /// Lines of documentation.
    pub fn doc(&self) -> Vec<String> {
        let of = self.doc_of_values();
        let Some(derivative) = &self.derivative else {
            return of;
        };
        let mut lines = derivative.doc(
            &self.text_of_values(),
            &self.outputs(),
            &self.places_constant(),
        );
        lines.extend([String::new(), "Of that function:".to_owned(), String::new()]);
        lines.extend(of);
        lines
    }

    fn doc_of_values(&self) -> Vec<String> {
        let lines = self.function.doc.iter();
        let Some(subject) = &self.subject else {
            return lines.map(ToString::to_string).collect();
        };
        let names = subject.frames.iter();
        let names: Vec<String> = names
            .map(|frame| format!("`{}`", frame.name.escape_debug()))
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
        let words = [
            ("{frame}", frames),
            (
                "{seen}",
                match subject.view {
                    View::Other => {
                        format!("as it is seen from {from}, which may move itself, {axes}")
                    }
                    View::Inertial | View::Local => format!("in {from}, {axes}"),
                },
            ),
            (
                "{from}",
                if is_other {
                    format!(" as it is seen from {from}")
                } else {
                    String::new()
                },
            ),
            (
                "{base}",
                if is_other {
                    format!("{from}'s")
                } else {
                    "inertial".to_owned()
                },
            ),
            (
                "{origin}",
                if is_other {
                    format!("{from}'s")
                } else {
                    "the inertial origin".to_owned()
                },
            ),
            ("{axes}", axes),
            ("{speeds}", format!("`{}`", self.speeds_constant())),
        ];
        let line = |line: &&str| {
            let line = (*line).to_owned();
            words
                .iter()
                .fold(line, |line, (word, text)| line.replace(word, text))
        };
        lines.map(line).collect()
    }
}
