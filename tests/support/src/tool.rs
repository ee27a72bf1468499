//! Tools that a machine with Rust and a C compiler alone lacks.
//!
//! What needs one is skipped where it is not, and a line says so. Where the variable `KANE_NO_SKIP` is set, as in CI, it fails.

use std::{
    env,
    io::{self, Write as _},
    process::{Command, Stdio},
};

/// The tool's name where it can be run; where it cannot, a line on standard error says what is skipped.
///
/// # Panics
/// Where it cannot be run and nothing may be skipped.
pub fn tool<'a>(name: &'a str, needed_for: &str) -> Option<&'a str> {
    let version = Command::new(name)
        .arg("--version")
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status();
    if version.is_ok_and(|status| status.success()) {
        return Some(name);
    }
    let skips = env::var_os("KANE_NO_SKIP").is_none_or(|value| value.is_empty());
    assert!(
        skips,
        "`{name}` cannot be run, which is needed for {needed_for}, and nothing may be skipped"
    );
    // The test harness keeps what tests print by macros to itself.
    let mut stderr = io::stderr().lock();
    writeln!(stderr, "skipped: {needed_for}; `{name}` cannot be run").ok()?;
    None
}

/// Of the tools those that can be run; lines on standard error say what is skipped for want of the others.
///
/// # Panics
/// As [`tool`].
pub fn tools<'a, const N: usize>(
    names: [&'a str; N],
    needed_for: &str,
) -> impl Iterator<Item = &'a str> {
    names
        .into_iter()
        .filter_map(move |name| tool(name, needed_for))
}
