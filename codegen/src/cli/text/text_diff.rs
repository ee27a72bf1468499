//! What differs between two texts, line by line.

use std::ops::Range;

use imara_diff::{Algorithm, Diff, InternedInput, Token};

/// The lines that one text has and the other lacks.
pub(crate) struct TextDiff<'a> {
    lines: InternedInput<&'a str>,
    changes: Vec<Change>,
}

/// Lines from 0: those of the old text, and what stands for them in the new one.
struct Change {
    old: Range<usize>,
    new: Range<usize>,
}

/// So many lines that are the same are shown on both sides of a change.
const CONTEXT: usize = 3;

impl<'a> TextDiff<'a> {
    pub(crate) fn new(old: &'a str, new: &'a str) -> Self {
        let lines = InternedInput::new(old, new);
        let mut diff = Diff::compute(Algorithm::Histogram, &lines);
        diff.postprocess_lines(&lines);
        let places = |lines: Range<u32>| lines.start as usize..lines.end as usize;
        let changes = diff.hunks().map(|hunk| Change {
            old: places(hunk.before),
            new: places(hunk.after),
        });
        let changes = changes.collect();
        Self { lines, changes }
    }

    /// The lines of the old text that are gone, from 0.
    pub(crate) fn removed(&self) -> impl Iterator<Item = usize> {
        self.changes.iter().flat_map(|change| change.old.clone())
    }

    /// The lines of the new text that the old one lacks, from 0.
    pub(crate) fn added(&self) -> impl Iterator<Item = usize> {
        self.changes.iter().flat_map(|change| change.new.clone())
    }

    /// The unified diff of the texts, which `patch` reads, under their names and what each is; empty where they are the same.
    pub(crate) fn unified(&self, [old, new]: [(&str, &str); 2]) -> String {
        let is_near = |a: &Change, b: &Change| b.old.start - a.old.end <= 2 * CONTEXT;
        let hunks = self.changes.chunk_by(is_near);
        let hunks: String = hunks.map(|changes| self.hunk(changes)).collect();
        if hunks.is_empty() {
            hunks
        } else {
            // A tab ends a name, so that `patch` reads it right.
            let [old, new] = [old, new].map(|(name, what)| format!("{name}\t{what}"));
            format!("--- {old}\n+++ {new}\n{hunks}")
        }
    }

    /// Changes that are near one another, with the lines between and beside them.
    fn hunk(&self, changes: &[Change]) -> String {
        let (old, new) = (&self.lines.before, &self.lines.after);
        let (first, last) = (&changes[0], &changes[changes.len() - 1]);
        let above = CONTEXT.min(first.old.start);
        let below = CONTEXT.min(old.len() - last.old.end);
        let mut text = String::new();
        let mut at = first.old.start - above;
        for change in changes {
            self.write(&mut text, ' ', &old[at..change.old.start]);
            self.write(&mut text, '-', &old[change.old.clone()]);
            self.write(&mut text, '+', &new[change.new.clone()]);
            at = change.old.end;
        }
        self.write(&mut text, ' ', &old[at..at + below]);
        let old = side(first.old.start - above..last.old.end + below);
        let new = side(first.new.start - above..last.new.end + below);
        format!("@@ -{old} +{new} @@\n{text}")
    }

    fn write(&self, text: &mut String, mark: char, lines: &[Token]) {
        for &line in lines {
            let line = self.lines.interner[line];
            text.push(mark);
            text.push_str(line);
            if !line.ends_with('\n') {
                text.push_str("\n\\ No newline at end of file\n");
            }
        }
    }
}

/// Where a hunk begins, from 1, and how many lines it has if it is not one; one of no lines begins after the line of its number.
fn side(lines: Range<usize>) -> String {
    match lines.len() {
        0 => format!("{},0", lines.start),
        1 => (lines.start + 1).to_string(),
        length => format!("{},{length}", lines.start + 1),
    }
}
