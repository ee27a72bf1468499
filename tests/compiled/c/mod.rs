//! Generated functions called from C: the headers compile, in C and C++, and the bits are those of Rust.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test stops where it cannot go on"
)]

mod every_function;
mod example;
mod headers;
mod panics;
mod steps;

use std::{
    fs,
    path::{Path, PathBuf},
    process::Command,
};

/// The compiler by which Rust links is the one that is everywhere.
const C: [&str; 2] = ["cc", "clang"];
const CPP: [&str; 2] = ["g++", "clang++"];
const WARNINGS: [&str; 4] = ["-Wall", "-Wextra", "-Wpedantic", "-Werror"];

/// An empty folder for what a test writes.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("c").join(name);
    drop(fs::remove_dir_all(&folder));
    fs::create_dir_all(&folder).unwrap();
    folder
}

/// What a tool that has to be there prints.
fn run(command: &mut Command) -> String {
    let output = command.output().unwrap_or_else(|error| {
        panic!(
            "`{}` cannot be run: {error}",
            command.get_program().display()
        )
    });
    assert!(
        output.status.success(),
        "{command:?}\n{}{}",
        String::from_utf8_lossy(&output.stdout),
        String::from_utf8_lossy(&output.stderr)
    );
    String::from_utf8(output.stdout).unwrap()
}

/// A line's name and the bits of its numbers.
fn bits(line: &str) -> (&str, Vec<u64>) {
    let mut fields = line.split(' ');
    let (name, numbers) = (fields.next().unwrap(), fields);
    let numbers = numbers.map(|number| number.parse::<f64>().unwrap().to_bits());
    (name, numbers.collect())
}
