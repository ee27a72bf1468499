//! Operations of functions, and what changed in them, as lines for people.

use kane_codegen::report::{Comparison, Counted};

/// What happened, to what, and how: a line.
pub(crate) type Row = [String; 3];

/// A line for every function whose operations changed, and for those that came and went.
pub(crate) fn rows(comparison: &Comparison) -> Vec<Row> {
    let row = |what: &str, name: &str, how: String| [what.to_owned(), name.to_owned(), how];
    let changed = comparison.changed.iter().map(|change| {
        let (old, new) = (total(&change.old), total(&change.new));
        let formulations = match (&change.old.formulation, &change.new.formulation) {
            (Some(old), Some(new)) if old != new => format!(", formulation {old} -> {new}"),
            _ => String::new(),
        };
        let change_of_total = if old == new && formulations.is_empty() {
            "other kinds".to_owned()
        } else {
            difference(old, new)
        };
        row(
            "changed",
            &change.name,
            format!("{old} -> {new} ({change_of_total}{formulations})"),
        )
    });
    let added = comparison.added.iter();
    let added = added.map(|(name, counted)| row("added", name, total(counted).to_string()));
    let removed = comparison.removed.iter();
    let removed = removed.map(|(name, counted)| row("removed", name, total(counted).to_string()));
    changed.chain(added).chain(removed).collect()
}

/// The lines in columns, each with its end.
pub(crate) fn text(rows: &[Row]) -> String {
    let width = |column: usize| {
        let cells = rows.iter().map(|row| row[column].chars().count());
        cells.max().unwrap_or(0)
    };
    // The words that can stand first are no longer than this.
    let (first, second) = (7, width(1));
    let line = |[what, name, how]: &Row| {
        let line = format!("  {what:first$}  {name:second$}  {how}");
        line.trim_end().to_owned() + "\n"
    };
    rows.iter().map(line).collect()
}

fn total(counted: &Counted) -> usize {
    counted.operations.total()
}

/// The change with its sign.
fn difference(old: usize, new: usize) -> String {
    if new < old {
        format!("-{}", old - new)
    } else {
        format!("+{}", new - old)
    }
}
