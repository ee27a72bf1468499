//! Every function, in both precisions, called from C and from Rust by programs written from the manifest.

use std::{fmt::Write as _, fs, process::Command};

use kane_test_support::{systems::trees, tool::tools};
use serde_json::Value;

use super::{C, WARNINGS, bits, folder, headers, run, steps};

const MANIFEST: &str = r#"
[workspace]

[package]
name = "every"
version = "0.0.0"
edition = "2021"

[lib]
crate-type = ["staticlib", "rlib"]

[dependencies]
kane = { path = "KANE", default-features = false }
"#;

/// Both programs fill arguments without a pattern, and without rounding in either precision.
const RUST: &str = r#"
use every::claw::{self, NB, NQ, NU, Parameters, Prepared, SinCos};
use kane::conditions::{Driven, Loaded};
use kane::discrete::{Change, StepDerivatives, euler, rk4};
use kane::manifold::{q_minus, q_plus};
use kane::{Load, Real};

trait Numbers { fn print(&self); }
impl Numbers for f64 { fn print(&self) { print!(" {self:?}") } }
impl Numbers for f32 { fn print(&self) { print!(" {:?}", f64::from(*self)) } }
impl<T: Numbers, const N: usize> Numbers for [T; N] {
    fn print(&self) { self.iter().for_each(Numbers::print) }
}

fn entries<R: Real, const N: usize>(kind: usize) -> [R; N] {
    core::array::from_fn(|place| entry(kind as i64, place as i64))
}

fn entry<R: Real>(kind: i64, place: i64) -> R {
    R::from_f64(((7 * place + 5 * kind) % 17 - 8) as f64 / 8.0)
}

fn all<R: Real + Numbers>() {
    let p = Prepared::new(&CHANGED);
    let (q, u, u_dot, tau): ([R; NQ], [R; NU], [R; NU], [R; NU]) = (entries(0), entries(1), entries(2), entries(3));
    let w_rel: [[R; 3]; NB] = core::array::from_fn(|body| core::array::from_fn(|i| entry(4, (3 * body + i) as i64)));
    let loads: [Load<R>; NB] = core::array::from_fn(|body| Load {
        force: core::array::from_fn(|i| entry(5, (3 * body + i) as i64)),
        moment: core::array::from_fn(|i| entry(6, (3 * body + i) as i64)),
    });
    let (point, force, moment): ([R; 3], [R; 3], [R; 3]) = (entries(7), entries(8), entries(9));
    let (q_direction, u_direction, tau_direction): ([R; NU], [R; NU], [R; NU]) = (entries(12), entries(13), entries(14));
    let (multiplier, q_multiplier, u_multiplier): ([R; NU], [R; NU], [R; NU]) = (entries(15), entries(16), entries(18));
    let (whole_u_dot_multiplier, whole_tau_multiplier): ([R; NU], [R; NU]) = (entries(19), entries(20));
ALONG    let zero = R::from_f64(0.0);
    let mut sin_cos = SinCos { sines: [zero; claw::NA], cosines: [zero; claw::NA] };
    claw::sin_cos(&p, &q, &mut sin_cos);
CALLS
    let _ = (&q_multiplier, &u_multiplier);
    let (direction, to): ([R; NU], [R; NQ]) = (entries(10), entries(11));
    print!("q_plus.q_after"); q_plus(&p, &q, &direction).print(); println!();
    print!("q_minus.direction"); q_minus(&p, &q, &to).print(); println!();
SCALED    let dt = R::from_f64(0.125);
    let show = |name: &str, (q_after, u_after): &([R; NQ], [R; NU])| {
        print!("{name}.q_after"); q_after.print(); println!();
        print!("{name}.u_after"); u_after.print(); println!();
    };
    let pair = |name: &str, [first, second]: [&str; 2], change: &Change<[R; NU]>| {
        print!("{name}.{first}"); change.q.print(); println!();
        print!("{name}.{second}"); change.u.print(); println!();
    };
    let rows = |rows: &[&[[R; NU]; NU]]| {
        for row in 0..NU {
            rows.iter().for_each(|block| block[row].print());
        }
    };
    let matrices = |name: &str, d: &StepDerivatives<[[R; NU]; NU]>| {
        print!("{name}.a"); rows(&[&d.q_by_q, &d.q_by_u]); rows(&[&d.u_by_q, &d.u_by_u]); println!();
        print!("{name}.b"); rows(&[&d.q_by_tau]); rows(&[&d.u_by_tau]); println!();
    };
    let (loaded, driven) = (Loaded { system: &p, loads }, Driven { system: &p, u_dot });
STEPS    let _ = (&show, &pair, &matrices, &loaded, &driven);
}

fn main() {
    all::<f64>();
    all::<f32>();
}
"#;

/// Where there are quaternions.
const RUST_SCALED: &str = r#"
    let mut scaled = q;
    kane::manifold::scale_quaternions(&p, &mut scaled);
    print!("scale_quaternions.q_after"); scaled.print(); println!();
"#;

/// Where there are values set at run time.
const RUST_ALONG: &str = "let parameters_direction: [R; claw::PARAMETERS_LEN] = entries(21);\n";
const C_ALONG: &str = "REAL parameters_direction[CLAW_PARAMETERS_LEN];
    fill_SCALAR(21, CLAW_PARAMETERS_LEN, parameters_direction);";

const C_BEGINNING: &str = r#"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "claw.h"

static double entry(long kind, long place)
{
    return ((7 * place + 5 * kind) % 17 - 8) / 8.0;
}
"#;

/// `SCALAR` and `REAL` are the names of a precision.
const C_ALL: &str = r#"
static void fill_SCALAR(long kind, long n, REAL *entries)
{
    for (long place = 0; place < n; place++) {
        entries[place] = (REAL)entry(kind, place);
    }
}

static void print_SCALAR(long n, const REAL *values)
{
    for (long i = 0; i < n; i++) {
        printf(" %.17g", (double)values[i]);
    }
}

static void all_SCALAR(void)
{
    claw_parameters_SCALAR parameters;
    claw_nominal_SCALAR(&parameters);
    CHANGED
    claw_prepared_SCALAR p;
    claw_prepare_SCALAR(&parameters, &p);
    REAL q[CLAW_NQ], u[CLAW_NU], u_dot[CLAW_NU], tau[CLAW_NU], w_rel[3 * CLAW_NB];
    REAL point[3], force[3], moment[3];
    fill_SCALAR(0, CLAW_NQ, q);
    fill_SCALAR(1, CLAW_NU, u);
    fill_SCALAR(2, CLAW_NU, u_dot);
    fill_SCALAR(3, CLAW_NU, tau);
    fill_SCALAR(4, 3 * CLAW_NB, w_rel);
    REAL q_direction[CLAW_NU], u_direction[CLAW_NU], tau_direction[CLAW_NU];
    REAL multiplier[CLAW_NU], q_multiplier[CLAW_NU], u_multiplier[CLAW_NU];
    REAL whole_u_dot_multiplier[CLAW_NU], whole_tau_multiplier[CLAW_NU];
    fill_SCALAR(12, CLAW_NU, q_direction);
    fill_SCALAR(13, CLAW_NU, u_direction);
    fill_SCALAR(14, CLAW_NU, tau_direction);
    fill_SCALAR(15, CLAW_NU, multiplier);
    fill_SCALAR(16, CLAW_NU, q_multiplier);
    fill_SCALAR(18, CLAW_NU, u_multiplier);
    fill_SCALAR(19, CLAW_NU, whole_u_dot_multiplier);
    fill_SCALAR(20, CLAW_NU, whole_tau_multiplier);
    ALONG;
    fill_SCALAR(7, 3, point);
    fill_SCALAR(8, 3, force);
    fill_SCALAR(9, 3, moment);
    kane_load_SCALAR loads[CLAW_NB];
    for (long place = 0; place < 3 * CLAW_NB; place++) {
        loads[place / 3].force[place % 3] = (REAL)entry(5, place);
        loads[place / 3].moment[place % 3] = (REAL)entry(6, place);
    }
    claw_sines_cosines_SCALAR sin_cos;
    claw_sin_cos_SCALAR(&p, q, &sin_cos);
    REAL direction[CLAW_NU], q_to[CLAW_NQ];
    const REAL *q_from = q, dt = (REAL)0.125;
    fill_SCALAR(10, CLAW_NU, direction);
    fill_SCALAR(11, CLAW_NQ, q_to);
CALLS}
"#;

const C_MAIN: &str = r"
int main(void)
{
    if (strcmp(CLAW_INPUT, claw_input()) != 0) {
        return 1;
    }
    all_f64();
    all_f32();
    return 0;
}
";

#[test]
fn every_function_gives_c_the_bits_of_rust() {
    compare("every_function", headers::CLAW, Some("int_mass"));
}

#[test]
#[expect(
    clippy::print_stdout,
    reason = "what was compared, for `tests/trees.sh`"
)]
fn every_function_of_random_trees_gives_c_the_bits_of_rust() {
    let (mut n_trees, mut n_numbers) = (0, 0);
    for system in trees::first(trees::count(2)) {
        n_numbers += compare("random", &system.toml(), None);
        n_trees += 1;
    }
    println!("{n_trees} trees from C: {n_numbers} numbers of each compiler have the bits of Rust");
}

/// Compiles and runs both programs for a model, one parameter of it changed where it is named. Returns how many numbers are
/// the same.
fn compare(name: &str, model: &str, changed: Option<&str>) -> usize {
    let folder = folder(name);
    let source = folder.join("src");
    fs::create_dir_all(&source).unwrap();
    let generated = headers::module("claw", model);
    let files = generated.files(&source.join("claw.rs"));
    for (path, text) in &files {
        fs::write(path, text).unwrap();
    }
    let manifest = files.iter().find(|(path, _)| path.ends_with("claw.json"));
    let manifest: Value = serde_json::from_str(manifest.unwrap().1).unwrap();
    let functions = manifest["functions"].as_array().unwrap().iter();
    let functions: Vec<Function<'_>> = functions.map(Function::read).collect();
    let runtime = manifest["c"]["runtime"].as_array().unwrap().iter();
    let runtime: Vec<Function<'_>> = runtime.map(Function::read).collect();
    let kane = env!("CARGO_MANIFEST_DIR").replace('\\', "/");
    fs::write(folder.join("Cargo.toml"), MANIFEST.replace("KANE", &kane)).unwrap();
    fs::write(source.join("lib.rs"), "pub mod claw;\npub mod claw_c;\n").unwrap();
    let scales = runtime.iter().any(|one| one.name == "scale_quaternions");
    let has_parameters = model.contains("runtime");
    let program = rust_program(&functions, changed);
    let program = program.replace("SCALED", if scales { RUST_SCALED } else { "" });
    let names: Vec<&str> = runtime.iter().map(|one| one.name).collect();
    let program = program.replace("STEPS", &steps::called_from_rust(&names));
    let program = program.replace("ALONG", if has_parameters { RUST_ALONG } else { "" });
    fs::write(source.join("main.rs"), program).unwrap();
    let called = || functions.iter().chain(&runtime);
    let program = c_program(called(), changed, has_parameters);
    fs::write(source.join("main.c"), program).unwrap();

    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["build", "--offline"]).current_dir(&folder);
    // Beside the folder, which is emptied: the runtime is compiled once.
    let target = folder.with_extension("target");
    run(cargo
        .env("CARGO_TARGET_DIR", &target)
        .env("CARGO_PROFILE_DEV_DEBUG", "0")
        .env("RUSTFLAGS", "--deny warnings"));
    let expected = run(&mut Command::new(target.join("debug/every")));
    let expected: Vec<_> = expected.lines().map(bits).collect();
    let outputs = called().map(|function| function.outputs.len());
    assert_eq!(expected.len(), 2 * outputs.sum::<usize>());
    for compiler in tools(C, "every function called from C by this compiler") {
        let program = folder.join(compiler);
        let mut command = Command::new(compiler);
        command.args(WARNINGS).args(["-std=c99", "-o"]);
        command.args([
            &program,
            &source.join("main.c"),
            &target.join("debug/libevery.a"),
        ]);
        run(command.args(["-lm", "-lpthread", "-ldl"]));
        let printed = run(&mut Command::new(program));
        let printed: Vec<_> = printed.lines().map(bits).collect();
        for (printed, expected) in printed.iter().zip(&expected) {
            assert_eq!(printed, expected, "{compiler}");
        }
        assert_eq!(printed.len(), expected.len());
    }
    expected.iter().map(|(_, numbers)| numbers.len()).sum()
}

/// A function as the manifest has it.
struct Function<'a> {
    name: &'a str,
    arguments: Vec<&'a str>,
    outputs: Vec<(&'a str, Vec<u64>)>,
}

impl<'a> Function<'a> {
    fn read(function: &'a Value) -> Self {
        let list = |value: &'a Value| value.as_array().unwrap().iter();
        let outputs = list(&function["outputs"]).map(|output| {
            let shape = list(&output["shape"]).map(|length| length.as_u64().unwrap());
            (output["name"].as_str().unwrap(), shape.collect())
        });
        let arguments = list(&function["arguments"]);
        let arguments = arguments.map(|argument| argument["name"].as_str().unwrap());
        Self {
            name: function["name"].as_str().unwrap(),
            arguments: arguments.collect(),
            outputs: outputs.collect(),
        }
    }
}

fn rust_program(functions: &[Function<'_>], changed: Option<&str>) -> String {
    let mut calls = String::new();
    for Function {
        name,
        arguments,
        outputs,
    } in functions
    {
        let mut passed: Vec<String> = arguments.iter().map(|name| format!("&{name}")).collect();
        let (mut declared, mut printed) = (String::new(), String::new());
        for (output, shape) in outputs {
            let zeros = shape.iter().rev().fold("zero".to_owned(), |zeros, length| {
                format!("[{zeros}; {length}]")
            });
            write!(declared, "let mut {output}_ = {zeros}; ").unwrap();
            write!(
                printed,
                "print!(\"{name}.{output}\"); {output}_.print(); println!(); "
            )
            .unwrap();
            passed.push(format!("&mut {output}_"));
        }
        let passed = passed.join(", ");
        writeln!(calls, "    {declared}claw::{name}({passed}); {printed}").unwrap();
    }
    let nominal = "Parameters::default()".to_owned();
    let changed = changed.map_or(nominal, |name| {
        format!("Parameters {{ {name}: R::from_f64(2.5), ..Parameters::default() }}")
    });
    RUST.replace("CALLS", &calls).replace("CHANGED", &changed)
}

fn c_program<'a>(
    functions: impl Iterator<Item = &'a Function<'a>>,
    changed: Option<&str>,
    has_parameters: bool,
) -> String {
    let mut calls = String::new();
    for Function {
        name,
        arguments,
        outputs,
    } in functions
    {
        let passed = arguments.iter().map(|name| match *name {
            "p" | "sin_cos" | "dt" => format!("&{name}"),
            array => array.to_owned(),
        });
        let mut passed: Vec<String> = passed.collect();
        let (mut declared, mut printed) = (String::new(), String::new());
        for (output, shape) in outputs {
            let size: u64 = shape.iter().product();
            // C has no array without entries.
            write!(declared, "REAL {output}_[{}]; ", size.max(1)).unwrap();
            write!(
                printed,
                "printf(\"{name}.{output}\"); print_SCALAR({size}, {output}_); printf(\"\\n\"); "
            )
            .unwrap();
            passed.push(format!("{output}_"));
        }
        let in_place = in_place(name, arguments, outputs, &passed);
        let passed = passed.join(", ");
        writeln!(
            calls,
            "    {{ {declared}claw_{name}_SCALAR({passed}); {printed}{in_place}}}"
        )
        .unwrap();
    }
    let changed = changed.map_or_else(String::new, |name| format!("parameters.{name} = 2.5;"));
    let all = C_ALL.replace("CALLS", &calls).replace("CHANGED", &changed);
    let all = all.replace("ALONG;", if has_parameters { C_ALONG } else { "" });
    let [double, single] = [("f64", "double"), ("f32", "float")]
        .map(|(scalar, real)| all.replace("SCALAR", scalar).replace("REAL", real));
    [C_BEGINNING, &double, &single, C_MAIN].concat()
}

/// The same call with what is read at the place of what is written, where a function allows that: the numbers stay.
fn in_place(
    name: &str,
    arguments: &[&str],
    outputs: &[(&str, Vec<u64>)],
    passed: &[String],
) -> String {
    let mut passed = passed.to_vec();
    let (mut copied, mut compared) = (String::new(), String::new());
    for (place, argument) in arguments.iter().enumerate() {
        let after = match argument.strip_suffix("_multiplier") {
            Some(of) => format!("{of}_gradient"),
            None => format!("{argument}_after"),
        };
        let Some(output) = outputs.iter().position(|(output, _)| *output == after) else {
            continue;
        };
        let own = format!("{argument}_own");
        write!(
            copied,
            "REAL {own}[sizeof {after}_ / sizeof(REAL)]; memcpy({own}, {argument}, sizeof {own}); "
        )
        .unwrap();
        write!(
            compared,
            "if (memcmp({own}, {after}_, sizeof {own})) abort(); "
        )
        .unwrap();
        passed[place].clone_from(&own);
        passed[arguments.len() + output] = own;
    }
    if copied.is_empty() {
        return String::new();
    }
    format!(
        "{copied}claw_{name}_SCALAR({}); {compared}",
        passed.join(", ")
    )
}
