//! What the compiler makes of the hot paths: no branch, no call, no way to panic.
//!
//! Compiles this crate without features, and a few functions on top of it, straight with rustc.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test stops where it cannot go on"
)]

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{fs, str};

const PROBE: &str = r#"
#![crate_type = "lib"]
#![no_std]
use kane::Real;

#[unsafe(no_mangle)]
pub fn scalar_f64(x: f64) -> (f64, f64) { <f64 as Real>::sin_cos(x) }
#[unsafe(no_mangle)]
pub fn scalar_f32(x: f32) -> (f32, f32) { <f32 as Real>::sin_cos(x) }
#[unsafe(no_mangle)]
pub fn array_f64(x: &[f64; 7], out: &mut ([f64; 7], [f64; 7])) { *out = f64::sin_cos_array(*x); }
#[unsafe(no_mangle)]
pub fn array_f32(x: &[f32; 7], out: &mut ([f32; 7], [f32; 7])) { *out = f32::sin_cos_array(*x); }

#[unsafe(no_mangle)]
pub fn mul_add_f64(a: f64, b: f64, c: f64) -> f64 { Real::mul_add(a, b, c) }
#[unsafe(no_mangle)]
pub fn mul_add_f32(a: f32, b: f32, c: f32) -> f32 { Real::mul_add(a, b, c) }
#[unsafe(no_mangle)]
pub fn negated_f64(a: f64, b: f64, c: f64) -> f64 { Real::mul_add(-a, b, -c) }

#[path = "one_coordinate.rs"]
mod one_coordinate;
#[path = "oscillator.rs"]
mod oscillator;
use oscillator::Oscillator;

#[unsafe(no_mangle)]
pub fn step(system: &Oscillator<f64>, tau: &[f64; 1], q: &mut [f64; 1], u: &mut [f64; 1]) {
    kane::integrate::rk4_step(system, tau, 1e-3, q, u);
}
"#;

fn rustc(arguments: &[&str]) {
    let output = Command::new("rustc").args(arguments).output().unwrap();
    let errors = str::from_utf8(&output.stderr).unwrap();
    assert!(output.status.success(), "rustc {arguments:?}\n{errors}");
}

/// A folder of a build's own, and in it this crate without features; `arguments` are rustc's.
fn library(arguments: &[&str]) -> (PathBuf, String) {
    let name = format!("assembly{}", arguments.concat());
    let name = name.replace(|c: char| !c.is_ascii_alphanumeric(), "_");
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    fs::create_dir_all(&folder).unwrap();
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/lib.rs");
    let library = folder.join("libkane.rlib").to_str().unwrap().to_owned();
    let kane = [
        "--crate-name=kane",
        "--crate-type=lib",
        "-o",
        &library,
        source.to_str().unwrap(),
    ];
    rustc(&[arguments, &kane].concat());
    (folder, format!("kane={library}"))
}

/// The probe's instructions, by function; `options` are rustc's, for the crate and the probe.
fn instructions(opt_level: &str, options: &[&str]) -> BTreeMap<String, Vec<String>> {
    let level = format!("opt-level={opt_level}");
    let common = ["--edition=2024", "-C", &level, "-C", "codegen-units=1"];
    let common = [&common[..], options].concat();
    let (folder, external) = library(&common);
    fs::write(folder.join("probe.rs"), PROBE).unwrap();
    for name in ["one_coordinate.rs", "oscillator.rs"] {
        let common = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/runtime/common");
        fs::copy(common.join(name), folder.join(name)).unwrap();
    }
    let path = |name: &str| folder.join(name).to_str().unwrap().to_owned();
    let (source, assembly) = (path("probe.rs"), path("probe.s"));
    let probe = [
        "--emit=asm",
        "--extern",
        &external,
        "-o",
        &assembly,
        &source,
    ];
    rustc(&[&common[..], &probe].concat());

    let text = fs::read_to_string(&assembly).unwrap();
    let mut functions: BTreeMap<String, Vec<String>> = BTreeMap::new();
    let mut current = None;
    for line in text.lines() {
        if let Some(label) = line
            .strip_suffix(':')
            .filter(|label| !label.starts_with('.'))
        {
            current = Some(label.to_owned());
        } else if line.contains(".cfi_endproc") {
            current = None;
        } else if let (Some(function), Some(instruction)) = (&current, line.strip_prefix('\t'))
            && !instruction.starts_with(['.', '#'])
        {
            functions
                .entry(function.clone())
                .or_default()
                .push(instruction.to_owned());
        }
    }
    functions
}

fn require_straight_code(opt_level: &str) {
    let functions = instructions(opt_level, &[]);
    for name in ["scalar_f64", "scalar_f32", "array_f64", "array_f32", "step"] {
        let instructions = &functions[name];
        assert!(
            instructions.len() > 30,
            "`{name}` has only {} instructions",
            instructions.len()
        );
        for instruction in instructions {
            assert!(
                !instruction.contains("panic"),
                "`{name}` may panic: {instruction}"
            );
            // The sines of eight angles are a function, whose own instructions are read where machine code is verified.
            let is_of_eight = name.starts_with("array") && instruction.contains("eight_in_reg");
            let calls = instruction.starts_with("call") && !is_of_eight;
            let branches = instruction.starts_with('j') || calls;
            // The step calls a function of the system, as it would a generated one, and may loop over its stages.
            assert!(
                name == "step" || !branches,
                "`{name}` branches or calls: {instruction}"
            );
        }
        let fused = instructions
            .iter()
            .find(|instruction| instruction.contains("fmadd"));
        assert_eq!(fused, None, "`{name}`");
    }
}

#[test]
fn sines_are_straight_code_at_opt_level_2() {
    require_straight_code("2");
}

#[test]
fn sines_are_straight_code_at_opt_level_3() {
    require_straight_code("3");
}

const AVX2: [&str; 2] = ["-C", "target-feature=+avx2"];

#[test]
fn with_avx_seven_sines_are_vectors_of_eight() {
    let functions = instructions("3", &AVX2);
    let (_, eight) = functions
        .iter()
        .find(|(name, _)| name.contains("eight") && name.contains("lanes"))
        .expect("a function of its own");
    for (function, calls) in [(&functions["array_f64"], 1), (eight, 0)] {
        let found = function.iter().filter(|i| i.starts_with("call")).count();
        assert_eq!(found, calls, "{function:?}");
        let one = function.iter().find(|i| {
            let name = i.split('\t').next().unwrap_or(i);
            name.starts_with("vmul") && (name.ends_with("sd") || name.ends_with("ss"))
        });
        assert_eq!(one, None, "one lane alone");
    }
}

/// Prints what differs.
const LANES: &str = r#"
use kane::Real;

fn lanes_are_scalars<const N: usize>() {
    let angles: [f64; N] = core::array::from_fn(|i| (7.3 * (i + N) as f64 - 40.0) * 1.7);
    let (s, c) = f64::sin_cos_array(angles);
    let alone = angles.map(<f64 as Real>::sin_cos);
    let (t, d) = f32::sin_cos_array(angles.map(|x| x as f32));
    let alone_f32 = angles.map(|x| <f32 as Real>::sin_cos(x as f32));
    for i in 0..N {
        if (s[i].to_bits(), c[i].to_bits()) != (alone[i].0.to_bits(), alone[i].1.to_bits()) { println!("f64: {i} of {N}"); }
        if (t[i].to_bits(), d[i].to_bits()) != (alone_f32[i].0.to_bits(), alone_f32[i].1.to_bits()) { println!("f32: {i} of {N}"); }
    }
}

macro_rules! all { ($($n:literal)*) => { $(lanes_are_scalars::<$n>();)* } }

fn main() { all!(0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 19 23 32); }
"#;

/// On a machine without AVX2 this shows nothing.
#[test]
fn with_avx_arrays_have_the_bits_of_their_lanes() {
    if !is_x86_feature_detected!("avx2") {
        return;
    }
    let common = [&["--edition=2024", "-C", "opt-level=2"], &AVX2[..]].concat();
    let (folder, external) = library(&common);
    let path = |name: &str| folder.join(name).to_str().unwrap().to_owned();
    let (source, program) = (path("main.rs"), path("main"));
    fs::write(&source, LANES).unwrap();
    let main = ["--extern", &external, "-o", &program, &source];
    rustc(&[&common[..], &main].concat());
    let output = Command::new(program).output().unwrap();
    assert!(output.status.success());
    assert_eq!(str::from_utf8(&output.stdout).unwrap(), "");
}

const STD: [&str; 2] = ["--cfg", "feature=\"std\""];
const FMA: [&str; 2] = ["-C", "target-feature=+fma"];

#[test]
fn mul_add_is_one_instruction_where_the_hardware_has_it() {
    let functions = instructions("3", &[STD, FMA].concat());
    for (name, instruction) in [
        ("mul_add_f64", "vfmadd213sd"),
        ("mul_add_f32", "vfmadd213ss"),
        ("negated_f64", "vfnmsub213sd"),
    ] {
        let found = &functions[name];
        assert!(found[0].starts_with(instruction), "`{name}`: {found:?}");
        assert!(found.len() <= 2, "`{name}` does more: {found:?}");
    }
    // Nobody fuses where nobody asks for it: sines keep their bits.
    for (name, instructions) in functions
        .iter()
        .filter(|(name, _)| !name.contains("mul_add") && *name != "negated_f64")
    {
        let fused = instructions
            .iter()
            .find(|instruction| instruction.starts_with("vfm") || instruction.starts_with("vfn"));
        assert_eq!(fused, None, "`{name}`");
    }
}

#[test]
fn mul_add_is_never_a_call() {
    for options in [&[][..], &STD, &FMA] {
        let functions = instructions("3", options);
        for name in ["mul_add_f64", "mul_add_f32", "negated_f64"] {
            for instruction in &functions[name] {
                let wrong = ["call", "jmp", "vf"];
                assert!(
                    !wrong.iter().any(|wrong| instruction.starts_with(wrong)),
                    "`{name}` with {options:?}: {instruction}"
                );
            }
        }
    }
}
