//! Tests among sources, of which the library's own are not compiled.

use crate::walk::Sources;

/// What stands above a test, or what is compiled for tests alone.
const MARKS: [&str; 3] = ["#[test]", "#[cfg(test)", "#[cfg(all(test"];

/// Where there is one, a line each.
pub(crate) fn found(sources: &Sources) -> Vec<String> {
    let mut found = Vec::new();
    for (file, text) in &sources.0 {
        for (place, line) in text.lines().enumerate() {
            if MARKS.iter().any(|mark| line.trim_start().starts_with(mark)) {
                found.push(format!("{file}:{}", place + 1));
            }
        }
    }
    found
}
