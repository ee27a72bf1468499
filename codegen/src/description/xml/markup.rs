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
    let mut rest = text;
    while let Some(at) = rest.find('<') {
        rest = &rest[at..];
        let skipped = [("<!--", "-->"), ("<![CDATA[", "]]>"), ("<?", "?>")];
        let skipped = skipped.iter().find(|(open, _)| rest.starts_with(open));
        rest = if let Some((_, close)) = skipped {
            rest.split_once(close).map_or("", |(_, after)| after)
        } else {
            let (n_values, after) = tag(rest);
            if n_values > XML_ATTRIBUTES {
                let message = format!(
                    "the element has {n_values} attributes; expected at most {XML_ATTRIBUTES}"
                );
                return Err(at_place(message, text.len() - rest.len(), "<"));
            }
            after
        };
    }
    Ok(())
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
