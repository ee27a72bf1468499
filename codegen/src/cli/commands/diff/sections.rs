//! What differs, for people: in a terminal, and as tables for a pull request.

use kane_codegen::report::{
    Body, Comparison, Differences, FormChange, Layout, LayoutChange, Meaning, Redeclared,
    ValueChange,
};

use super::{
    report::{Report, Rewriting},
    systems::Systems,
};
use crate::cli::text::operations::{self, Row};

/// How much of a diff a pull request is shown: hosts refuse texts that are too long.
const SHOWN_LINES: usize = 400;

/// Where only what is said of the models differs.
const SAME_TEXT: &str = "generated text is the same";

/// What is shown of the generated text.
#[derive(Clone, Copy)]
pub(super) struct Shown {
    /// Its lines.
    pub(super) lines: bool,
    /// Where lines are not shown, the names of all functions in which they are.
    pub(super) all_functions: bool,
}

/// Lines under a title.
struct Section {
    title: String,
    rows: Vec<Row>,
}

impl Section {
    fn text(&self) -> String {
        format!("{}\n{}", self.title, operations::text(&self.rows))
    }

    /// As a table of Markdown.
    fn table(&self) -> String {
        let head = format!("\n**{}**\n\n| | | |\n| --- | --- | --- |\n", self.title);
        let row =
            |[what, name, how]: &Row| format!("| {what} | {} | {} |\n", code(name), code(how));
        let rows = self.rows.iter().map(row);
        std::iter::once(head).chain(rows).collect()
    }
}

/// Adds a section if there are rows for it.
fn push(sections: &mut Vec<Section>, title: &str, rows: Vec<Row>) {
    let title = title.to_owned();
    sections.extend((!rows.is_empty()).then_some(Section { title, rows }));
}

/// What breaks code, what came, then what differs of every other module under its name.
pub(super) fn text_of_systems(systems: &Systems, shown: Shown) -> String {
    let mut text: String = files(systems).iter().map(Section::text).collect();
    for report in &systems.changed {
        let [old, new] = &report.names;
        text.extend([format!("== {old} -> {new}\n"), self::text(report, shown)]);
    }
    text
}

/// A title, tables of what breaks code and what came, then what differs of every other module.
pub(super) fn markdown_of_systems(systems: &Systems) -> String {
    let [old, new] = systems.names.each_ref().map(|name| code(name));
    let mut text = format!("## {old} → {new}\n");
    if systems.is_same() {
        text += "\nNothing differs.\n";
    }
    let mut sections = files(systems);
    let warnings = systems.warnings().map(|[model, message]| {
        let message = message.to_owned();
        ["warning".to_owned(), model.to_owned(), message]
    });
    push(&mut sections, "new models", warnings.collect());
    text.extend(sections.iter().map(Section::table));
    for report in &systems.changed {
        text.extend(["\n".to_owned(), markdown(report)]);
    }
    text
}

fn files(systems: &Systems) -> Vec<Section> {
    let row = |what: &str, name: &str, how: String| [what.to_owned(), name.to_owned(), how];
    let removed = systems.removed.iter();
    let removed = removed.map(|name| row("removed", name, String::new()));
    let changed = systems.breaking().map(|report| {
        let layouts = report.differences.layouts.iter();
        let layouts = layouts.map(|change| change.layout.name());
        let redeclared = report.redeclared.iter().map(|own| own.name.as_str());
        let meanings = report.meanings.iter().map(|own| own.name.as_str());
        let changed: Vec<&str> = layouts.chain(redeclared).chain(meanings).collect();
        row("changed", &report.names[1], changed.join(", "))
    });
    let added = systems.added.iter();
    let added = added.map(|name| row("added", name, String::new()));
    let mut sections = Vec::new();
    push(
        &mut sections,
        "BREAKING: files that are gone, or in which places, names, functions or arguments changed",
        removed.chain(changed).collect(),
    );
    push(&mut sections, "files", added.collect());
    sections
}

/// Sections one after the other, then how much of the text changed, or the diff.
pub(super) fn text(report: &Report, shown: Shown) -> String {
    let mut text: String = note(report).map(|note| note + "\n").into_iter().collect();
    text.extend(sections(report).iter().map(Section::text));
    match &report.lines {
        None if report.is_same() => {}
        None => text.extend([SAME_TEXT, "\n"]),
        Some(_) if shown.lines => text += &report.diff,
        Some(changed) => {
            let changed = changed.told(shown.all_functions);
            text.extend(["generated text (--lines shows it)\n  ", &changed, "\n"]);
        }
    }
    text
}

/// A table a section, then the diff, folded.
pub(super) fn markdown(report: &Report) -> String {
    let [old, new] = report.names.each_ref().map(|name| code(name));
    let mut text = format!("### {old} → {new}\n");
    if report.is_same() {
        text += "\nNothing differs.\n";
    }
    text.extend(note(report).map(|note| format!("\n{note}\n")));
    text.extend(sections(report).iter().map(Section::table));
    if report.lines.is_none() && !report.is_same() {
        text.extend(["\n", SAME_TEXT, "\n"]);
    }
    if !report.diff.is_empty() {
        let lines: Vec<&str> = report.diff.lines().collect();
        let shown = lines[..lines.len().min(SHOWN_LINES)].join("\n");
        let rest = lines.len().saturating_sub(SHOWN_LINES);
        let rest = (rest > 0).then(|| format!("\n{rest} more lines\n"));
        text.extend([
            "\n<details><summary>Generated text</summary>\n\n```diff\n".to_owned(),
            shown,
            "\n```\n".to_owned(),
            rest.unwrap_or_default(),
            "\n</details>\n".to_owned(),
        ]);
    }
    text
}

/// A name as code in a table; nothing is nothing.
fn code(text: &str) -> String {
    if text.is_empty() {
        return String::new();
    }
    format!("`{}`", text.replace('`', "'").replace('|', "\\|"))
}

/// What two modules of one model have in common.
fn note(report: &Report) -> Option<String> {
    let whole = match report.rewriting {
        Some(Rewriting::Layout) => "only the layout differs: formatted by another tool",
        Some(Rewriting::SameInput) => {
            "the model and all that is asked for are the same: edited by hand, or written by another version of kane"
        }
        Some(Rewriting::Formats(formats)) => return of_one_model(report, Some(formats)),
        None => return of_one_model(report, None),
    };
    Some(whole.to_owned())
}

/// What modules have in common that are not of the same text, if bodies and joints are the same.
fn of_one_model(report: &Report, formats: Option<[u32; 2]>) -> Option<String> {
    let [old, new] = report.fingerprints;
    // Frames that only mark a place are no part of what is hashed.
    let says_the_same = old == new && report.differences.values.is_empty();
    let is_same_model = old.is_some() && says_the_same && !report.is_same();
    let has_options = !report.options.is_empty();
    let how = match &report.moved {
        _ if has_options => "options differ".to_owned(),
        Some([old, new]) if report.functions == Comparison::default() => {
            format!("the model was {old} and is {new}")
        }
        _ => match formats {
            Some([old, new]) => {
                let (added, removed) = (&report.functions.added, &report.functions.removed);
                let others = if added.is_empty() && removed.is_empty() {
                    ""
                } else {
                    ", and functions differ"
                };
                format!("written by different versions of kane, formats {old} and {new}{others}")
            }
            None => "frames, functions or the generator differ".to_owned(),
        },
    };
    is_same_model.then(|| format!("bodies and joints are the same: {how}"))
}

fn sections(report: &Report) -> Vec<Section> {
    let differences = &report.differences;
    let (of_the_tree, values): (Vec<&ValueChange>, Vec<&ValueChange>) = differences
        .values
        .iter()
        .partition(|change| change.is_of_the_tree());
    let mut sections: Vec<Section> = differences.layouts.iter().map(layout).collect();
    let redeclared = report.redeclared.iter();
    let redeclared = redeclared.map(|Redeclared { name, old, new }| {
        let (what, how) = match new {
            Some(new) => ("changed", format!("{old} -> {new}")),
            None => ("removed", String::new()),
        };
        [what.to_owned(), name.clone(), how]
    });
    push(
        &mut sections,
        "BREAKING: functions that are gone, or have other arguments",
        redeclared.collect(),
    );
    push(
        &mut sections,
        "BREAKING: places that mean something else",
        report.meanings.iter().map(meaning).collect(),
    );
    let mut bodies = bodies(differences);
    let value = |change| value(differences, change);
    bodies.extend(of_the_tree.into_iter().map(value));
    let values = values.into_iter().map(value).collect();
    push(&mut sections, "bodies and joints", bodies);
    push(&mut sections, "values", values);
    let base = report.base.iter().map(meaning);
    push(&mut sections, "base parameters", base.collect());
    let held = report.held.iter().map(meaning);
    push(&mut sections, "constants", held.collect());
    let options = report.options.iter();
    let options =
        options.map(|(key, [old, new])| came_or_went(key.clone(), old.as_deref(), new.as_deref()));
    push(&mut sections, "options", options.collect());
    push(
        &mut sections,
        "operations",
        operations::rows(&report.functions),
    );
    let forms = report.forms.iter().map(form);
    push(
        &mut sections,
        "long functions written in another form, which changes many lines",
        forms.collect(),
    );
    sections
}

fn form(change: &FormChange) -> Row {
    let how = change.reasons.join("; ");
    ["changed".to_owned(), change.name.clone(), how]
}

fn meaning(change: &Meaning) -> Row {
    let how = format!("{} -> {}", change.old, change.new);
    ["changed".to_owned(), change.name.clone(), how]
}

fn layout(change: &LayoutChange) -> Section {
    let row = |what: &str, name: &String, how: String| [what.to_owned(), name.clone(), how];
    let added = change.added.iter();
    let added = added.map(|(name, place)| row("added", name, place.to_string()));
    let removed = change.removed.iter();
    let removed = removed.map(|(name, place)| row("removed", name, place.to_string()));
    let moved = runs(&change.moved).filter_map(|run| {
        let ((first, from), (last, to)) = (run.first()?, run.last()?);
        if run.len() == 1 {
            return Some(row("moved", first, format!("{} -> {}", from[0], from[1])));
        }
        let name = format!("{first} .. {last}");
        let [old, new] = [0, 1].map(|side| format!("{}..={}", from[side], to[side]));
        Some(row("moved", &name, format!("{old} -> {new}")))
    });
    let renamed = change.renamed.iter();
    let renamed = renamed.map(|([old, new], place)| {
        let name = format!("{old} -> {new}");
        row("renamed", &name, place.to_string())
    });
    let array = change.layout.name();
    Section {
        title: if change.has_other_places() {
            format!("BREAKING: the places in {array} changed")
        } else {
            format!("BREAKING: the names in {array} and in C headers changed")
        },
        rows: added.chain(removed).chain(moved).chain(renamed).collect(),
    }
}

/// What moved, with neighbours that moved alike together, if they are more than two.
fn runs(moved: &[Moved]) -> impl Iterator<Item = &[Moved]> {
    let follows = |(_, one): &Moved, (_, next): &Moved| {
        one.iter().zip(next).all(|(one, next)| one + 1 == *next)
    };
    let runs = moved.chunk_by(follows);
    runs.flat_map(|run| run.chunks(if run.len() > 2 { run.len() } else { 1 }))
}

/// A name with its old and new place.
type Moved = (String, [usize; 2]);

fn bodies(differences: &Differences) -> Vec<Row> {
    let row = |what: &str, body: &Body| {
        let said = |key: &str| body.values.get(key).map_or("", String::as_str);
        let kept = [("mass", "mass"), ("attachment", "at")].map(|(key, word)| {
            let value = body.values.get(key);
            value.map_or_else(String::new, |value| format!(", {word} {value}"))
        });
        let (lower, joint) = (said("lower_body"), said("joint"));
        let how = format!("on {lower}, joint {joint}{}", kept.concat());
        [what.to_owned(), body.name.clone(), how]
    };
    let added = differences.added.iter().map(|body| row("added", body));
    let removed = differences.removed.iter().map(|body| row("removed", body));
    // Those of arrays over bodies stand there.
    let mut arrays = differences.layouts.iter();
    let arrays = arrays.find(|change| change.layout == Layout::Bodies);
    let told = arrays.map_or(&[][..], |change| &change.renamed);
    let is_told = |names: &&[String; 2]| told.iter().any(|(own, _)| own == *names);
    let renamed = differences.renamed.iter().filter(|names| !is_told(names));
    let renamed = renamed.map(|[old, new]| {
        let name = format!("{old} -> {new}");
        ["renamed".to_owned(), name, String::new()]
    });
    added.chain(removed).chain(renamed).collect()
}

fn value(differences: &Differences, change: &ValueChange) -> Row {
    let key = &change.key;
    let name = match &change.body {
        Some(body) => match differences.old_name(body) {
            Some(old) => format!("{old} -> {body}: {key}"),
            None => format!("{body}: {key}"),
        },
        None => key.clone(),
    };
    came_or_went(name, change.old.as_deref(), change.new.as_deref())
}

fn came_or_went(name: String, old: Option<&str>, new: Option<&str>) -> Row {
    let (what, how) = match (old, new) {
        (Some(old), Some(new)) => ("changed", format!("{old} -> {new}")),
        (None, Some(new)) => ("added", new.to_owned()),
        (Some(old), None) => ("removed", old.to_owned()),
        (None, None) => ("", String::new()),
    };
    [what.to_owned(), name, how]
}
