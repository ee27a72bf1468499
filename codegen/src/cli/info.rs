//! `kane info`.

use std::{
    collections::BTreeSet,
    io::{self, Write},
    path::PathBuf,
};

use clap::Args;
use kane_codegen::{
    error::Error,
    functions::{CATALOGUE, Formulation, Parsed, Request},
    id::BodyId,
    limits::{COUNTED, DRAWN_BODIES},
    program::Operations,
    recursive::Technique,
    report::{self, Cell, Counts, Partitions},
    tree::{self, Coordinate, Order, Tree},
};
use serde_json::{Map, Value, json};

use super::{
    Failures, Outcome, changes::ChangesArguments, job, json, options, parse::one_of, rounded_angles,
};

/// Show a model's tree, coordinates, partitions, parameters and operation counts
///
/// Bodies and partitions are counted from 1, as in the notes: of N bodies, partition J belongs to the angles of body J and
/// partition N + J to its translations. Places in q and u are counted from 0, as in code.
#[derive(Args, Debug)]
#[command(
    after_long_help = "Keys of --json, which stay as they are; more may come:\n  \
    name            the system's name\n  \
    gravity         inertial components, m/s^2 (nominal)\n  \
    order           \"body\" or \"notes\"\n  \
    bodies          number, user_number (in the model), name, identifier (in code), joint, lower_body (0: inertial\n                  \
    frame), free (list of motions, theta1 or w1 .. s3), locked (object of coordinates and values, rad or m),\n                  \
    mimics (object of coordinates: coordinate, the place in q of the one that is followed, multiplier, offset)\n  \
    coordinates     place (in q), name, body, kind (theta1 .. theta3, e0 .. e3, s1 .. s3), unit\n  \
    speeds          names, in the order of u\n  \
    frames          what is fixed to bodies and part of them: name, body (0: inertial frame), rotation (by rows, from the\n                  \
    body's axes), position (m, nominal)\n  \
    markers         frames that only mark places, as frames; absent where there are none\n  \
    partitions      body, and W, V_O, V_G: the numbers of the partitions that are not zero; null for more than 250 bodies\n  \
    parameters      name, body (null: the system), nominal, unit\n  \
    functions       name, default (in the default set), formulations (notes, recursive: total, mul, add, div, trig),\n                  \
    cheapest (the one with fewer operations); without those that would be too large, of which null is the cheapest,\n                  \
    and, beyond 100 speeds or parts, only what --functions names\n\n\
    Examples:\n  \
    kane info models/arm.toml\n  \
    kane info models/arm.toml --json | jq '.functions[] | {name, cheapest}'"
)]
pub(crate) struct Arguments {
    /// The model
    #[arg(value_name = "MODEL")]
    model: PathBuf,

    #[command(flatten)]
    changes: ChangesArguments,

    /// Count these functions in place of all, with commas between them; `mass_matrix+bias` is one function that does both
    #[arg(long, value_name = "A,B")]
    functions: Option<Vec<String>>,

    /// Techniques to leave out that lower the number of operations, with commas between them
    #[arg(long, value_name = "A,B", value_delimiter = ',', value_parser = one_of(Technique::ALL))]
    without: Vec<Technique>,

    /// Print JSON for programs
    #[arg(long)]
    json: bool,
}

/// Reads the model and prints what is known of it.
pub(crate) fn run(arguments: &Arguments, out: &mut dyn Write) -> Result<Outcome, Failures> {
    let changes = &arguments.changes;
    changes.check()?;
    let asked = asked(arguments.functions.as_deref())?;
    let checked = job::check(
        &arguments.model,
        &changes.reading(),
        &changes.changes(),
        changes.prescribed(),
    )?;
    job::warn(&checked.warnings);
    let tree = &checked.tree;
    let requests = match asked {
        Some(asked) => resolved(&asked, tree)?,
        None if tree.n_speeds.max(tree.n_parts()) > COUNTED => Vec::new(),
        None => CATALOGUE.iter().map(Request::from).collect(),
    };
    let without: BTreeSet<Technique> = arguments.without.iter().copied().collect();
    rounded_angles::tell_of(
        &arguments.model,
        changes,
        arguments.functions.as_deref(),
        &without,
    );
    if arguments.json {
        json::write(out, &value(tree, &counts(tree, requests, &without)))?;
    } else {
        write(out, tree, &counts(tree, requests, &without))?;
    }
    Ok(Outcome::Done)
}

/// The functions that are named, if they are.
fn asked(lists: Option<&[String]>) -> Result<Option<Vec<Parsed>>, Failures> {
    let Some(lists) = lists else {
        return Ok(None);
    };
    let mut failures = Failures::default();
    let asked = options::names(lists).into_iter();
    let asked = asked
        .filter_map(|name| failures.keep(options::request(name)))
        .collect();
    failures.none()?;
    Ok(Some(asked))
}

/// The functions on the model, or everything that it lacks.
fn resolved(asked: &[Parsed], tree: &Tree) -> Result<Vec<Request>, Failures> {
    let mut failures = Failures::default();
    let on_tree = |asked: &Parsed| asked.on(tree).map_err(Error::Requests);
    let requests = asked.iter();
    let requests = requests
        .filter_map(|asked| failures.keep(on_tree(asked)))
        .collect();
    failures.none()?;
    Ok(requests)
}

fn counts(tree: &Tree, requests: Vec<Request>, without: &BTreeSet<Technique>) -> Vec<Counts> {
    let requests = requests.into_iter();
    requests
        .map(|request| report::count(tree, request, without))
        .collect()
}

fn write(out: &mut dyn Write, tree: &Tree, counts: &[Counts]) -> io::Result<()> {
    let order = match tree.order {
        Order::Body => "body after body",
        Order::Notes => "all angles, then all translations, Eq. (1)",
    };
    let gravity = gravity(tree)
        .map(|component| format!("{component:?}"))
        .join(", ");
    writeln!(
        out,
        "{}: {} bodies, {} coordinates",
        tree.name,
        tree.bodies.len(),
        tree.n_coordinates
    )?;
    writeln!(out, "gravity ({gravity}) m/s^2, inertial components")?;
    let lower = tree.body_ids().map(|body| lower_number(tree, body));
    let lower: Vec<String> = lower.map(|number| number.to_string()).collect();
    writeln!(out, "lower bodies [{}]", lower.join(", "))?;
    if is_drawn(tree) {
        let title = "Tree: number, body, free coordinates, locked ones that are not zero";
        writeln!(out, "\n{title}\n\n{}", report::picture(tree).trim_end())?;
    } else {
        writeln!(
            out,
            "\nTree and partitions are drawn of at most {DRAWN_BODIES} bodies"
        )?;
    }
    write_frames(out, tree)?;
    write_coordinates(out, tree, order)?;
    if is_drawn(tree) {
        write_partitions(out, tree, &report::partitions(tree))?;
    }
    write_parameters(out, tree)?;
    if counts.is_empty() {
        return writeln!(
            out,
            "\nBeyond {COUNTED} speeds, or parts of bodies, only what --functions names is counted"
        );
    }
    write_counts(out, counts)
}

/// True where there is room for the tree and its partitions.
fn is_drawn(tree: &Tree) -> bool {
    tree.bodies.len() <= DRAWN_BODIES
}

/// Bodies that are part of others.
fn write_frames(out: &mut dyn Write, tree: &Tree) -> io::Result<()> {
    if !tree.frames.is_empty() {
        writeln!(out, "\nFixed to them, and part of them\n")?;
    }
    for frame in &tree.frames {
        let body = frame
            .body
            .map_or("the inertial frame", |body| &tree.body(body).name);
        writeln!(out, "{} to {body}", frame.name)?;
    }
    if !tree.markers.is_empty() {
        writeln!(out, "\nFrames that mark places\n")?;
    }
    for frame in &tree.markers {
        let body = frame
            .body
            .map_or("the inertial frame", |body| &tree.body(body).name);
        writeln!(out, "{} in {body}", frame.name)?;
    }
    Ok(())
}

fn write_coordinates(out: &mut dyn Write, tree: &Tree, order: &str) -> io::Result<()> {
    let (coordinates, speeds) = (tree.coordinate_names(), tree.speed_names());
    let are_rates = coordinates.len() == speeds.len()
        && coordinates
            .iter()
            .zip(&speeds)
            .all(|(coordinate, speed)| speed.strip_suffix("_dot") == Some(coordinate));
    let rates = if are_rates {
        "; the rate has the same place in u"
    } else {
        ""
    };
    writeln!(out, "\nCoordinates, {order}: place in q{rates}\n")?;
    for (place, name) in coordinates.iter().enumerate() {
        writeln!(out, "{place:4}  {name}")?;
    }
    if !are_rates {
        writeln!(out, "\nSpeeds: place in u\n")?;
        for (place, name) in speeds.iter().enumerate() {
            writeln!(out, "{place:4}  {name}")?;
        }
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

fn write_parameters(out: &mut dyn Write, tree: &Tree) -> io::Result<()> {
    if tree.parameters.is_empty() {
        return writeln!(out, "\nParameters at run time: none");
    }
    writeln!(out, "\nParameters at run time, with nominal values\n")?;
    let width = tree
        .parameters
        .iter()
        .map(|parameter| parameter.name.len())
        .max()
        .unwrap_or(0);
    for parameter in &tree.parameters {
        writeln!(
            out,
            "{:width$}  {:?} {}",
            parameter.name, parameter.nominal, parameter.unit
        )?;
    }
    Ok(())
}

fn write_counts(out: &mut dyn Write, counts: &[Counts]) -> io::Result<()> {
    writeln!(
        out,
        "\nOperations of each function in both formulations; * is generated unless another is asked for; (d) is in the default set\n"
    )?;
    writeln!(out, "{:36}{:>9}{:>11}", "", "notes", "recursive")?;
    for count in counts {
        let name = count.function.text();
        let default = if is_default(count) { " (d)" } else { "" };
        let cell = |formulation: Formulation| match operations(count, formulation) {
            Some(operations) => {
                let mark = if Some(formulation) == count.cheapest {
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
            format!("{:36}{notes:>9}{recursive:>11}", format!("{name}{default}")).trim_end()
        )?;
    }
    Ok(())
}

/// True for a function of the default set.
fn is_default(count: &Counts) -> bool {
    let alone = count.function.alone();
    alone.is_some_and(|part| part.function.is_default)
}

fn operations(count: &Counts, formulation: Formulation) -> Option<Operations> {
    let found = count
        .formulations
        .iter()
        .find(|(known, _)| *known == formulation);
    found.map(|(_, operations)| *operations)
}

/// The entry of the body-connection array: 0 for the inertial frame.
fn lower_number(tree: &Tree, body: BodyId) -> usize {
    tree.lower(body).map_or(0, |lower| lower.index() + 1)
}

fn gravity(tree: &Tree) -> [f64; 3] {
    tree.gravity.map(|component| tree.nominal(component))
}

fn value(tree: &Tree, counts: &[Counts]) -> Value {
    let order = match tree.order {
        Order::Body => "body",
        Order::Notes => "notes",
    };
    let bodies: Value = tree.body_ids().map(|body| body_value(tree, body)).collect();
    let counts: Value = counts.iter().map(counts_value).collect();
    let parameter = |parameter: &tree::Parameter| {
        let body = parameter.body.map(|body| body.index() + 1);
        json!({ "name": parameter.name, "body": body, "nominal": parameter.nominal, "unit": parameter.unit })
    };
    let mut value = json!({
        "name": tree.name,
        "gravity": gravity(tree),
        "order": order,
        "bodies": bodies,
        "coordinates": coordinates_value(tree),
        "speeds": tree.speed_names(),
        "frames": tree.frames.iter().map(frame_value).collect::<Value>(),
        "partitions": is_drawn(tree).then(|| partitions_value(&report::partitions(tree))),
        "parameters": tree.parameters.iter().map(parameter).collect::<Value>(),
        "functions": counts,
    });
    if !tree.markers.is_empty() {
        value["markers"] = tree.markers.iter().map(frame_value).collect();
    }
    value
}

fn body_value(tree: &Tree, id: BodyId) -> Value {
    let body = tree.body(id);
    let joint = &body.joint;
    let mut free = Vec::new();
    let mut locked = Map::new();
    let mut mimics = Map::new();
    for (motion, kind) in joint.motion_names().into_iter().enumerate() {
        match joint.coordinate_of(motion) {
            Some(Coordinate::Free { .. }) | None => free.push(kind),
            Some(Coordinate::Locked(value)) => {
                locked.insert(kind.to_owned(), value.into());
            }
            Some(Coordinate::Mimic {
                coordinate,
                multiplier,
                offset,
                ..
            }) => {
                let value = json!({ "coordinate": coordinate.index(), "multiplier": multiplier, "offset": offset });
                mimics.insert(kind.to_owned(), value);
            }
        }
    }
    json!({
        "number": id.index() + 1,
        "user_number": body.user_number,
        "name": body.name,
        "identifier": body.identifier,
        "joint": joint.name,
        "lower_body": lower_number(tree, id),
        "free": free,
        "locked": locked,
        "mimics": mimics,
    })
}

fn frame_value(frame: &tree::Frame) -> Value {
    json!({
        "name": frame.name,
        "body": frame.body.map_or(0, |body| body.index() + 1),
        "rotation": frame.rotation,
        "position": frame.position,
    })
}

fn coordinates_value(tree: &Tree) -> Value {
    let mut values = vec![Value::Null; tree.n_coordinates];
    let names = tree.coordinate_names();
    for (body, number) in tree.bodies.iter().zip(1..) {
        for (kind, coordinate) in body.joint.coordinates() {
            let unit = match kind.as_bytes()[0] {
                b't' => "rad",
                b's' => "m",
                _ => "1",
            };
            let place = coordinate.index();
            values[place] = json!({ "place": place, "name": names[place], "body": number, "kind": kind, "unit": unit });
        }
    }
    values.into()
}

fn partitions_value(partitions: &Partitions) -> Value {
    let numbers = |cells: &Vec<Cell>| -> Value {
        let cells = cells.iter().zip(1_usize..);
        cells
            .filter(|(cell, _)| **cell != Cell::Zero)
            .map(|(_, number)| number)
            .collect()
    };
    let rows = partitions
        .angular
        .iter()
        .zip(&partitions.origin)
        .zip(&partitions.mass_center);
    rows.zip(1_usize..)
        .map(|(((angular, origin), mass_center), body)| {
            json!({ "body": body, "W": numbers(angular), "V_O": numbers(origin), "V_G": numbers(mass_center) })
        })
        .collect()
}

fn counts_value(counts: &Counts) -> Value {
    let formulation = |(formulation, operations): &(Formulation, Operations)| {
        let Operations {
            mul,
            add,
            div,
            trig,
        } = operations;
        let value = json!({ "total": operations.total(), "mul": mul, "add": add, "div": div, "trig": trig });
        (formulation.name().to_owned(), value)
    };
    let formulations: Map<String, Value> = counts.formulations.iter().map(formulation).collect();
    json!({
        "name": counts.function.text(),
        "default": is_default(counts),
        "formulations": formulations,
        "cheapest": counts.cheapest.map(Formulation::name),
    })
}
