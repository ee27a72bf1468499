//! How many lines of a generated text changed, and where: what people read before the lines themselves.

use std::{collections::BTreeSet, fmt};

use kane_codegen::diagnostic::{count, first_few};

use crate::cli::text::{only::Only, text_diff::TextDiff};

/// What changed between two texts.
pub(crate) struct ChangedLines {
    removed: usize,
    added: usize,
    /// The functions in which lines changed: those of the new text in its order, then those that are gone.
    functions: Vec<String>,
    /// True for texts that declare functions.
    has_functions: bool,
    /// All that changed, where it is of one kind.
    only: Option<Only>,
}

impl ChangedLines {
    /// What a diff of these texts holds.
    pub(crate) fn of(diff: &TextDiff<'_>, old: &str, new: &str) -> Self {
        let (old_owners, new_owners) = (owners(old), owners(new));
        let removed = diff.removed().map(|line| old_owners[line].as_deref());
        let added = diff.added().map(|line| new_owners[line].as_deref());
        let mut changed: BTreeSet<&str> = removed.chain(added).flatten().collect();
        let has_functions = new_owners.iter().any(Option::is_some);
        let mut functions: Vec<String> = new_owners.iter().flatten().cloned().collect();
        functions.dedup();
        functions.retain(|name| changed.remove(name.as_str()));
        functions.extend(changed.into_iter().map(str::to_owned));
        Self {
            removed: diff.removed().count(),
            added: diff.added().count(),
            functions,
            has_functions,
            only: Only::of(old, new),
        }
    }

    /// The same as text, with the names of all functions or of the first few.
    pub(crate) fn told(&self, all_functions: bool) -> String {
        let removed = count(self.removed, "line");
        let functions = if self.functions.is_empty() {
            let none = ", none of them in a function";
            if self.has_functions { none } else { "" }.to_owned()
        } else {
            let names = if all_functions {
                self.functions.join(", ")
            } else {
                first_few(&self.functions)
            };
            format!(", in {}: {names}", count(self.functions.len(), "function"))
        };
        let only = match self.only {
            Some(Only::Layout) => "; only the layout changed",
            Some(Only::Comments) => "; only comments changed",
            Some(Only::Numbers) => "; only numbers changed",
            Some(Only::Names) => "; only names changed",
            None => "",
        };
        format!("{removed} removed, {} added{functions}{only}", self.added)
    }

    /// True where the texts are one text in two layouts.
    pub(crate) fn are_layout(&self) -> bool {
        self.only == Some(Only::Layout)
    }
}

impl fmt::Display for ChangedLines {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.told(false))
    }
}

/// The function to which each line belongs, with its documentation and attributes.
fn owners(text: &str) -> Vec<Option<String>> {
    let lines: Vec<&str> = text.lines().collect();
    let mut owners = vec![None; lines.len()];
    for (at, line) in lines.iter().enumerate() {
        let Some(name) = declared(line) else { continue };
        let indent = line.len() - line.trim_start().len();
        let above = lines[..at].iter().rev();
        let above = above.take_while(|line| !ends_item(line)).count();
        let close = format!("{:indent$}}}", "");
        let below = lines[at..].iter().position(|line| line.trim_end() == close);
        let end = below.map_or(lines.len(), |below| at + below + 1);
        owners[at - above..end].fill(Some(name.clone()));
    }
    owners
}

/// True for the last line of what stands before an item.
fn ends_item(line: &str) -> bool {
    let line = line.trim();
    line.is_empty() || !line.starts_with("///") && line.ends_with([';', '}', '{'])
}

/// The name of the function that a line declares: of Rust alone at the beginning of the line, of a type, `Prepared`, further in.
/// Functions of traits have the names of those that they call.
fn declared(line: &str) -> Option<String> {
    let rest = line.trim_start();
    let is_of_type = rest.len() < line.len();
    let public = rest.strip_prefix("pub ");
    if is_of_type && public.is_none() {
        return None;
    }
    let rest = public.unwrap_or(rest);
    let rest = rest.strip_prefix("unsafe ").unwrap_or(rest);
    let rest = rest.strip_prefix("extern \"C\" ").unwrap_or(rest);
    let name = rest.strip_prefix("fn ")?;
    let end = name.find(|c: char| !(c.is_alphanumeric() || c == '_'))?;
    let of = if is_of_type { "Prepared::" } else { "" };
    Some(format!("{of}{}", &name[..end]))
}
