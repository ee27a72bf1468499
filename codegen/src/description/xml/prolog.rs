//! What stands before the root element, and which that is.

/// The name of the root element, as far as it can be told without reading the file.
pub(crate) fn root_name(text: &str) -> Option<&str> {
    let rest = text.get(prolog_end(text)..)?.strip_prefix('<')?;
    let name = rest.split([' ', '\t', '\r', '\n', '/', '>']).next()?;
    (!name.is_empty()).then_some(name)
}

/// Where the declaration, comments and processing instructions before the root element end.
pub(super) fn prolog_end(text: &str) -> usize {
    let mut rest = text;
    loop {
        rest = rest.trim_start();
        let close = if rest.starts_with("<!--") {
            "-->"
        } else if rest.starts_with("<?") {
            "?>"
        } else {
            return text.len() - rest.len();
        };
        rest = rest.split_once(close).map_or("", |(_, after)| after);
    }
}
