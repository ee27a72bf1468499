//! `kane info`: what is known of a model, for people (`text`), for programs (`value`), or as a drawing.

mod facts;
mod text;
mod value;

use std::{collections::BTreeSet, io::Write, path::PathBuf};

use clap::Args;
use kane_codegen::{
    error::Error,
    functions::{CATALOGUE, Parsed, Request},
    limits::COUNTED,
    options::{ALL, DEFAULT, is_set},
    recursive::Technique,
    report::{self, Counts},
    tree::Tree,
};

use self::facts::Shown;
use super::{
    Failures, Outcome, Voice, changes::ChangesArguments, job, json, options, parse::one_of,
    rounded_angles,
};

/// Show a model's tree, coordinates, parameters, the mass matrix's zeros and operation counts
///
/// Bodies and partitions are counted from 1: of N bodies, partition J belongs to the angles of body J and
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
    kane info models/arm.toml --svg > arm.svg\n  \
    kane info models/arm.toml --json | jq '.functions[] | {name, cheapest}'"
)]
pub(crate) struct Arguments {
    /// The model
    #[arg(value_name = "MODEL")]
    model: PathBuf,

    #[command(flatten)]
    changes: ChangesArguments,

    /// Count these functions in place of the default set, with commas between them; `all` stands for every function of the system
    ///
    /// `mass_matrix+bias` is one function that does both. --json counts all where nothing else is asked for.
    #[arg(long, value_name = "A,B")]
    functions: Option<Vec<String>>,

    /// Show which partitions of the partial velocities are zero, Eqs. (16) and (30)
    #[arg(long)]
    partitions: bool,

    /// Techniques to leave out that lower the number of operations, with commas between them
    #[arg(long, value_name = "A,B", value_delimiter = ',', value_parser = one_of(Technique::ALL))]
    without: Vec<Technique>,

    /// Print JSON for programs
    #[arg(long)]
    json: bool,

    /// Print a drawing of the tree and of the mass matrix's zeros, as SVG
    #[arg(long, conflicts_with = "json")]
    svg: bool,
}

/// Reads the model and prints what is known of it.
pub(crate) fn run(
    arguments: &Arguments,
    voice: Voice,
    out: &mut dyn Write,
) -> Result<Outcome, Failures> {
    let changes = &arguments.changes;
    changes.check()?;
    let asked = asked(arguments.functions.as_deref())?;
    let checked = job::check(
        &arguments.model,
        &changes.reading(),
        &changes.changes(),
        changes.prescribed(),
    )?;
    voice.warn(&checked.warnings);
    let tree = &checked.tree;
    let is_large = tree.n_speeds.max(tree.n_parts()) > COUNTED;
    let pattern = if is_large || arguments.json {
        Vec::new()
    } else {
        report::mass_matrix_pattern(tree)
    };
    if arguments.svg {
        out.write_all(report::svg(tree, &pattern).as_bytes())?;
        return Ok(Outcome::Done);
    }
    let are_default = asked.is_none();
    let requests = match asked {
        Some(asked) => asked.on(tree)?,
        None if is_large => Vec::new(),
        None => set(if arguments.json { ALL } else { DEFAULT }).collect(),
    };
    let without: BTreeSet<Technique> = arguments.without.iter().copied().collect();
    rounded_angles::tell_of(
        &arguments.model,
        changes,
        arguments.functions.as_deref(),
        &without,
        voice,
    );
    let counts = counts(tree, requests, &without);
    if arguments.json {
        json::write(out, &value::value(tree, &counts))?;
    } else {
        let partitions = arguments.partitions;
        let shown = Shown {
            partitions,
            pattern,
            are_default,
        };
        text::write(out, tree, &counts, &shown)?;
        if is_large && are_default {
            writeln!(
                out,
                "\nBeyond {COUNTED} speeds, or parts of bodies, only what --functions names is counted"
            )?;
        }
    }
    Ok(Outcome::Done)
}

/// The functions of a set of the system.
fn set(name: &str) -> impl Iterator<Item = Request> {
    let is_all = name == ALL;
    let functions = CATALOGUE.iter();
    let functions = functions.filter(move |function| is_all || function.is_default);
    functions.map(Request::from)
}

/// What `--functions` asks for: a set, and others.
struct Asked<'a> {
    set: Option<&'a str>,
    named: Vec<Parsed>,
}

/// The functions that are named, if they are.
fn asked(lists: Option<&[String]>) -> Result<Option<Asked<'_>>, Failures> {
    let Some(lists) = lists else {
        return Ok(None);
    };
    let mut failures = Failures::default();
    let (sets, names): (Vec<&str>, Vec<&str>) = options::names(lists)
        .into_iter()
        .partition(|name| is_set(name));
    let named = names.into_iter();
    let named = named
        .filter_map(|name| failures.keep(options::request(name)))
        .collect();
    failures.none()?;
    // All functions are more than the default set.
    let set = [ALL, DEFAULT].into_iter().find(|set| sets.contains(set));
    Ok(Some(Asked { set, named }))
}

impl Asked<'_> {
    /// The functions on the model, or everything that it lacks.
    fn on(&self, tree: &Tree) -> Result<Vec<Request>, Failures> {
        let mut failures = Failures::default();
        let on_tree = |asked: &Parsed| asked.on(tree).map_err(Error::Requests);
        let named = self.named.iter();
        let named = named.filter_map(|asked| failures.keep(on_tree(asked)));
        let requests = self.set.into_iter().flat_map(set).chain(named).collect();
        failures.none()?;
        Ok(requests)
    }
}

fn counts(tree: &Tree, requests: Vec<Request>, without: &BTreeSet<Technique>) -> Vec<Counts> {
    let requests = requests.into_iter();
    requests
        .map(|request| report::count(tree, request, without))
        .collect()
}
