//! How much markup an XML file holds, told before it is parsed: where a tag has very many attributes, or a file very many
//! namespaces, parsing takes their square.
//!
//! In: text that may be no XML. Out: a fault where a limit is passed, else nothing: what is wrong in another way is the
//! parser's to tell.

use crate::diagnostic::{Diagnostic, Span};
use crate::limits::{XML_ATTRIBUTES, XML_NAMESPACES};

/// What would take too long to parse.
pub(crate) fn check(text: &str) -> Result<(), Diagnostic> {
    let mut namespaces = text.match_indices("xmlns");
    if let Some((at, found)) = namespaces.nth(XML_NAMESPACES) {
        let message = format!("more than {XML_NAMESPACES} namespaces are declared; expected fewer");
        return Err(at_place(message, at, found));
    }
    for (at, tag) in tags(text) {
        let n_values = values(tag);
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
    for (_, tag) in tags(text) {
        if tag.starts_with("</") {
            open.pop();
        } else if !tag.ends_with("/>") && !tag.starts_with("<!") {
            let name = tag[1..].split(|c: char| c.is_whitespace() || c == '>');
            open.extend(name.take(1));
        }
    }
    open.pop()
}

/// The tags of a text, with their places: what is neither a comment nor text as it stands nor an instruction.
fn tags(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let mut rest = text;
    std::iter::from_fn(move || {
        loop {
            rest = &rest[rest.find('<')?..];
            let skipped = [("<!--", "-->"), ("<![CDATA[", "]]>"), ("<?", "?>")];
            let skipped = skipped.iter().find(|(open, _)| rest.starts_with(open));
            let Some((_, close)) = skipped else { break };
            rest = rest.split_once(close).map_or("", |(_, after)| after);
        }
        let at = text.len() - rest.len();
        let (tag, after) = rest.split_at(length(rest));
        rest = after;
        Some((at, tag))
    })
}

/// The length of the tag with which a text begins, in whose values `>` may stand.
fn length(text: &str) -> usize {
    let mut rest = text;
    while let Some(at) = rest.find(['>', '"', '\'']) {
        let (found, after) = rest[at..].split_at(1);
        if found == ">" {
            return text.len() - after.len();
        }
        rest = after.split_once(found).map_or("", |(_, after)| after);
    }
    text.len()
}

/// How many values a tag has.
fn values(tag: &str) -> usize {
    let mut n_values = 0;
    let mut rest = tag;
    while let Some(at) = rest.find(['"', '\'']) {
        let (found, after) = rest[at..].split_at(1);
        n_values += 1;
        rest = after.split_once(found).map_or("", |(_, after)| after);
    }
    n_values
}

fn at_place(message: String, at: usize, found: &str) -> Diagnostic {
    Diagnostic::error(message).at(Span::from(at..at + found.len()), "too many")
}
