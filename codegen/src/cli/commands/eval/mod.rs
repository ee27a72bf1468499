//! `kane eval`.

mod by_name;
mod place;
mod singular;
mod state;
mod unique;
mod unphysical;

use std::{
    fmt::Write as _,
    io::{self, Write},
    path::{Path, PathBuf},
    slice,
};

use clap::{ArgAction, Args};
use kane_codegen::{
    base_parameters,
    compile::{self, Plans},
    diagnostic::{Escaped, Source},
    error::Error,
    functions::{CompactBlock, Dimension, Packed, Parsed, Request, split},
    input,
    options::Formulation,
    recursive::Technique,
    solve,
    tree::Tree,
};
use serde_json::{Value, json};

use crate::cli::{
    Failures, Outcome, Voice, arguments::changes::ChangesArguments, arguments::functions,
    arguments::parse, job::Job, listed, text::json,
};

/// Evaluate one function at a state, and print the numbers as JSON
///
/// Evaluates, in f64, the expressions from which the function is generated; it compiles no code. The numbers have the
/// shape of the function's output: a number, a list, or nested lists; matrices are stored row by row. A number that is not finite is
/// null. Compact partial velocities have the form of the generated module: `columns`, a list of 3-vectors, and
/// `blocks`, which gives for each nonzero partition its body, partition, first speed, number of columns and first place in
/// `columns`, all from 0. What is packed has `places` beside it, the row and column of each entry, and packed Jacobians the `speeds` of
/// their columns. Factors also have the `order` of elimination: an entry of L is in the row of that of its two speeds which comes first there.
/// `base_regressor` has the `base_parameters` of its columns. Where there are several outputs, as of `jacobian(tool0)`, `d(bias)/d(q, u)` or
/// `mass_matrix+bias`, the result is an object of them by name, in order.
///
/// If the `kane.toml` in the model's folder or the nearest one above lists the model, the options of the first system that does so
/// with this function hold, or else of the first; options on the command line override them.
#[derive(Args, Debug)]
#[command(
    after_long_help = "The state file holds the inputs of the function, in SI units:\n  \
    {\n    \
    \"q\": [0.1, 0.2],           one number per coordinate, in the order of `kane info`\n    \
    \"u\": [0.0, 1.0],           one number per speed\n    \
    \"u_dot\": [0.0, 0.0],\n    \
    \"tau\": [0.0, 0.0],\n    \
    \"loads\": [                 one per body: at the mass centre, body components\n      \
    {\"force\": [0, 0, 1], \"moment\": [0, 0, 0]}\n    \
    ],\n    \
    \"w_rel\": [[0, 0, 1]],      one per body: relative angular velocity, for angle_rates\n    \
    \"point\": [0, 0, 0],         for point_jacobian; \"force\" and \"moment\" for generalized_force\n    \
    \"q_direction\": [1.0, 0.0],  for jvp, shaped like the variable (q_direction: like u); \"multiplier\" for vjp and hessian\n    \
    \"parameters\": {\"arm_mass\": 2.0}    those that differ from the nominal values\n  \
    }\n\
    Inputs that the function does not need may be absent; the sines and cosines of F(sin_cos) come from q. Coordinates, speeds and bodies may also be named. What is not named is zero, but the first number of a quaternion is one; a load that is given has both `force` and `moment`:\n  \
    {\"q\": {\"elbow\": 0.3}, \"u\": {}}\n\n\
    Examples:\n  \
    kane eval models/arm.toml --function mass_matrix --state state.json\n  \
    echo '{\"q\": [0.1, 0.2]}' | kane eval models/arm.toml --function rotation --state -"
)]
pub(crate) struct Arguments {
    /// The model
    #[arg(value_name = "MODEL")]
    model: PathBuf,

    #[command(flatten)]
    changes: ChangesArguments,

    /// The function, as in `kane generate --functions`, or by the name that `kane.toml` gives it
    #[arg(long, short, value_name = "NAME", required = true, action = ArgAction::Append)]
    function: Vec<String>,

    /// The state, a JSON file; `-` is standard input; not needed for functions without inputs, such as `inertial_parameters`
    #[arg(long, short, value_name = "FILE")]
    state: Option<PathBuf>,

    /// How to compute sums over bodies: `notes`, `recursive`, or `cheapest`, whichever costs less
    #[arg(long, value_name = "WHICH", value_parser = parse::one_of(Formulation::ALL))]
    formulation: Option<Formulation>,

    /// Operation-saving techniques to disable, comma-separated; the values stay the same
    #[arg(long, value_name = "A,B", value_delimiter = ',', value_parser = parse::one_of(Technique::ALL))]
    without: Vec<Technique>,
}

/// Evaluates and prints.
pub(crate) fn run(
    arguments: &Arguments,
    voice: Voice,
    out: &mut dyn Write,
) -> Result<Outcome, Failures> {
    let asked = only(&arguments.function)?;
    let mut failures = Failures::default();
    let job = listed::looked_at(
        &arguments.model,
        &arguments.changes,
        slice::from_ref(&asked),
    );
    let listed = job.as_ref().ok().map(|job| &job.options.functions);
    let is_named = listed.is_some_and(|listed| functions::named(&asked, listed).is_some());
    let function = failures.keep(functions::request(&asked, listed));
    let job = failures.keep(job);
    let checked = job.as_ref().map(Job::checked);
    let checked = checked.and_then(|checked| failures.keep(checked));
    let state = arguments.state.as_deref().map(read_state);
    let state = failures.keep(state.transpose());
    failures.none()?;
    let (Some(function), Some(job), Some(checked), Some(state)) = (function, job, checked, state)
    else {
        unreachable!("eval: what is absent left a failure")
    };
    let tree = &checked.tree;
    let function = function
        .on(tree)
        .map_err(|faults| job.refused_functions(Error::Requests(faults), is_named));
    let mut warnings = checked.warnings;
    let asked = function.as_ref().into_iter();
    warnings.extend(compile::nothing_prescribed(tree, asked));
    voice.warn_of_numbers(&warnings);
    let function = function?;
    let Some(state) = state.or_else(|| state::of_no_inputs(tree, &function)) else {
        let needs = format!(
            "`{}` needs a state; give one with `--state FILE`",
            function.text()
        );
        return Err(Failures::message(needs));
    };
    let inputs = state::read(&state, tree, &function, &job.options.changes)?;
    unphysical::check(tree, &function, &inputs, voice);
    let mut options = job.options;
    options.formulation = arguments.formulation.unwrap_or(options.formulation);
    if !arguments.without.is_empty() {
        options.without = arguments.without.iter().copied().collect();
    }
    compile::check_size(tree, slice::from_ref(&function), &options)?;
    let plans = Plans::new(tree, &options.without);
    let derived = compile::choose(&plans, &function, options.formulation).derived;
    let numbers = derived.graph.evaluate(&derived.roots, |input| {
        *inputs.get(&input).unwrap_or_else(|| {
            unreachable!(
                "eval: `{}` reads {input:?}, which is none of its arguments",
                function.name()
            )
        })
    });
    singular::check(&plans, &function, &derived, &inputs, &numbers, voice);
    let n_infinite = numbers.iter().filter(|number| !number.is_finite()).count();
    if n_infinite > 0 {
        voice.say(format_args!(
            "warning: {n_infinite} of {} numbers are not finite; they are shown as null",
            numbers.len()
        ));
    }
    let outputs = value(tree, &function, &numbers, &derived.blocks);
    write(out, &outputs)?;
    Ok(Outcome::Done)
}

/// The only function among these texts: commas outside brackets separate several.
fn only(texts: &[String]) -> Result<String, Failures> {
    let mut names: Vec<&str> = Vec::new();
    for name in texts.iter().flat_map(|text| split(text)).map(str::trim) {
        if !name.is_empty() && !names.contains(&name) {
            names.push(name);
        }
    }
    if let [] | [_] = names[..] {
        return Ok(names.concat());
    }
    let mut message = format!("{} functions are asked for; expected one", names.len());
    let joined = names.join("+");
    if Parsed::read(&joined).is_ok() {
        let _ = write!(message, ": join them with `+`, `{}`", joined.escaped());
    }
    Err(Failures::message(message))
}

/// Where it says which sums base parameters are.
const BASE_PARAMETERS: &str = "base_parameters";
const BASE_PARAMETER_NAMES: &str = "base_parameter_names";

/// What is written, and how to read it, with names.
type Outputs = Vec<(String, Value)>;

/// Writes an only output alone, several as an object.
fn write(out: &mut dyn Write, outputs: &Outputs) -> io::Result<()> {
    match &outputs[..] {
        [(_, only)] => json::write(out, only),
        _ => json::write_object(out, outputs),
    }
}

/// The outputs in their shapes, in the order asked for, before what says how to read them.
fn value(tree: &Tree, function: &Request, numbers: &[f64], compact: &[CompactBlock]) -> Outputs {
    let mut rest = numbers;
    let mut outputs = Outputs::new();
    let lengths = function.lengths(tree, numbers.len() / 3);
    for (output, lengths) in function.outputs().into_iter().zip(lengths) {
        let (own, others) = rest.split_at(lengths.iter().product());
        outputs.push((output.name.into_owned(), json::array(own, &lengths)));
        rest = others;
    }
    if function.compact().is_some() {
        outputs.push(("blocks".to_owned(), blocks(compact)));
    }
    let packed = function.packed();
    let mut parts = function.parts().iter();
    let is_only = packed.len() == 1 && parts.all(|part| part.sparsity(tree).is_none());
    for own in &packed {
        let key = key("places", own.function(), is_only);
        outputs.push((key, json!(own.places(tree))));
    }
    speeds(tree, function, &mut outputs);
    entries(tree, function, &mut outputs);
    if packed.contains(&Packed::Factors) {
        outputs.push(("order".to_owned(), json!(solve::elimination(tree))));
    }
    let mut written = function.outputs().into_iter();
    if written.any(|output| output.shape.has(Dimension::BaseParameters)) {
        let base = base_parameters::of(tree).iter();
        let names = base.map(|base| base_parameters::text(tree, base));
        // Values that are joined to others of one name have the function's.
        let key = if outputs.iter().any(|(name, _)| name == BASE_PARAMETERS) {
            BASE_PARAMETER_NAMES
        } else {
            BASE_PARAMETERS
        };
        outputs.push((key.to_owned(), names.collect()));
    }
    outputs
}

/// Adds which speeds the columns of packed Jacobians belong to, as places in `u`.
fn speeds(tree: &Tree, function: &Request, outputs: &mut Outputs) {
    let parts = function.parts().iter();
    let packed = parts.filter(|part| part.function.writes(Dimension::FrameSpeeds));
    let all: Vec<_> = packed
        .filter_map(|part| Some((part.name(), part.subject.as_ref()?.speeds(tree))))
        .collect();
    for (name, own) in &all {
        let places = own.iter().map(|speed| speed.index());
        outputs.push((key("speeds", name, all.len() == 1), places.collect()));
    }
}

/// Adds where the entries of packed derivatives stand, and the colours of their columns.
fn entries(tree: &Tree, function: &Request, outputs: &mut Outputs) {
    let parts = function.parts().iter();
    let all: Vec<_> = parts
        .filter_map(|part| Some((part.name(), part.sparsity(tree)?)))
        .collect();
    let is_only = all.len() == 1 && function.packed().is_empty();
    for (name, own) in all {
        outputs.push((key("places", &name, is_only), json!(own.places)));
        if let Some(colors) = &own.colors {
            outputs.push((key("colors", &name, is_only), json!(colors)));
        }
    }
}

/// What stands beside an output: with the function's name before it, where several have such a thing.
fn key(kind: &str, function: &str, is_only: bool) -> String {
    if is_only {
        kind.to_owned()
    } else {
        format!("{function}_{kind}")
    }
}

fn blocks(blocks: &[CompactBlock]) -> Value {
    let block = |block: &CompactBlock| {
        let CompactBlock {
            body,
            partition,
            speed,
            columns,
            first,
        } = block;
        json!({ "body": body, "partition": partition, "speed": speed, "columns": columns, "first": first })
    };
    blocks.iter().map(block).collect()
}

fn read_state(path: &Path) -> Result<Source, Error> {
    let (name, text) = if path == Path::new("-") {
        ("standard input".into(), input::text_from(io::stdin()))
    } else {
        let is_pipe = path
            .metadata()
            .is_ok_and(|file| !file.is_file() && !file.is_dir());
        let is_state = path.as_os_str().as_encoded_bytes().starts_with(b"{");
        let text = if is_state {
            Err(io::Error::other(
                "it is no file; `--state -` reads the state from standard input",
            ))
        } else if is_pipe {
            Err(io::Error::other(
                "it is no regular file; `--state -` reads standard input",
            ))
        } else {
            input::text(path)
        };
        (path.to_string_lossy(), text)
    };
    let text = text.map_err(|source| Error::Io {
        path: PathBuf::from(&*name),
        source,
    })?;
    Ok(Source::new(name, text))
}
