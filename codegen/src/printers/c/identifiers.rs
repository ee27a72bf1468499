//! What a header declares, read off its text.

use std::collections::BTreeSet;

/// The identifiers that the header of this module declares: macros, types, constants and functions, without those that several headers share.
pub fn identifiers<'a>(header: &'a str, module: &str) -> BTreeSet<&'a str> {
    let prefix = format!("{module}_").to_ascii_lowercase();
    let is_own = |name: &&str| name.to_ascii_lowercase().starts_with(&prefix);
    header.lines().filter_map(declared).filter(is_own).collect()
}

/// What a line declares.
fn declared(line: &str) -> Option<&str> {
    if let Some(rest) = line.strip_prefix("#define ") {
        return rest.split(' ').next();
    }
    if let Some(rest) = line.strip_prefix("typedef struct ") {
        return rest.strip_suffix(" {");
    }
    if line.starts_with("void ") || line.starts_with("const char *") {
        return last_word(line.split_once('(')?.0);
    }
    if line.starts_with("static const ") {
        return last_word(line.split_once('[')?.0);
    }
    // A constant of an enumeration.
    let (name, _) = line.strip_prefix("    ")?.split_once(" = ")?;
    Some(name)
}

fn last_word(text: &str) -> Option<&str> {
    text.rsplit([' ', '*']).next()
}
