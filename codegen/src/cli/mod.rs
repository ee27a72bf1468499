//! The command line: what can be asked for, and what comes back.
//!
//! Each subcommand is a file of `commands`. Results go to standard output;
//! warnings, faults and the line about each file to standard error. Files are read and written here, in
//! [`kane_codegen::output`] and nowhere below.

mod arguments;
mod commands;
mod text;
// What they share: which systems, where they stand, what is wrong with them.
mod clashes;
mod failure;
mod git;
mod job;
mod listed;
mod outcome;
mod paths;
mod rounded_angles;
mod runtime;
mod stray;
mod target;

use std::io::Write;

use clap::{CommandFactory as _, Parser, Subcommand};

use commands::{check, completions, convert, diff, eval, generate, info, new, verify};
pub(crate) use failure::Failures;
pub(crate) use outcome::{BAD_INPUT, Outcome};
pub(crate) use text::pipe::Pipe;
pub(crate) use text::voice::{Voice, say};

/// Compiler from multibody systems to flat, allocation-free Rust.
#[derive(Debug, Parser)]
#[command(
    name = "kane",
    version,
    long_about = "Compiler from multibody systems (trees of rigid bodies) to flat, allocation-free Rust.\n\n\
        A model (TOML, URDF or MJCF) describes the bodies and their joints. `kane generate` writes a Rust module with one \
        straight-line function per quantity: mass matrix, bias, forward dynamics and so on. `kane.toml` lists the \
        models of a repository and the files generated from them; in continuous integration, `kane check` tests \
        whether those files match their models.",
    after_help = "Exit codes:\n  \
        0  done; nothing differs\n  \
        1  `kane check`: a file differs, is missing, is over budget, or no system produces it; `kane diff`: something differs; `kane verify`: a promise is broken\n  \
        2  bad input, or a file that cannot be read or written; nothing was written",
    after_long_help = "Exit codes:\n  \
        0  done; nothing differs\n  \
        1  `kane check`: a file differs, is missing, is over budget, or no system produces it; `kane diff`: something differs; `kane verify`: a promise is broken\n  \
        2  bad input, or a file that cannot be read or written; nothing was written\n\n\
        Examples:\n  \
        kane new my_arm panda.urdf                         a package with a control loop\n  \
        kane generate                                      everything in kane.toml\n  \
        kane check                                         are the files up to date?\n  \
        kane generate models/arm.toml --output src/arm.rs  one model, no kane.toml needed\n  \
        kane diff HEAD:models/arm.toml models/arm.toml     what changed?\n  \
        kane info models/arm.toml                          tree, coordinates, operation counts\n  \
        kane eval models/arm.toml --function mass_matrix --state state.json\n  \
        kane convert panda.urdf --output models/panda.toml\n  \
        kane verify generated/arm.rs                       check the machine code\n\n\
        kane.toml, with paths relative to it:\n  \
        [[system]]\n  \
        model = \"models/arm.toml\"\n  \
        output = \"generated/arm.rs\"\n  \
        abi = \"c\"                    # arm_c.rs and arm.h beside it, for programs in C\n  \
        functions = [\"all\"]          # or names, also \"default\"; absent: the default set\n  \
        formulation = \"cheapest\"     # or notes, recursive; absent: cheapest\n  \
        fma = true                   # fused multiply-add; absent: false, the same bits everywhere\n  \
        without = [\"regroup\"]        # operation-saving techniques to disable\n  \
        manifest = true              # arm.json beside it\n  \
        tests = true                 # arm_tests.rs beside it\n  \
        budget = { bias = 60, mass_matrix = { mul = 20, total = 35 } } # the most operations that `kane check` accepts\n  \
        snap = 1e-5                  # snap entries of constant rotations this near to 0, 1 or -1; absent: 1e-9\n  \
        lock = { elbow = 0.5 }       # coordinates to hold at a value\n  \
        remove = [\"finger_1\"]        # joints to fix at zero\n  \
        remove_massless = true       # also fix every motion that moves no mass\n  \
        prescribed = [\"base\"]        # joints whose accelerations `hybrid_dynamics` takes as inputs\n\n  \
        [[system]]\n  \
        model = \"models/panda.urdf\"\n  \
        output = \"generated/panda.rs\"\n  \
        base = \"free\"                # the root link's joint; absent: fixed\n  \
        chart = \"angles\"             # coordinates of free and ball joints, also of an MJCF; absent: quaternion\n\n  \
        [[system]]\n  \
        model = \"models/gripper.xml\"\n  \
        output = \"generated/gripper.rs\"\n  \
        leave_out = [\"fluid\"]        # parts of an MJCF to ignore: equalities, fluid, tendons, gravcomp, or one equality"
)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    command: Command,

    #[command(flatten)]
    voice: Voice,
}

#[derive(Debug, Subcommand)]
enum Command {
    New(new::Arguments),
    Generate(generate::Arguments),
    Check(check::Arguments),
    Diff(diff::Arguments),
    Info(info::Arguments),
    Eval(eval::Arguments),
    Convert(convert::Arguments),
    Verify(verify::Arguments),
    Completions(completions::Arguments),
}

/// Does what is asked for; results go to `out`.
pub(crate) fn run(arguments: &Arguments, out: &mut dyn Write) -> Result<Outcome, Failures> {
    let voice = arguments.voice;
    let outcome = match &arguments.command {
        Command::New(arguments) => new::run(arguments, voice, out)?,
        Command::Generate(arguments) => generate::run(arguments, voice, out)?,
        Command::Check(arguments) => check::run(arguments, voice, out)?,
        Command::Diff(arguments) => diff::run(arguments, voice, out)?,
        Command::Info(arguments) => info::run(arguments, voice, out)?,
        Command::Eval(arguments) => eval::run(arguments, voice, out)?,
        Command::Convert(arguments) => convert::run(arguments, voice, out)?,
        Command::Verify(arguments) => verify::run(arguments, voice, out)?,
        Command::Completions(arguments) => completions::run(arguments, Arguments::command(), out)?,
    };
    out.flush()?;
    Ok(outcome)
}
