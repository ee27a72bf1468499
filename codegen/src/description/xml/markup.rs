//! The tags of an XML file, told before or without parsing it. Where a tag has very many attributes, or a file very many
//! namespaces, parsing takes their square; where a file ends early, the parser does not say what is open.
//!
//! In: text that may be no XML. Out: a fault where a limit is passed, else nothing: what is wrong in another way is the
//! parser's to tell.

use crate::diagnostic::{Diagnostic, Span};
use crate::limits::{XML_ATTRIBUTES, XML_NAMESPACES};

/// What would take too long to parse.
pub(crate) fn check(text: &str) -> Result<(), Diagnostic> {
    let mut n_namespaces = 0;
    for Tag { at, n_values, text } in tags(text) {
        n_namespaces += text.matches("xmlns").count();
        if n_namespaces > XML_NAMESPACES {
            let message = format!("more than {XML_NAMESPACES} namespaces are declared");
            return Err(at_place(message, at, "<"));
        }
        if n_values > XML_ATTRIBUTES {
            let message =
                format!("the element has {n_values} attributes; expected at most {XML_ATTRIBUTES}");
            return Err(at_place(message, at, "<"));
        }
    }
    Ok(())
}

/// The name of the innermost element that is not closed where the text ends.
pub(super) fn open(text: &str) -> Option<&str> {
    let mut open: Vec<&str> = Vec::new();
    for Tag { text, .. } in tags(text) {
        if text.starts_with("</") {
            open.pop();
        } else if !text.ends_with("/>") && !text.starts_with("<!") {
            let mut words = text[1..].split(|c: char| c.is_whitespace() || c == '>');
            open.extend(words.next());
        }
    }
    open.pop()
}

/// A tag.
struct Tag<'a> {
    /// Its place.
    at: usize,
    /// From `<` to `>`.
    text: &'a str,
    n_values: usize,
}

/// The tags of a text; comments, CDATA and instructions are none.
fn tags(text: &str) -> impl Iterator<Item = Tag<'_>> {
    let mut rest = text;
    std::iter::from_fn(move || {
        loop {
            rest = &rest[rest.find('<')?..];
            let skipped = [("<!--", "-->"), ("<![CDATA[", "]]>"), ("<?", "?>")];
            let skipped = skipped.iter().find(|(open, _)| rest.starts_with(open));
            let Some((_, close)) = skipped else { break };
            rest = rest.split_once(close).map_or("", |(_, after)| after);
        }
        let (n_values, after) = tag(rest);
        let found = Tag {
            at: text.len() - rest.len(),
            text: &rest[..rest.len() - after.len()],
            n_values,
        };
        rest = after;
        Some(found)
    })
}

/// The values of the tag with which a text begins, and what follows it.
fn tag(text: &str) -> (usize, &str) {
    let mut n_values = 0;
    let mut rest = text;
    while let Some(at) = rest.find(['>', '"', '\'']) {
        let (found, after) = rest[at..].split_at(1);
        if found == ">" {
            return (n_values, after);
        }
        n_values += 1;
        rest = after.split_once(found).map_or("", |(_, after)| after);
    }
    (n_values, "")
}

fn at_place(message: String, at: usize, found: &str) -> Diagnostic {
    Diagnostic::error(message).at(Span::from(at..at + found.len()), "too many")
}
