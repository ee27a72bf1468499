//! What is known of a model, for people: in [`WIDTH`] columns, but for long names and for partitions.

use std::{
    collections::BTreeMap,
    io::{self, Write},
};

use kane_codegen::{
    diagnostic::count,
    functions::Formulation,
    limits::{COUNTED, PICTURED_BODIES},
    report::{self, Cell, Counts, Partitions},
    tree::{Frame, Order, Tree},
};

use super::{
    facts::{Shown, gravity, is_default, is_pictured, lifted, lower_number, operations},
    mechanics,
};

/// Columns of a line.
const WIDTH: usize = 100;

/// Writes the tree first, then what is asked for.
pub(super) fn write(
    out: &mut dyn Write,
    tree: &Tree,
    counts: &[Counts],
    shown: &Shown,
) -> io::Result<()> {
    let gravity = gravity(tree).map(|component| format!("{component:?}"));
    writeln!(
        out,
        "{}: {}, {}, {}; gravity ({}) m/s^2\n",
        tree.name,
        bodies(tree.bodies.len()),
        count(tree.n_coordinates, "coordinate"),
        count(tree.n_speeds, "speed"),
        gravity.join(", ")
    )?;
    if is_pictured(tree) {
        write!(out, "{}", report::picture(tree, WIDTH))?;
    } else {
        writeln!(
            out,
            "A tree of more than {PICTURED_BODIES} bodies is not shown"
        )?;
    }
    let lower = tree.body_ids().map(|body| lower_number(tree, body));
    let lower = lower.map(|number| number.to_string());
    writeln!(out)?;
    write_wrapped(out, "lower bodies [", lower.collect::<Vec<_>>(), ", ", "]")?;
    write_lifted(out, tree)?;
    write_frames(out, "Fixed to bodies, and part of them", tree, &tree.frames)?;
    write_frames(out, "Frames", tree, &tree.markers)?;
    write_coordinates(out, tree)?;
    write_mechanics(out, tree)?;
    write_parameters(out, tree)?;
    if shown.partitions || shown.pattern.len() <= SCREEN {
        write_pattern(out, &shown.pattern)?;
    }
    if shown.partitions && !is_pictured(tree) {
        writeln!(
            out,
            "\nPartitions of more than {PICTURED_BODIES} bodies are not shown"
        )?;
    } else if shown.partitions {
        write_partitions(out, tree, &report::partitions(tree))?;
    }
    if !shown.is_counted {
        writeln!(
            out,
            "\nBeyond {COUNTED} speeds, or parts of bodies, only what --functions names is counted"
        )?;
        for name in &shown.uncounted {
            writeln!(out, "  {name}")?;
        }
        return Ok(());
    }
    write_counts(out, counts, shown)
}

/// Which shares of weights are lifted.
fn write_lifted(out: &mut dyn Write, tree: &Tree) -> io::Result<()> {
    if tree.lifted != 0.0 {
        let share = tree.lifted;
        return writeln!(out, "\nGravity compensation: {share} of all weights");
    }
    let share = |body| {
        let share = lifted(tree, body)?;
        Some(format!("{} {share:.3}", tree.body(body).name))
    };
    let shares: Vec<String> = tree.body_ids().filter_map(share).collect();
    if shares.is_empty() {
        return Ok(());
    }
    writeln!(out, "\nGravity compensation, in parts of the weights\n")?;
    write_wrapped(out, "", shares, ", ", "")
}

fn bodies(number: usize) -> String {
    match number {
        1 => "1 body".to_owned(),
        _ => format!("{number} bodies"),
    }
}

/// Frames by the bodies to which they are fixed.
fn write_frames(out: &mut dyn Write, title: &str, tree: &Tree, frames: &[Frame]) -> io::Result<()> {
    if frames.is_empty() {
        return Ok(());
    }
    writeln!(out, "\n{title}\n")?;
    let mut on: BTreeMap<_, Vec<&str>> = BTreeMap::new();
    for frame in frames {
        on.entry(frame.body).or_default().push(&frame.name);
    }
    for (body, names) in on {
        let body = body.map_or("inertial frame", |body| &tree.body(body).name);
        let names = names.iter().map(|name| (*name).to_owned());
        write_wrapped(out, &format!("{body}: "), names, ", ", "")?;
    }
    Ok(())
}

fn write_coordinates(out: &mut dyn Write, tree: &Tree) -> io::Result<()> {
    let order = match tree.order {
        Order::Body => "body after body",
        Order::Notes => "all angles, then all translations",
    };
    let (coordinates, speeds) = (tree.coordinate_names(), tree.speed_names());
    let are_rates = coordinates.len() == speeds.len()
        && coordinates
            .iter()
            .zip(&speeds)
            .all(|(coordinate, speed)| speed.strip_suffix("_dot") == Some(coordinate));
    let both = if are_rates {
        ", and their rates in u"
    } else {
        ""
    };
    writeln!(out, "\nPlaces in q{both}: {order}\n")?;
    write_places(out, &coordinates)?;
    if !are_rates {
        writeln!(out, "\nPlaces in u\n")?;
        write_places(out, &speeds)?;
    }
    Ok(())
}

/// Names with their places, in columns, one after the other downward.
fn write_places(out: &mut dyn Write, names: &[String]) -> io::Result<()> {
    let digits = names.len().saturating_sub(1).to_string().len();
    let widths = names.iter().map(|name| name.chars().count());
    let width = widths.max().unwrap_or(0);
    let columns = (WIDTH / (digits + width + 3)).max(1);
    let rows = names.len().div_ceil(columns);
    for row in 0..rows {
        let cells = (row..names.len()).step_by(rows.max(1));
        let cells = cells.map(|place| format!("  {place:digits$} {:width$}", names[place]));
        let line: String = cells.collect();
        writeln!(out, "{}", line.trim_end())?;
    }
    Ok(())
}

/// A list over as many lines as it needs, those after the first further in.
fn write_wrapped(
    out: &mut dyn Write,
    title: &str,
    entries: impl IntoIterator<Item = String>,
    between: &str,
    last: &str,
) -> io::Result<()> {
    let mut line = format!("  {title}");
    let mut entries = entries.into_iter().peekable();
    let mut is_first = true;
    while let Some(entry) = entries.next() {
        let end = if entries.peek().is_some() {
            between
        } else {
            last
        };
        let wide = line.chars().count() + entry.chars().count() + end.trim_end().len();
        if wide > WIDTH && !is_first {
            writeln!(out, "{}", line.trim_end())?;
            "    ".clone_into(&mut line);
        }
        line.extend([&entry, end]);
        is_first = false;
    }
    writeln!(out, "{}", line.trim_end())
}

/// What acts in joints, a line a kind.
fn write_mechanics(out: &mut dyn Write, tree: &Tree) -> io::Result<()> {
    let kinds = mechanics::told(tree);
    if kinds.is_empty() {
        return Ok(());
    }
    writeln!(out, "\nIn joints, with nominal values\n")?;
    for (kind, values) in kinds {
        write_wrapped(out, &format!("{kind}: "), values, ", ", "")?;
    }
    Ok(())
}

fn write_parameters(out: &mut dyn Write, tree: &Tree) -> io::Result<()> {
    if tree.parameters.is_empty() {
        return Ok(());
    }
    writeln!(out, "\nParameters at run time, with nominal values\n")?;
    let width = tree
        .parameters
        .iter()
        .map(|parameter| parameter.name.len())
        .max()
        .unwrap_or(0);
    for parameter in &tree.parameters {
        write!(out, "  {:width$}  {:?}", parameter.name, parameter.nominal)?;
        match parameter.unit {
            "1" => writeln!(out)?,
            unit => writeln!(out, " {unit}")?,
        }
    }
    Ok(())
}

/// The most rows of a mass matrix that are shown unasked.
const SCREEN: usize = 24;

/// The mass matrix, an entry as one character: where it does not fit, nothing.
fn write_pattern(out: &mut dyn Write, pattern: &[Vec<bool>]) -> io::Result<()> {
    let is_full = pattern.iter().flatten().all(|entry| *entry);
    if pattern.is_empty() || is_full || pattern.len() + 2 > WIDTH {
        return Ok(());
    }
    let gap = if 2 * pattern.len() < WIDTH { " " } else { "" };
    writeln!(
        out,
        "\nMass matrix, in the order of u: x where it is not zero\n"
    )?;
    for row in pattern {
        let cells = row.iter().map(|entry| if *entry { "x" } else { "." });
        let cells: Vec<&str> = cells.collect();
        writeln!(out, "  {}", cells.join(gap))?;
    }
    Ok(())
}

fn write_partitions(out: &mut dyn Write, tree: &Tree, partitions: &Partitions) -> io::Result<()> {
    let n_bodies = tree.bodies.len();
    let cell = (2 * n_bodies).to_string().len() + 1;
    let label = |number: usize, name: &str| format!("{number} {name}");
    let labels: Vec<String> = tree
        .bodies
        .iter()
        .zip(1..)
        .map(|(body, number)| label(number, &body.name))
        .collect();
    let width = labels
        .iter()
        .map(|label| label.chars().count())
        .max()
        .unwrap_or(0);
    writeln!(
        out,
        "\nPartitions: J from 1 to {n_bodies} for the angles of body J, {n_bodies} + J for its translations\n\
         . zero   1 identity   P of Eq. (17)   x any other block\n"
    )?;
    let mut line = |label: &str, row: &str, cells: Vec<String>| {
        let cells = cells.iter().map(|text| format!("{text:>cell$}"));
        let mut cells: Vec<String> = cells.collect();
        cells.insert(n_bodies, " |".to_owned());
        writeln!(out, "{label:width$}  {row:3} {}", cells.concat())
    };
    line(
        "",
        "",
        (1..=2 * n_bodies)
            .map(|number| number.to_string())
            .collect(),
    )?;
    let rows = partitions
        .angular
        .iter()
        .zip(&partitions.origin)
        .zip(&partitions.mass_center);
    for (label, ((angular, origin), mass_center)) in labels.iter().zip(rows) {
        let text = |cells: &[Cell]| cells.iter().map(Cell::to_string).collect();
        line(label, "W", text(angular))?;
        line("", "V_O", text(origin))?;
        line("", "V_G", text(mass_center))?;
    }
    Ok(())
}

/// The operations of functions in both formulations; a star marks the one that is generated.
fn write_counts(out: &mut dyn Write, counts: &[Counts], shown: &Shown) -> io::Result<()> {
    let others = if shown.are_default {
        "; others: --functions all"
    } else {
        ""
    };
    writeln!(out, "\nOperations by formulation, * is generated{others}\n")?;
    let names = counts
        .iter()
        .map(|count| name(count, shown).chars().count());
    let width = 2 + names.max().unwrap_or(0).max(34);
    writeln!(out, "{:width$}{:>9}{:>11}", "", "notes", "recursive")?;
    for one in counts {
        let name = name(one, shown);
        let cell = |formulation: Formulation| match operations(one, formulation) {
            Some(operations) => {
                let mark = if Some(formulation) == one.cheapest {
                    "*"
                } else {
                    " "
                };
                format!("{}{mark}", operations.total())
            }
            None => "- ".to_owned(),
        };
        let (notes, recursive) = (cell(Formulation::Notes), cell(Formulation::Recursive));
        writeln!(
            out,
            "{}",
            format!("  {name:w$}{notes:>9}{recursive:>11}", w = width - 2).trim_end()
        )?;
    }
    Ok(())
}

/// A named sum that is longer is shown by its name: counts are to stay on the screen.
const LONGEST_NAME: usize = 60;

/// The function as it is asked for; where all are shown, those of the default set are marked.
fn name(count: &Counts, shown: &Shown) -> String {
    let mark = if is_default(count) && !shown.are_default {
        " (default)"
    } else {
        ""
    };
    let mut text = count.function.text();
    if text.len() > LONGEST_NAME && text != count.function.sum() {
        text = format!("{} = ..", count.function.name());
    }
    format!("{text}{mark}")
}
