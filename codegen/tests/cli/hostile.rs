//! Files that are none, never end, or are very large: a clear error, soon.

use std::{fs::File, process::Command};

use super::project::{Project, model, system};
use kane_test_support::shown::steers;

/// The commands that read this file, as a model or a module.
fn readers(path: &str) -> [Vec<&str>; 7] {
    [
        vec!["generate", path, "--output", "-"],
        vec!["check", path, "--output", "x.rs"],
        vec!["info", path],
        vec!["convert", path],
        vec!["eval", path, "--function", "bias", "--state", "state.json"],
        vec!["diff", path, "models/arm.toml"],
        verify(path),
    ]
}

/// With a stand-in for the crate `kane`: what is refused needs none.
fn verify(module: &str) -> Vec<&str> {
    vec!["verify", module, "--object", "--kane", "kane"]
}

/// That this is refused, with these words for why.
fn assert_refused(project: &Project, arguments: &[&str], why: &str) {
    let ran = project.kane(arguments);
    let (code, err) = (ran.code, &ran.err);
    assert!(code == 2 && err.contains(why), "{arguments:?}: {ran:?}");
    let unshown = err.chars().find(|c| steers(*c));
    assert_eq!(unshown, None, "{arguments:?}");
}

fn arm() -> Project {
    let project = Project::arm();
    project.write("state.json", r#"{"q": [0, 0, 0], "u": [0, 0, 0]}"#);
    project.write("kane/Cargo.toml", "[package]\nname = \"kane\"\n");
    project.write("kane/src/lib.rs", "");
    project
}

fn pipe(project: &Project, path: &str) {
    let made = Command::new("mkfifo").arg(project.path(path)).status();
    assert!(made.unwrap().success());
}

#[test]
fn what_is_no_file_is_refused() {
    let project = arm();
    pipe(&project, "pipe.toml");
    for (path, why) in [
        ("models", "is a directory"),
        ("pipe.toml", "it is no regular file"),
        ("/dev/zero", "it is no regular file"),
    ] {
        for arguments in readers(path) {
            assert_refused(&project, &arguments, why);
        }
        assert_refused(&project, &["check", "--config", path], why);
        let evaluated = [
            "eval",
            "models/arm.toml",
            "--function",
            "bias",
            "--state",
            path,
        ];
        assert_refused(&project, &evaluated, why);
    }
    std::fs::create_dir(project.path("folder.rs")).unwrap();
    pipe(&project, "pipe.rs");
    for (path, why) in [
        ("folder.rs", "is a directory"),
        ("pipe.rs", "it is no regular file"),
        ("/dev/zero", "expected a file that ends in `.rs`"),
    ] {
        let written = ["generate", "models/arm.toml", "--force", "--output", path];
        assert_refused(&project, &written, why);
    }
}

#[test]
fn a_model_from_standard_input_is_refused_with_what_reads_it() {
    let project = arm();
    let readers = readers("-");
    // A module ends in `.rs`.
    for arguments in readers.iter().filter(|arguments| arguments[0] != "verify") {
        assert_refused(
            &project,
            arguments,
            "cannot access `-`: there is no such file; only `kane eval --state -` reads standard input",
        );
    }
}

#[test]
fn what_only_looks_like_the_rest_of_a_killed_run_stays() {
    let project = Project::generated();
    let names = ["pipe", "folder"].map(|name| format!("generated/.kane-generate-{name}.tmp"));
    pipe(&project, &names[0]);
    std::fs::create_dir(project.path(&names[1])).unwrap();
    assert_eq!(project.kane(&["generate"]).code, 0);
    assert!(names.iter().all(|name| project.path(name).exists()));
}

#[test]
fn what_cannot_be_written_is_refused_and_nothing_else_is_written() {
    let project = arm();
    let before = project.files();
    let both = system("models/arm.toml", "out/a.rs") + &system("models/arm.toml", "kane.toml/b.rs");
    project.write("both.toml", &both);
    assert_refused(
        &project,
        &["generate", "--config", "both.toml"],
        "cannot access `kane.toml/b.rs`",
    );
    std::fs::remove_file(project.path("both.toml")).unwrap();
    assert_eq!(project.files(), before);
    #[cfg(target_os = "linux")]
    assert_refused(
        &project,
        &["generate", "models/arm.toml", "--output", "/proc/a.rs"],
        "cannot access `/proc/a.rs`",
    );
}

#[test]
fn file_of_a_hundred_megabytes_is_not_read() {
    let project = arm();
    for name in ["large.toml", "large.urdf", "large.xml"] {
        let file = File::create(project.path(name)).unwrap();
        file.set_len(100 << 20).unwrap();
        // A module may be longer than a model.
        for arguments in &readers(name)[..6] {
            assert_refused(&project, arguments, "it has more than 16777216 bytes");
        }
    }
    for arguments in [
        vec!["check", "--config", "large.toml"],
        vec![
            "eval",
            "models/arm.toml",
            "--function",
            "bias",
            "--state",
            "large.toml",
        ],
    ] {
        assert_refused(&project, &arguments, "it has more than 16777216 bytes");
    }
    project.write("main.xml", "<mujoco><include file='large.xml'/></mujoco>");
    assert_refused(
        &project,
        &["info", "main.xml"],
        "it has more than 33554432 bytes",
    );
}

#[test]
fn module_of_more_than_256_megabytes_is_not_read() {
    let project = arm();
    let file = File::create(project.path("large.rs")).unwrap();
    file.set_len((256 << 20) + 1).unwrap();
    let why = "it has more than 268435456 bytes";
    assert_refused(&project, &verify("large.rs"), why);
}

#[test]
fn of_very_many_faults_of_a_state_the_first_are_told() {
    let project = arm();
    let runtime = model("arm", "{ runtime = 2.0 }");
    project.write("models/arm.toml", &runtime);
    let unknown: Vec<String> = (0..200_000).map(|n| format!("\"p{n}\": 1")).collect();
    let unknown = unknown.join(", ");
    let evaluated = readers("models/arm.toml")[4].clone();
    for state in [
        format!("{{{unknown}}}"),
        format!("{{\"parameters\": {{{unknown}}}}}"),
    ] {
        project.write("state.json", &state);
        assert_refused(&project, &evaluated, " 900 more faults are not shown");
    }
}

#[test]
fn state_that_never_ends_is_not_read() {
    let project = arm();
    let mut command = project.command();
    command.args([
        "eval",
        "models/arm.toml",
        "--function",
        "bias",
        "--state",
        "-",
    ]);
    let ran = command
        .stdin(File::open("/dev/zero").unwrap())
        .output()
        .unwrap();
    assert_eq!(ran.status.code(), Some(2));
    let err = String::from_utf8(ran.stderr).unwrap();
    assert!(err.contains("it has more than 16777216 bytes"), "{err}");
}

#[test]
fn text_that_is_not_in_utf8_is_refused() {
    let project = arm();
    let utf16: Vec<u8> = model("arm", "2.0")
        .encode_utf16()
        .flat_map(u16::to_le_bytes)
        .collect();
    for (bytes, place) in [
        ([&[0xff, 0xfe], &utf16[..]].concat(), 0),
        ([b"name = \"", &[0xc3, 0x28][..], b"\""].concat(), 8),
    ] {
        std::fs::write(project.path("other.toml"), bytes).unwrap();
        for arguments in readers("other.toml") {
            assert_refused(
                &project,
                &arguments,
                &format!("not text in UTF-8, from byte {place} on"),
            );
        }
    }
}

#[test]
fn what_would_steer_a_terminal_is_not_printed() {
    let project = arm();
    for path in ["\u{1b}[2J.toml", "\u{9b}2J.toml", "a\u{202e}b.toml"] {
        for arguments in readers(path) {
            assert_refused(&project, &arguments, "error: ");
        }
        project.write(path, "name = \u{1b}[2J \u{9b}2J\r");
        for arguments in readers(path) {
            assert_refused(&project, &arguments, "error: ");
        }
    }
}

#[test]
fn module_that_is_nested_too_deep_is_refused() {
    let project = arm();
    assert_eq!(project.kane(&["generate"]).code, 0);
    let module = project.read("generated/arm.rs");
    let deep = format!("{module}const A: f64 = {}1.0;\n", "-".repeat(200_000));
    project.write("deep.rs", &deep);
    assert_refused(
        &project,
        &["diff", "generated/arm.rs", "deep.rs"],
        "nested too deep",
    );
    assert_refused(&project, &verify("deep.rs"), "nested too deep");
    project.write("generated/arm.rs", &deep);
    assert_eq!(project.kane(&["check"]).code, 1);
}

#[test]
fn thousands_of_systems_are_listed() {
    let project = arm();
    let system = |number: usize| system("models/none.toml", &format!("out/a{number}.rs"));
    project.write("kane.toml", &(0..3000).map(system).collect::<String>());
    assert_refused(&project, &["check"], "cannot access `models/none.toml`");
    let twice = project.read("kane.toml") + &system(7);
    project.write("kane.toml", &twice);
    assert_refused(&project, &["check"], "out/a7.rs");
}

/// A chain of bodies, each turning on the one before.
fn chain(n_bodies: usize) -> String {
    let lower: Vec<usize> = (0..n_bodies).collect();
    let body = |body: usize| {
        format!(
            "[[body]]\nname = \"b{body}\"\nmass = 1.5\nmass_center = [0.0, 0.02, -0.4]\n\
            inertia = {{ xx = 0.1, yy = 0.1, zz = 0.02, xy = 0.0, xz = 0.01, yz = 0.0 }}\n\
            attachment = [0.0, 0.0, -1.0]\njoint = [\"theta2\"]\n"
        )
    };
    let bodies: String = (0..n_bodies).map(body).collect();
    format!("name = \"chain\"\nlower_bodies = {lower:?}\n{bodies}")
}

#[test]
fn ten_thousand_bodies_are_read_and_told_to_be_too_many_to_generate() {
    let project = arm();
    project.write("long.toml", &chain(10_000));
    let too_many = "the system has 10000 speeds; expected at most 5000";
    for arguments in readers("long.toml").into_iter().take(2) {
        assert_refused(&project, &arguments, too_many);
    }
    let ran = project.kane(&["info", "long.toml"]);
    assert_eq!(ran.code, 0);
    assert!(
        ran.out
            .contains("\nA tree of more than 250 bodies is not shown\n")
    );
    let ran = project.kane(&["info", "long.toml", "--functions", "all"]);
    let names = "only what --functions names is counted\n  relative_rotation\n";
    assert!(ran.code == 0 && ran.out.contains(names), "{}", ran.err);
    let ran = project.kane(&["convert", "long.toml", "--output", "converted.toml"]);
    assert_eq!(ran.code, 0);
    project.write("long.toml", &chain(10_001));
    assert_refused(
        &project,
        &["info", "long.toml"],
        "entries of `lower_bodies` is 10001; expected at most 10000",
    );
    project.write("long.toml", &chain(600));
    let written = ["generate", "long.toml", "--output", "-"];
    assert_refused(&project, &written, "`mass_matrix` most of all");
    let ran = project.kane(&[&written[..], &["--functions", "bias"]].concat());
    assert!(ran.code == 0 && ran.out.contains("pub fn bias<"));
}
