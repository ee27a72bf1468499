//! How many lines of a generated text changed, and where: what people read before the lines themselves.

use std::{collections::BTreeSet, fmt};

use similar::{ChangeTag, TextDiff};

/// Functions that are named.
const NAMED: usize = 3;

/// What changed between two texts of a module.
pub(super) struct ChangedLines {
    removed: usize,
    added: usize,
    /// Those in which lines changed, in their order.
    functions: Vec<String>,
    /// All functions of the new text.
    n_functions: usize,
    /// True where every statement is as it was, but for its numbers.
    are_numbers: bool,
}

impl ChangedLines {
    pub(super) fn of(old: &str, new: &str) -> Self {
        let (old_owners, new_owners) = (owners(old), owners(new));
        let diff = TextDiff::from_lines(old, new);
        let (mut removed, mut added) = (0, 0);
        let mut changed = BTreeSet::new();
        for change in diff.iter_all_changes() {
            let (count, owner) = match change.tag() {
                ChangeTag::Equal => continue,
                ChangeTag::Delete => (&mut removed, owner(&old_owners, change.old_index())),
                ChangeTag::Insert => (&mut added, owner(&new_owners, change.new_index())),
            };
            *count += 1;
            changed.extend(owner);
        }
        let in_order = distinct(&new_owners);
        let mut functions: Vec<String> = in_order
            .iter()
            .filter(|name| changed.remove(name.as_str()))
            .cloned()
            .collect();
        functions.extend(changed.into_iter().map(str::to_owned));
        Self {
            removed,
            added,
            functions,
            n_functions: in_order.len(),
            are_numbers: without_numbers(old) == without_numbers(new),
        }
    }
}

impl fmt::Display for ChangedLines {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} lines removed, {} added", self.removed, self.added)?;
        match self.functions.len() {
            0 => write!(f, ", none of them in a function")?,
            count => {
                let named = self.functions[..count.min(NAMED)].join(", ");
                let more = match count.saturating_sub(NAMED) {
                    0 => String::new(),
                    more => format!(" and {more} more"),
                };
                write!(
                    f,
                    ", in {count} of {} functions: {named}{more}",
                    self.n_functions
                )?;
            }
        }
        if self.are_numbers {
            write!(f, "; only numbers changed")?;
        }
        Ok(())
    }
}

fn owner(owners: &[Option<String>], line: Option<usize>) -> Option<&str> {
    owners.get(line?)?.as_deref()
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
        let closes = |line: &str| line.trim_end() == format!("{:indent$}}}", "");
        let below = lines[at..].iter().position(|line| closes(line));
        let end = below.map_or(lines.len(), |below| at + below + 1);
        owners[at - above..end].fill(Some(name.clone()));
    }
    owners
}

/// True for the last line of what stands before an item.
fn ends_item(line: &str) -> bool {
    let line = line.trim();
    !line.starts_with("///")
        && [";", "}", "{", ""]
            .iter()
            .any(|end| *end == line || !end.is_empty() && line.ends_with(end))
}

/// The name of the public function that a line declares; with its type where it belongs to one.
fn declared(line: &str) -> Option<String> {
    let rest = line.trim_start();
    let name = rest.strip_prefix("pub fn ")?;
    let end = name.find(|c: char| !(c.is_alphanumeric() || c == '_'))?;
    let of = if rest.len() < line.len() {
        "Prepared::"
    } else {
        ""
    };
    Some(format!("{of}{}", &name[..end]))
}

fn distinct(owners: &[Option<String>]) -> Vec<String> {
    let mut names: Vec<String> = owners.iter().flatten().cloned().collect();
    names.dedup();
    names
}

/// The statements, with `#` for every number; without comments that no item has.
fn without_numbers(text: &str) -> Vec<String> {
    let is_code = |line: &&str| !line.starts_with("//") || line.starts_with("///");
    text.lines().filter(is_code).map(masked).collect()
}

fn masked(line: &str) -> String {
    let mut shown = String::with_capacity(line.len());
    let mut previous = ' ';
    let mut in_number = false;
    for character in line.chars() {
        let goes_on = in_number
            && (character.is_ascii_alphanumeric()
                || matches!(character, '.' | '_')
                || matches!(character, '+' | '-') && matches!(previous, 'e' | 'E'));
        let starts = !in_number
            && character.is_ascii_digit()
            && !(previous.is_alphanumeric() || previous == '_');
        if starts {
            shown.push('#');
        } else if !goes_on {
            shown.push(character);
        }
        in_number = starts || goes_on;
        previous = character;
    }
    shown
}
