//! What differs between two texts, line by line.

use std::{fmt, ops::Range};

use imara_diff::{
    Algorithm, Diff, InternedInput, Interner, Token, UnifiedDiffConfig, UnifiedDiffPrinter,
};

/// The lines that one text has and the other lacks.
pub(super) struct TextDiff<'a> {
    lines: InternedInput<&'a str>,
    diff: Diff,
}

impl<'a> TextDiff<'a> {
    pub(super) fn new(old: &'a str, new: &'a str) -> Self {
        let lines = InternedInput::new(old, new);
        let mut diff = Diff::compute(Algorithm::Histogram, &lines);
        diff.postprocess_lines(&lines);
        Self { lines, diff }
    }

    /// The lines of the old text that are gone, from 0.
    pub(super) fn removed(&self) -> impl Iterator<Item = usize> {
        self.diff.hunks().flat_map(|hunk| indices(hunk.before))
    }

    /// The lines of the new text that the old one lacks, from 0.
    pub(super) fn added(&self) -> impl Iterator<Item = usize> {
        self.diff.hunks().flat_map(|hunk| indices(hunk.after))
    }

    /// The unified diff of the texts, which `patch` reads; empty where they are the same.
    pub(super) fn unified(&self, [old, new]: [&str; 2]) -> String {
        let printer = Printer(&self.lines.interner);
        let hunks = self
            .diff
            .unified_diff(&printer, UnifiedDiffConfig::default(), &self.lines);
        let hunks = hunks.to_string();
        if hunks.is_empty() {
            hunks
        } else {
            format!("--- {old}\n+++ {new}\n{hunks}")
        }
    }
}

fn indices(lines: Range<u32>) -> Range<usize> {
    lines.start as usize..lines.end as usize
}

/// Writes hunks as `diff -u` does: an empty side begins one line before, and a last line without its end says so.
struct Printer<'a>(&'a Interner<&'a str>);

impl Printer<'_> {
    fn line(&self, mut out: impl fmt::Write, mark: char, line: Token) -> fmt::Result {
        let line = self.0[line];
        let end = if line.ends_with('\n') {
            ""
        } else {
            "\n\\ No newline at end of file\n"
        };
        write!(out, "{mark}{line}{end}")
    }
}

impl UnifiedDiffPrinter for Printer<'_> {
    fn display_header(
        &self,
        mut out: impl fmt::Write,
        old: u32,
        new: u32,
        old_lines: u32,
        new_lines: u32,
    ) -> fmt::Result {
        let side = |start: u32, lines: u32| {
            let start = start + u32::from(lines > 0);
            if lines == 1 {
                start.to_string()
            } else {
                format!("{start},{lines}")
            }
        };
        let (old, new) = (side(old, old_lines), side(new, new_lines));
        writeln!(out, "@@ -{old} +{new} @@")
    }

    fn display_context_token(&self, out: impl fmt::Write, line: Token) -> fmt::Result {
        self.line(out, ' ', line)
    }

    fn display_hunk(&self, mut out: impl fmt::Write, old: &[Token], new: &[Token]) -> fmt::Result {
        for (mark, lines) in [('-', old), ('+', new)] {
            for line in lines {
                self.line(&mut out, mark, *line)?;
            }
        }
        Ok(())
    }
}
