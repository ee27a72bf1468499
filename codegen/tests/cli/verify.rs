//! `kane verify`.

#![cfg(all(target_arch = "x86_64", target_os = "linux"))]

use serde_json::Value;

use crate::project::{Project, Ran, repository};

/// The command on files of a project, with the repository's crate `kane`.
fn verify(project: &Project, arguments: &[&str]) -> Ran {
    let kane = repository("");
    let common = ["verify", "--object", "--kane", kane.to_str().unwrap()];
    project.kane(&[&common, arguments].concat())
}

const MODULE: &str = "generated/arm.rs";

#[test]
fn promises_that_hold_are_a_table_of_functions() {
    let ran = verify(&Project::generated(), &[MODULE]);
    assert_eq!((ran.code, ran.err.as_str()), (0, ""), "{}", ran.out);
    let lines: Vec<&str> = ran.out.lines().collect();
    assert_eq!(lines[0], MODULE);
    let columns = |line: &str| -> Vec<String> {
        let parts = line.split("  ").map(str::trim);
        let parts = parts.filter(|part| !part.is_empty());
        parts.map(str::to_owned).collect()
    };
    let head = ["function", "text bytes", "stack bytes", "instructions"];
    assert_eq!(columns(lines[2]), head);
    let functions: Vec<Vec<String>> = lines[3..].iter().map(|line| columns(line)).collect();
    let end = functions.iter().position(Vec::is_empty).unwrap();
    let names: Vec<&str> = functions[..end].iter().map(|row| row[0].as_str()).collect();
    assert_eq!(
        names[..4],
        ["Prepared::new", "mass_matrix", "q_dot", "bias"]
    );
    for row in &functions[..end] {
        for number in &row[1..] {
            assert!(number.parse::<u32>().is_ok(), "{row:?}");
        }
    }
    assert_eq!(functions[end + 1], ["every promise holds"]);
}

#[test]
fn files_beside_a_module_are_left_out() {
    let project = Project::arm();
    let asked = ["generate", "models/arm.toml", "--with-tests", "--abi", "c"];
    assert_eq!(project.kane(&asked).code, 0);
    let files = [MODULE, "generated/arm_c.rs", "generated/arm_tests.rs"];
    let ran = verify(&project, &files);
    assert_eq!(ran.code, 0, "{}", ran.err);
    assert_eq!(
        ran.err,
        "note: 2 of the files stand beside modules; they are not checked\n"
    );
    assert_eq!(ran.out, verify(&project, &[MODULE]).out);
    let ran = verify(&project, &files[2..]);
    let told = "error: `generated/arm_tests.rs` stands beside a module; expected the module\n";
    assert_eq!((ran.code, ran.err.as_str()), (2, told));
    // A module may be called so.
    let asked = [
        "generate",
        "models/arm.toml",
        "--output",
        "generated/arm_c.rs",
    ];
    project.write("generated/arm_c.rs", "");
    std::fs::remove_file(project.path("generated/arm_c.rs")).unwrap();
    assert_eq!(project.kane(&asked).code, 0);
    let ran = verify(&project, &files[..2]);
    assert_eq!((ran.code, ran.err.as_str()), (0, ""));
    assert!(ran.out.contains("generated/arm_c.rs"), "{}", ran.out);
}

#[test]
fn other_sources_are_left_out_where_one_is_a_module() {
    let project = Project::arm();
    assert_eq!(project.kane(&["generate", "models/arm.toml"]).code, 0);
    project.write("generated/mod.rs", "pub mod arm;\n");
    let ran = verify(&project, &["generated/mod.rs", MODULE]);
    assert_eq!(ran.code, 0, "{}", ran.err);
    assert_eq!(
        ran.err,
        "note: not checked, for `kane` did not write it: `generated/mod.rs`\n"
    );
    assert_eq!(ran.out, verify(&project, &[MODULE]).out);
    // One that was generated must have functions.
    let text = std::fs::read_to_string(project.path(MODULE)).unwrap();
    project.write("generated/mod.rs", &text.replace("#[inline(never)]", ""));
    let ran = verify(&project, &["generated/mod.rs", MODULE]);
    assert_refused(&ran, &["`generated/mod.rs` has no `pub fn`"]);
}

#[test]
fn a_broken_promise_names_function_and_instruction() {
    let project = Project::generated();
    let fault =
        "if core::ptr::from_ref(q).addr() & 64 == 0 { return; }\n    kane::store(&mut m[0][0],";
    project.replace(MODULE, "kane::store(&mut m[0][0],", fault);
    let ran = verify(&project, &[MODULE]);
    assert_eq!((ran.code, ran.err.as_str()), (1, ""));
    let broken: Vec<&str> = ran
        .out
        .lines()
        .filter(|line| line.contains(" at 0x"))
        .collect();
    assert_eq!(broken.len(), 1, "{}", ran.out);
    assert!(broken[0].starts_with("mass_matrix at 0x"), "{}", broken[0]);
    assert!(broken[0].contains(", `j"), "{}", broken[0]);
    assert!(broken[0].ends_with("`: jumps"), "{}", broken[0]);
    assert!(!ran.out.contains("every promise holds"));
}

#[test]
fn json_says_the_same_for_programs() {
    let project = Project::generated();
    let ran = verify(&project, &[MODULE, "--format", "json"]);
    assert_eq!((ran.code, ran.err.as_str()), (0, ""));
    let value: Value = serde_json::from_str(&ran.out).unwrap();
    let report = &value[0];
    assert_eq!(
        (&report["module"], &report["holds"]),
        (&MODULE.into(), &true.into())
    );
    let function = &report["functions"][1];
    assert_eq!(function["name"], "mass_matrix");
    for key in ["text_bytes", "instructions"] {
        assert!(function[key].as_u64().unwrap() > 0, "{function}");
    }
    assert!(function["stack_bytes"].is_u64());
    assert_eq!(function["breaches"], serde_json::json!([]));

    project.replace(
        MODULE,
        "kane::store(&mut m[0][0],",
        "if core::ptr::from_ref(q).addr() & 64 == 0 { return; }\n    kane::store(&mut m[0][0],",
    );
    let ran = verify(&project, &[MODULE, "--format", "json"]);
    assert_eq!(ran.code, 1);
    let value: Value = serde_json::from_str(&ran.out).unwrap();
    assert_eq!(value[0]["holds"], false);
    assert_eq!(value[0]["functions"][1]["breaches"][0]["what"], "jumps");
}

#[test]
fn one_broken_module_among_several_is_enough() {
    let project = Project::generated();
    project.write("good.rs", &project.read(MODULE));
    let fault = "kane::store(&mut m[core::ptr::from_ref(q).addr() >> 3 & 7][0],";
    project.replace(MODULE, "kane::store(&mut m[0][0],", fault);
    let ran = verify(
        &project,
        &["good.rs", MODULE, "--scalar", "f32", "--opt-level", "2"],
    );
    assert_eq!(ran.code, 1);
    let panic = "can panic, in `core::panicking::panic_bounds_check`";
    assert!(ran.out.contains(panic), "{}", ran.out);
    assert_eq!(ran.out.matches("every promise holds").count(), 1);
}

fn assert_refused(ran: &Ran, expected: &[&str]) {
    assert_eq!((ran.code, ran.out.as_str()), (2, ""), "{}", ran.err);
    for expected in expected {
        assert!(ran.err.contains(expected), "{expected}: {}", ran.err);
    }
}

#[test]
fn a_module_that_does_not_compile_is_refused_with_what_rustc_says() {
    let project = Project::generated();
    project.replace(
        MODULE,
        "kane::store(&mut m[0][0],",
        "m[0][0] = absent;\n    kane::store(&mut m[0][0],",
    );
    let expected = [
        "rustc does not compile `generated/arm.rs`",
        "error[E0425]",
        "`absent`",
    ];
    assert_refused(&verify(&project, &[MODULE]), &expected);
}

#[test]
fn what_is_no_module_is_refused() {
    let project = Project::arm();
    project.write("notes.rs", "no Rust");
    project.write("mine.rs", "pub fn mine() {}");
    let ran = verify(&project, &["notes.rs", "mine.rs", "absent.rs"]);
    let expected = [
        "`notes.rs` is not Rust that can be read",
        "`mine.rs` has no `pub fn` with `#[inline(never)]`",
        "cannot access `absent.rs`",
    ];
    assert_refused(&ran, &expected);
}

#[test]
fn folders_and_other_files_are_told_from_modules() {
    let project = Project::arm();
    let ran = project.kane(&["verify", "models", "models/arm.toml"]);
    let expected = [
        "`models` is a folder; expected a generated module",
        "`models/arm.toml` is no Rust file; expected a generated module",
    ];
    assert_refused(&ran, &expected);
}

#[test]
fn where_the_runtime_is_not_found_it_can_be_given() {
    let ran = Project::generated().kane(&["verify", "--object", MODULE]);
    assert_refused(&ran, &["with --kane"]);
}

#[test]
fn the_runtime_is_the_one_on_which_the_package_depends() {
    let project = Project::generated();
    let kane = repository("");
    let manifest = format!(
        "[package]\nname = \"robot\"\nedition = \"2024\"\n\n[dependencies]\n\
         kane = {{ path = {:?}, default-features = false }}\n\n[workspace]\n",
        kane.to_str().unwrap()
    );
    project.write("Cargo.toml", &manifest);
    project.write("src/lib.rs", "");
    let above = project.path("").join("..");
    let module = project.path(MODULE);
    for (folder, module) in [
        (project.path(""), MODULE),
        (above, module.to_str().unwrap()),
    ] {
        let mut command = project.command();
        command.args(["verify", "--object", module]);
        command.current_dir(folder);
        command.env("CARGO_NET_OFFLINE", "true");
        let ran = Ran::from(command.output().unwrap());
        assert_eq!(ran.code, 0, "{}", ran.err);
    }
}

#[test]
fn machine_code_is_verified_without_a_word_of_it() {
    let project = Project::generated();
    let kane = repository("");
    let ran = project.kane(&["verify", MODULE, "--kane", kane.to_str().unwrap()]);
    let said = verify(&project, &[MODULE]);
    assert_eq!((ran.code, &ran.out), (0, &said.out));
}

#[test]
fn folder_without_the_runtime_is_refused_before_anything_is_compiled() {
    let project = Project::generated();
    project.write("empty/readme", "");
    project.write("other/Cargo.toml", "[package]\nname = \"other\"\n");
    project.write("other/src/lib.rs", "");
    for (folder, said) in [
        ("absent", "`absent` holds no package"),
        ("empty", "`empty` holds no package"),
        ("other", "`other` holds the package `other`"),
    ] {
        let ran = project.kane(&["verify", MODULE, "--kane", folder]);
        let said = format!("error: {said}; expected the folder of the crate `kane`\n");
        assert_eq!((ran.code, ran.err), (2, said), "{folder}");
    }
}
