//! `kane info`: what is known of a model, for people (`text`), for programs (`value`), or as a drawing.

mod facts;
mod mechanics;
mod text;
mod value;

use std::{io::Write, path::PathBuf};

use clap::Args;
use kane_codegen::{
    error::Error,
    functions::{CATALOGUE, Request},
    limits::COUNTED,
    options::{Functions, Options},
    recursive::Technique,
    report,
    tree::Tree,
};

use self::facts::Shown;
use crate::cli::{
    Failures, Outcome, Voice, arguments::changes::ChangesArguments, arguments::functions,
    arguments::parse::one_of, listed, rounded_angles, text::json,
};

/// Show a model's tree, coordinates, parameters, zeros of the mass matrix and operation counts
///
/// Bodies are numbered from 1, places in q and u from 0, as in code. A partition is the block of columns of a partial velocity that
/// belongs to one body's angles or translations: of N bodies, partition J belongs to the angles of body J, and partition N + J to
/// its translations. The axis of a joint has the components of the body that it moves.
///
/// If the `kane.toml` in the model's folder or the nearest one above lists the model, the options of the first system that does so
/// with these functions hold, or else of the first; options on the command line override them.
#[derive(Args, Debug)]
#[command(
    after_long_help = "Keys of --json. They are stable; later versions may add more:\n  \
    name            the system's name\n  \
    gravity         inertial components, m/s^2 (nominal)\n  \
    order           \"body\" or \"notes\"\n  \
    bodies          number, user_number (in the model), name, identifier (in code), joint, lower_body (0: inertial\n                  \
    frame), free (list of motions, theta1 or w1 .. s3), locked (object of coordinates and values, rad or m),\n                  \
    mimics (object of coordinates: coordinate, the place in q of the mimicked one, multiplier, offset),\n                  \
    gravity_compensation (the fraction of its weight that is compensated, nominal; absent: none), stiffness,\n                  \
    rest, damping, armature (objects of motions, nominal; absent: zero)\n  \
    coordinates     place (in q), name, body, kind (theta1 .. theta3, e0 .. e3, s1 .. s3), unit\n  \
    speeds          names, in the order of u\n  \
    limits          lower, upper (of coordinates), velocity, effort, friction (of speeds); null: none\n  \
    frames          fixed bodies, each part of another: name, body (0: inertial frame), rotation (by rows, from the\n                  \
    body's axes), position (m, nominal)\n  \
    markers         frames that only mark places, same keys as frames; absent if there are none\n  \
    partitions      body, and W, V_O, V_G: the numbers of the partitions that are not zero; null for more than 250 bodies\n  \
    parameters      name, body (null: the system), nominal, unit\n  \
    functions       name, default (in the default set), formulations (notes, recursive: total, mul, add, div, trig),\n                  \
    cheapest (the one that costs less: a sine counts as eleven operations). A formulation that would be too large is absent; if both\n                  \
    are, cheapest is null. Beyond 100 speeds or parts: only what --functions names\n\n\
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

    /// Count these functions instead of those that `kane.toml` asks for, or the default set, comma-separated; `all` stands for every function of the system
    ///
    /// `mass_matrix+bias` is one function that computes both. Without this option, --json counts all functions.
    #[arg(long, value_name = "A,B")]
    functions: Option<Vec<String>>,

    /// Show which partitions of the partial velocities are zero, Eqs. (16) and (30) of docs/equations.md, and the zeros of mass matrices
    /// of more than 24 speeds
    #[arg(long)]
    partitions: bool,

    /// Operation-saving techniques to disable, comma-separated
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
    let asked = arguments.functions.as_deref();
    let job = listed::looked_at(
        &arguments.model,
        &arguments.changes,
        asked.unwrap_or_default(),
    )?;
    let listed = &job.options.functions;
    let asked = asked.map(|asked| functions::functions(asked, Some(listed)));
    let mut failures = Failures::default();
    let asked = failures.keep(asked.transpose());
    let model = failures.keep(job.checked());
    failures.none()?;
    let (Some(asked), Some(model)) = (asked, model) else {
        unreachable!("info: what is absent left a failure")
    };
    voice.warn_of_numbers(&model.warnings);
    let tree = &model.tree;
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
    let mut options = Options {
        functions: asked.unwrap_or_else(|| unasked(listed, arguments.json)),
        ..job.options.clone()
    };
    if !arguments.without.is_empty() {
        options.without = arguments.without.iter().copied().collect();
    }
    // A program that asks for a set gets its counts, however long that takes.
    let are_wanted = arguments.json || matches!(options.functions, Functions::Named(_));
    let is_counted = !is_large || are_wanted && !are_default;
    let (mut counts, mut uncounted) = (Vec::new(), Vec::new());
    if is_counted || !are_default {
        let requests = requests(tree, &options.functions)
            .map_err(|error| job.refused_functions(error, are_default))?;
        if is_counted {
            rounded_angles::tell_of(&model.description, &options, None, voice);
            counts = report::count(tree, &requests, &options.without);
        } else {
            uncounted.extend(requests.iter().map(Request::text));
        }
    }
    let lacking = counts.iter().filter(|one| one.cheapest.is_none());
    for refused in lacking.filter_map(|one| one.refused.as_ref()) {
        voice.say(format_args!("note: {refused}"));
    }
    if arguments.json {
        json::write(out, &value::value(tree, &counts))?;
    } else {
        let shown = Shown {
            partitions: arguments.partitions,
            pattern,
            are_default,
            is_counted,
            uncounted,
        };
        text::write(out, tree, &counts, &shown)?;
    }
    Ok(Outcome::Done)
}

/// The functions that are counted where none are asked for: those that are generated, or all for programs.
fn unasked(listed: &Functions, json: bool) -> Functions {
    if json {
        Functions::All(Vec::new())
    } else {
        listed.clone()
    }
}

/// The functions that are asked for, or everything of them that the model lacks.
fn requests(tree: &Tree, functions: &Functions) -> Result<Vec<Request>, Error> {
    let of_set = CATALOGUE.iter().filter(|one| functions.set_has(one));
    let mut requests: Vec<Request> = of_set.map(Request::from).collect();
    requests.extend(functions.on(tree).map_err(Error::Requests)?);
    Ok(requests)
}
