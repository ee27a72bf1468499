//! How long files and functions are.
//!
//! Functions are told by their lines, which rustfmt has put in place: the last one of a function is a brace as far from the
//! edge as the first.

use crate::walk::Sources;

/// The most lines of a file.
const FILE: usize = 500;

/// The most lines of a function.
const FUNCTION: usize = 80;

/// Words that stand before `fn`.
const BEFORE: [&str; 6] = ["pub", "const", "async", "unsafe", "extern", "\"C\""];

/// What is longer than it may be, a line each.
pub(crate) fn too_long(sources: &Sources) -> Vec<String> {
    let mut long = Vec::new();
    for (file, text) in &sources.0 {
        let lines: Vec<&str> = text.lines().collect();
        if lines.len() > FILE {
            let count = lines.len();
            long.push(format!("{file} has {count} lines; at most {FILE}"));
        }
        for (place, line) in lines.iter().enumerate() {
            let Some((indent, name)) = function(line) else {
                continue;
            };
            let count = 1 + last(&lines[place..], indent);
            if count > FUNCTION {
                let place = place + 1;
                long.push(format!(
                    "{file}:{place}: `{name}` has {count} lines; at most {FUNCTION}"
                ));
            }
        }
    }
    long
}

/// Where a line begins a function: what stands before it, and its name.
fn function(line: &str) -> Option<(&str, &str)> {
    let (before, after) = line.split_once("fn ")?;
    // Where something can be seen may be two words: `pub(in crate::functions)`.
    let seen = before.trim_start().strip_prefix("pub(");
    let rest = seen.map_or(before, |seen| {
        seen.split_once(')').map_or(seen, |(_, rest)| rest)
    });
    let mut words = rest.split_whitespace();
    let is_begin = before.is_empty() || before.ends_with(' ');
    let indent = &line[..line.len() - line.trim_start().len()];
    let name = after
        .split(|c: char| !c.is_alphanumeric() && c != '_')
        .next()?;
    (is_begin && words.all(|word| BEFORE.contains(&word)) && !name.is_empty())
        .then_some((indent, name))
}

/// The place of the last line of the function that begins with the first.
fn last(lines: &[&str], indent: &str) -> usize {
    let is_last = |(place, line): (usize, &&str)| match line.strip_prefix(indent) {
        Some("}" | "{}") => true,
        // A body in one line, or none.
        Some(rest) => (place == 0 || rest.starts_with(')')) && rest.ends_with(['}', ';']),
        None => false,
    };
    lines.iter().enumerate().position(is_last).unwrap_or(0)
}
