//! One fault at full length: its message, the lines that it is about with labels below them, its advice.

use std::ops::Range;

use annotate_snippets::{AnnotationKind, Element, Group, Level, Origin, Renderer, Snippet};

use super::{Diagnostic, Severity, Source, SourceFile, printable};

/// Bytes of the longest line that is shown.
const LONGEST_LINE: usize = 2_000;

impl Diagnostic {
    /// The text to show: message, `file:line:column`, line, labels, advice.
    pub fn render(&self, source: &Source) -> String {
        let level = match self.severity {
            Severity::Error => Level::ERROR,
            Severity::Warning => Level::WARNING,
            Severity::Note => Level::NOTE,
        };
        let title = level.primary_title(&self.message);
        let mut group: Group<'_> = if self.labels.is_empty() {
            title.element(Origin::path(source.name()))
        } else {
            title.elements(self.places(source))
        };
        if let Some(help) = &self.help {
            group = group.element(Level::HELP.message(help));
        }
        printable(&Renderer::plain().render(&[group])).into_owned()
    }

    /// Of each file in which a label stands the lines from the first to the last one, that of the main one first.
    fn places<'a>(&'a self, source: &'a Source) -> Vec<Element<'a>> {
        let mut files: Vec<&SourceFile> = Vec::new();
        for (span, _) in &self.labels {
            let file = source.file_at(span.start);
            if !files.iter().any(|known| known.base() == file.base()) {
                files.push(file);
            }
        }
        let place = |file: &'a SourceFile| {
            let labels = self.labels.iter().enumerate();
            let here =
                labels.filter(|(_, (span, _))| source.file_at(span.start).base() == file.base());
            let here = here.map(|(index, (span, label))| {
                let kind = if index == 0 {
                    AnnotationKind::Primary
                } else {
                    AnnotationKind::Context
                };
                (kind, file.clamp(*span), label)
            });
            snippet(file, &here.collect::<Vec<_>>())
        };
        files.into_iter().map(place).collect()
    }
}

/// The lines of a file with labels; where one of them is very long, the place of the first label alone.
fn snippet<'a>(
    file: &'a SourceFile,
    labels: &[(AnnotationKind, Range<usize>, &'a String)],
) -> Element<'a> {
    let text = file.text();
    let places = || labels.iter().map(|(_, place, _)| place);
    let first = places().map(|place| place.start).min().unwrap_or(0);
    let last = places().map(|place| place.end).max().unwrap_or(0);
    let lines = file.lines(first, last);
    let mut each = text[lines.clone()].split('\n');
    if each.any(|line| line.len() > LONGEST_LINE) {
        let main = places().next().map_or(0, |place| place.start);
        let (line, column) = file.line_and_column(main);
        return Origin::path(file.name())
            .line(line)
            .char_column(column)
            .into();
    }
    let annotations = labels.iter().map(|(kind, place, label)| {
        let here = place.start - lines.start..place.end - lines.start;
        kind.span(here).label(label.as_str())
    });
    Snippet::source(&text[lines.clone()])
        .line_start(file.line(lines.start))
        .path(file.name())
        .annotations(annotations)
        .into()
}
