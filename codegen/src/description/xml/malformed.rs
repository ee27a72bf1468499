//! What is wrong with a file that is no XML.

use roxmltree::Error;

use crate::description::xml::markup;
use crate::description::xml::mend::Mended;
use crate::description::xml::prolog::prolog_end;
use crate::diagnostic::{Diagnostic, Span};
use crate::limits::XML_NODES;

pub(super) fn malformed(mended: &Mended<'_>, base: usize, error: &Error) -> Diagnostic {
    let text = &*mended.text;
    let position = error.pos();
    let at = match error {
        Error::NoRootNode | Error::UnclosedRootNode | Error::UnexpectedEndOfStream => {
            text.trim_end().len()
        }
        Error::DtdDetected => prolog_end(text),
        _ => offset(text, position.row as usize, position.col as usize),
    };
    let found = text.get(at..).and_then(|rest| rest.chars().next());
    let found_shown = found.map_or(String::from("the end of the file"), |found| {
        format!("`{}`", found.escape_debug())
    });
    let mut length = found.map_or(0, char::len_utf8);
    let mut help = None;
    let message = match error {
        Error::NoRootNode => "it has no element".to_owned(),
        Error::NodesLimitReached => {
            format!("it has more than {XML_NODES} elements, comments and texts")
        }
        Error::UnclosedRootNode => match markup::open(text) {
            Some(open) => format!("the file ends before `</{open}>`"),
            None => "the file ends before its root element is closed".to_owned(),
        },
        Error::UnexpectedEndOfStream => "the file ends too early".to_owned(),
        Error::DtdDetected => {
            length = "<!DOCTYPE".len();
            "a document type declaration is not accepted".to_owned()
        }
        Error::UnexpectedCloseTag(expected, actual, _) => {
            length = actual.len() + "</>".len();
            format!("expected `</{expected}>`, found `</{actual}>`")
        }
        Error::DuplicatedAttribute(name, _) => {
            length = name.len();
            format!("the attribute `{name}` is given twice")
        }
        Error::UnknownNamespace(prefix, _) => {
            length = prefix.len();
            help = Some(format!(
                "declare the prefix at the root element: `xmlns:{prefix}=\"...\"`"
            ));
            format!("the prefix `{prefix}` is not declared")
        }
        Error::MalformedEntityReference(_) => {
            help = Some("write `&amp;` for `&`".to_owned());
            "`&` begins no entity reference".to_owned()
        }
        Error::InvalidChar(expected, _, _) => {
            format!("expected `{}`, found {found_shown}", char::from(*expected))
        }
        Error::InvalidChar2(expected, _, _) => format!("expected {expected}, found {found_shown}"),
        Error::InvalidString(expected, _) => format!("expected `{expected}`, found {found_shown}"),
        Error::InvalidName(_) => format!("expected a name, found {found_shown}"),
        Error::NonXmlChar(..) => format!("{found_shown} must not stand in XML"),
        // The place is shown already.
        other => other.to_string().replace(&format!(" at {position}"), ""),
    };
    let start = base + mended.place(at);
    Diagnostic::error(format!("not valid XML: {message}"))
        .at(Span::from(start..start + length), "here")
        .help_if(help)
}

/// The byte at a line and a column, both from 1, the column in characters.
fn offset(text: &str, row: usize, column: usize) -> usize {
    let mut start = 0;
    for line in text.split_inclusive('\n').take(row.saturating_sub(1)) {
        start += line.len();
    }
    let line = text.get(start..).unwrap_or_default();
    line.char_indices()
        .nth(column.saturating_sub(1))
        .map_or(text.len(), |(at, _)| start + at)
}
