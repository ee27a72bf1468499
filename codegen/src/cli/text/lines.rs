//! How many lines of a generated text changed, and where: what people read before the lines themselves.

use std::{collections::BTreeSet, fmt};

use kane_codegen::diagnostic::{count, first_few};

use crate::cli::text::text_diff::TextDiff;

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

    /// True where no line of code changed.
    pub(crate) fn are_comments(&self) -> bool {
        self.only == Some(Only::Comments)
    }
}

/// What alone differs between two texts.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Only {
    /// Comments that no item has.
    Comments,
    /// These, and numbers of the model.
    Numbers,
}

impl Only {
    fn of(old: &str, new: &str) -> Option<Self> {
        if code(old).eq(code(new)) {
            Some(Self::Comments)
        } else if code(old).map(masked).eq(code(new).map(masked)) {
            Some(Self::Numbers)
        } else {
            None
        }
    }
}

impl fmt::Display for ChangedLines {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let removed = count(self.removed, "line");
        write!(f, "{removed} removed, {} added", self.added)?;
        if !self.functions.is_empty() {
            let functions = count(self.functions.len(), "function");
            write!(f, ", in {functions}: {}", first_few(&self.functions))?;
        } else if self.has_functions {
            write!(f, ", none of them in a function")?;
        }
        match self.only {
            Some(Only::Comments) => write!(f, "; only comments changed"),
            Some(Only::Numbers) => write!(f, "; only numbers changed"),
            None => Ok(()),
        }
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

/// The lines without comments that no item has.
fn code(text: &str) -> impl Iterator<Item = &str> {
    let is_code = |line: &&str| !line.starts_with("//") || line.starts_with("///");
    text.lines().filter(is_code)
}

/// The line with `#` for every number that is no index or length: what has a decimal point or an exponent. A minus that opens an
/// argument is the number's.
fn masked(line: &str) -> String {
    let mut shown = String::with_capacity(line.len());
    let mut rest = line;
    let mut previous = ' ';
    while let Some(character) = rest.chars().next() {
        let in_name = previous.is_alphanumeric() || previous == '_';
        let sign = usize::from(character == '-' && previous == '(');
        let starts = !in_name && rest[sign..].starts_with(|c: char| c.is_ascii_digit());
        let length = if starts {
            sign + number(&rest[sign..])
        } else {
            character.len_utf8()
        };
        let (token, after) = rest.split_at(length);
        // A hash changes with them, whichever digits it has.
        let is_hash = token.starts_with("0x");
        let is_real = starts && (is_hash || token.contains(['.', 'e', 'E']));
        shown.push_str(if is_real { "#" } else { token });
        previous = token.chars().next_back().unwrap_or(' ');
        rest = after;
    }
    shown
}

/// How long the number is with which a text begins.
fn number(text: &str) -> usize {
    let mut previous = ' ';
    let mut goes_on = |character: char| {
        let signs = matches!(character, '+' | '-') && matches!(previous, 'e' | 'E');
        let goes_on = character.is_ascii_alphanumeric() || matches!(character, '.' | '_') || signs;
        previous = character;
        goes_on
    };
    text.find(|character| !goes_on(character))
        .unwrap_or(text.len())
}
