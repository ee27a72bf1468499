//! Pages that are run: files are written and commands executed in the order of the page, in a fresh folder beside a link to this
//! repository, `kane`. Nothing is downloaded.

use std::{env, fmt::Write as _, fs, os::unix::fs::symlink, path::Path, process::Command};

use kane_test_support::tool::tool;

use crate::page::{self, Page, REPLAYED, Use, repository};

/// What stands between what two blocks print.
const MARK: &str = "---- end of a block ----";

/// A program for bash, and the outputs that the page shows, each with the number of its run, from 1.
fn program(page: &Page) -> (String, Vec<(usize, String)>) {
    let mut script = "set -eu\n".to_owned();
    let (mut runs, mut outputs) = (0, Vec::new());
    // Of what was not run nothing is printed.
    let mut is_run = true;
    for block in &page.blocks {
        let text = &block.text;
        match &block.used {
            Some(Use::File(path)) => {
                let folder = Path::new(path).parent().unwrap().display();
                let folder = format!("./{folder}");
                write!(
                    script,
                    "mkdir -p {folder}\ncat >{path} <<'END_OF_FILE'\n{text}END_OF_FILE\n"
                )
                .unwrap();
            }
            Some(used @ (Use::Run | Use::RunWith(_))) => {
                is_run = match used {
                    Use::RunWith(name) => tool(name, &format!("a part of {}", page.path)).is_some(),
                    _ => true,
                };
                if is_run {
                    runs += 1;
                    write!(script, "{text}\necho '{MARK}'\n").unwrap();
                }
            }
            Some(Use::Output) if is_run => outputs.push((runs, text.clone())),
            Some(Use::Output | Use::NotRun) | None => {}
        }
    }
    (script, outputs)
}

/// The first line of `expected` that is not there, in its turn.
fn missing<'a>(printed: &str, expected: &'a str) -> Option<&'a str> {
    let mut lines = printed.lines().map(str::trim);
    expected
        .lines()
        .map(str::trim)
        .filter(|line| !line.is_empty() && *line != "...")
        .find(|expected| !lines.any(|line| line == *expected))
}

fn replay(path: &str) {
    assert!(REPLAYED.contains(&path));
    let (script, outputs) = program(&page::read(path));
    let folder = tempfile::tempdir().unwrap();
    let root = fs::canonicalize(repository("")).unwrap();
    symlink(&root, folder.path().join("kane")).unwrap();
    let command = Path::new(env!("CARGO_BIN_EXE_kane")).parent().unwrap();
    let paths = env::var_os("PATH").unwrap();
    let paths = env::join_paths(
        [command.to_owned()]
            .into_iter()
            .chain(env::split_paths(&paths)),
    );
    // All tutorials compile the runtime once.
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).join("book");
    let ran = Command::new("bash")
        .args(["-c", &format!("exec 2>&1\n{script}")])
        .current_dir(folder.path())
        .env("PATH", paths.unwrap())
        .env("CARGO_TARGET_DIR", target)
        .env("CARGO_NET_OFFLINE", "true")
        .env_remove("RUSTFLAGS")
        .output()
        .unwrap();
    let printed = String::from_utf8_lossy(&ran.stdout);
    assert!(ran.status.success(), "{path}: {printed}");
    let printed: Vec<&str> = printed.split(MARK).collect();
    for (run, expected) in outputs {
        let printed = printed[run - 1];
        let missing = missing(printed, &expected);
        assert_eq!(missing, None, "{path} shows another output: {printed}");
    }
}

#[test]
fn the_readme_does_what_it_says() {
    replay("README.md");
}

#[test]
fn the_start_does_what_it_says() {
    replay("docs/start.md");
}

#[test]
fn the_arm_does_what_it_says() {
    replay("docs/tutorials/arm.md");
}

#[test]
fn the_calls_from_c_do_what_they_say() {
    let tools = ["make", "cc"].map(|name| tool(name, "the tutorial of C"));
    if tools.iter().all(Option::is_some) {
        replay("docs/tutorials/c.md");
    }
}

#[test]
fn the_check_in_continuous_integration_does_what_it_says() {
    replay("docs/tutorials/continuous_integration.md");
}

#[test]
fn the_floating_robot_does_what_it_says() {
    replay("docs/tutorials/floating.md");
}

#[test]
fn the_microcontroller_does_what_it_says() {
    replay("docs/tutorials/microcontroller.md");
}

#[test]
fn the_spacecraft_does_what_it_says() {
    replay("docs/tutorials/spacecraft.md");
}

#[test]
fn another_output_is_found() {
    assert_eq!(missing("one\ntwo\nthree\n", "one\n...\nthree\n"), None);
    assert_eq!(missing("one\ntwo\n", "two\none\n"), Some("one"));
    assert_eq!(missing("one\n", "two\n"), Some("two"));
}
