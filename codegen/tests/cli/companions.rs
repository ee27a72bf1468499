//! Files beside a module.

use serde_json::Value;

use super::project::{Project, model, system};

/// An arm with its manifest, not generated yet.
fn arm() -> Project {
    let project = Project::arm();
    let config = project.read("kane.toml");
    project.write("kane.toml", &format!("{config}manifest = true\n"));
    project
}

/// The same, generated.
fn generated() -> Project {
    let project = arm();
    assert_eq!(project.kane(&["generate"]).code, 0);
    project
}

fn manifest(project: &Project) -> Value {
    serde_json::from_str(&project.read("generated/arm.json")).unwrap()
}

#[test]
fn what_nobody_asks_for_is_not_written() {
    let project = Project::generated();
    assert!(!project.path("generated/arm.json").exists());
}

#[test]
fn manifest_stands_beside_its_module_which_stays_as_it_is() {
    let (project, plain) = (arm(), Project::generated());
    let ran = project.kane(&["generate"]);
    assert_eq!(ran.told(), "wrote generated/arm.rs, generated/arm.json\n");
    assert_eq!(
        project.read("generated/arm.rs"),
        plain.read("generated/arm.rs")
    );
    let ran = project.kane(&["generate"]);
    assert_eq!(ran.told(), "all 2 files are up to date\n");
}

#[test]
fn line_in_a_manifest_is_no_comment() {
    let project = generated();
    let text = project.read("generated/arm.json");
    for edited in [text.replacen('\n', "\n// x\n", 1), format!("{text}// x\n")] {
        project.write("generated/arm.json", &edited);
        let told = project.kane(&["check"]).out;
        let said = "generated/arm.json differs: 1 line removed, 0 added\n";
        assert!(told.starts_with(said), "{told}");
    }
}

#[test]
fn manifest_says_what_the_module_holds() {
    let project = generated();
    let (manifest, module) = (manifest(&project), project.read("generated/arm.rs"));
    assert_eq!(
        (&manifest["name"], &manifest["model"]),
        (&Value::from("arm"), &Value::from("models/arm.toml"))
    );
    let input = manifest["input"].as_str().unwrap();
    assert!(module.contains(&format!("// Input {input}, format {};", manifest["format"])));
    for (size, names) in [("NB", "bodies"), ("NQ", "coordinates"), ("NU", "speeds")] {
        let names = manifest[names].as_array().unwrap();
        assert_eq!(manifest[size], names.len());
    }
    for function in manifest["functions"].as_array().unwrap() {
        let name = function["name"].as_str().unwrap();
        let signature = format!("pub fn {name}<R: kane::Real>(");
        let (before, after) = module.split_once(&signature).unwrap();
        let (arguments, _) = after.split_once(") {").unwrap();
        let arguments = arguments.split(',').filter_map(|one| one.split_once(": "));
        let arguments: Vec<&str> = arguments.map(|(name, _)| name.trim()).collect();
        let named = ["arguments", "outputs"].map(|key| function[key].as_array().unwrap());
        let named = named.into_iter().flatten().map(|one| &one["name"]);
        assert_eq!(named.collect::<Vec<_>>(), arguments);
        let counts = &function["operations"];
        let [total, mul, add, div, trig] =
            ["total", "mul", "add", "div", "trig"].map(|kind| &counts[kind]);
        let stated =
            format!("Operations: {total} = {mul} mul + {add} add + {div} div + {trig} trig");
        assert!(before.rsplit("\n\n").next().unwrap().contains(&stated));
    }
    let functions = manifest["functions"].as_array().unwrap();
    let mut functions = functions.iter();
    let mass_matrix = functions.find(|function| function["name"] == "mass_matrix");
    assert_eq!(
        mass_matrix.unwrap()["outputs"][0]["shape"],
        serde_json::json!([3, 3])
    );
}

#[test]
fn function_of_a_manifest_is_a_line() {
    let text = generated().read("generated/arm.json");
    let (_, functions) = text.split_once("\n  \"functions\": [\n").unwrap();
    let is_function = |line: &&str| line.starts_with("    { \"name\": ");
    assert_eq!(functions.lines().filter(is_function).count(), 3);
}

#[test]
fn fingerprint_is_of_the_model_alone() {
    let fingerprint = |change: fn(&Project)| {
        let project = arm();
        change(&project);
        assert_eq!(project.kane(&["generate"]).code, 0);
        manifest(&project)["fingerprint"].clone()
    };
    let plain = fingerprint(|_| ());
    assert_eq!(
        fingerprint(|project| project.replace("kane.toml", "\"mass_matrix\", ", "")),
        plain
    );
    assert_eq!(
        fingerprint(|project| project.replace("models/arm.toml", "1.5", "1.50 # kg")),
        plain
    );
    assert_ne!(
        fingerprint(|project| project.replace("models/arm.toml", "1.5", "1.25")),
        plain
    );
    assert_ne!(
        fingerprint(|project| project.replace("models/arm.toml", "\"fore\"", "\"lower\"")),
        plain
    );
}

#[test]
fn manifest_that_differs_or_is_missing_is_told() {
    let project = generated();
    project.replace("generated/arm.json", "\"NB\": 2", "\"NB\": 3");
    let ran = project.kane(&["check", "--lines"]);
    assert_eq!(ran.code, 1);
    for part in [
        "--- generated/arm.json\tas it is\n",
        "\n-  \"NB\": 3,\n+  \"NB\": 2,\n",
    ] {
        assert!(ran.out.contains(part), "{}", ran.out);
    }
    assert!(!ran.out.contains("operations\n"), "{}", ran.out);
    std::fs::remove_file(project.path("generated/arm.json")).unwrap();
    let ran = project.kane(&["check"]);
    assert_eq!(
        (ran.code, ran.out.as_str()),
        (
            1,
            "generated/arm.json is missing\nto bring this up to date, run: kane generate\n"
        )
    );
}

#[test]
fn manifest_that_nothing_asks_for_any_more_is_stray() {
    let project = Project::empty();
    project.write("models/arm.toml", &super::project::model("arm", "2.0"));
    for output in ["generated/arm", "src/arm"] {
        let config = system("models/arm.toml", &format!("{output}.rs"));
        project.write("kane.toml", &format!("{config}manifest = true\n"));
        assert_eq!(project.kane(&["generate"]).code, 0);
        assert_eq!(project.kane(&["check"]).out, "");
        project.write("kane.toml", &config);
        // A file that another tool wrote.
        project.write("src/other.json", "{ \"generated_by\": \"another\" }");
        let ran = project.kane(&["check"]);
        let stray = format!(
            "{output}.json is produced by nothing in kane.toml, or another kane.toml writes here: remove it, or give its system `manifest = true`\n"
        );
        assert_eq!((ran.code, ran.out), (1, stray));
    }
}

#[test]
fn file_by_hand_is_not_replaced_by_a_manifest_nor_its_module_written() {
    let project = arm();
    project.write("generated/arm.json", "{}\n");
    let files = project.files();
    let ran = project.kane(&["generate"]);
    assert_eq!(ran.code, 2);
    insta::assert_snapshot!(ran.err, @"error: `generated/arm.json` was not written by `kane generate`; move it away, or overwrite it with --force");
    assert_eq!(project.files(), files);
    assert_eq!(project.kane(&["generate", "--force"]).code, 0);
    assert_eq!(manifest(&project)["name"], "arm");
}

#[test]
fn manifest_with_line_ends_of_another_system_is_still_ours() {
    let project = generated();
    project.replace("generated/arm.json", "\n", "\r\n");
    assert!(
        project
            .kane(&["check"])
            .out
            .starts_with("generated/arm.json has line ends CR LF; expected LF")
    );
    assert_eq!(project.kane(&["generate"]).code, 0);
}

#[test]
fn standard_output_takes_the_module_alone() {
    let project = generated();
    let arguments = ["generate", "models/arm.toml", "--output", "-"];
    let functions = ["--functions", "mass_matrix,bias"];
    let ran = project.kane(&[&arguments[..], &functions].concat());
    assert_eq!((ran.code, ran.out), (0, project.read("generated/arm.rs")));
    let beside = ["--manifest", "--with-tests", "--abi", "c"];
    let ran = project.kane(&[&arguments[..], &beside].concat());
    assert_eq!((ran.code, ran.out.as_str()), (2, ""));
    for option in ["--manifest", "--with-tests", "--abi"] {
        let fault = format!(
            "error: {option} writes beside the module, and standard output takes it alone; name a file with --output"
        );
        assert!(ran.err.contains(&fault), "{}", ran.err);
    }
    let ran = project.kane(&[&arguments[..], &["--manifest=false"]].concat());
    assert_eq!(ran.code, 0, "{}", ran.err);
}

#[test]
fn option_stands_above_what_is_listed_and_is_in_the_command_that_is_printed() {
    let project = Project::generated();
    let ran = project.kane(&["check", "models/arm.toml", "--manifest"]);
    assert_eq!(
        (ran.code, ran.out.as_str()),
        (
            1,
            "generated/arm.json is missing\n\
             to bring this up to date, run: kane generate models/arm.toml --manifest\n"
        )
    );
    let project = generated();
    project.write("generated/arm.json", "");
    let ran = project.kane(&["check", "models/arm.toml", "--manifest=false"]);
    assert_eq!((ran.code, ran.out.as_str()), (0, ""));
}

#[test]
fn file_that_would_replace_the_model_or_is_no_module_is_refused() {
    let project = Project::arm();
    project.write("arm.json", &project.read("models/arm.toml"));
    let arguments = ["generate", "arm.json", "--manifest", "--output"];
    for (output, why) in [
        ("arm.rs", "`arm.json` is the model"),
        (
            "./new.json",
            "`./new.json` is to be a module; expected a file that ends in `.rs`",
        ),
    ] {
        let ran = project.kane(&[&arguments[..], &[output]].concat());
        assert_eq!((ran.code, ran.err.contains(why)), (2, true), "{}", ran.err);
    }
}

#[test]
fn tests_stand_beside_their_module_and_name_its_functions() {
    let project = Project::generated();
    let config = project.read("kane.toml");
    project.write("kane.toml", &format!("{config}tests = true\n"));
    assert_eq!(project.kane(&["check"]).code, 1);
    let ran = project.kane(&["generate"]);
    assert_eq!(
        ran.told(),
        "wrote generated/arm_tests.rs; 1 file is up to date\n"
    );
    assert_eq!(project.kane(&["check"]).code, 0);
    let (module, tests) = (
        project.read("generated/arm.rs"),
        project.read("generated/arm_tests.rs"),
    );
    let functions = module.split("pub fn ").skip(1);
    let names: Vec<&str> = functions
        .filter_map(|rest| rest.split_once("<R: kane::Real>("))
        .map(|(name, _)| name)
        .collect();
    assert_eq!(names, ["mass_matrix", "q_dot", "bias"]);
    assert!(tests.contains("\nuse super::arm::*;\n"), "{tests}");
    for name in names {
        assert!(
            tests.contains(&format!("fn {name}_has_its_values(")),
            "{name}"
        );
    }
    project.write("generated/arm_tests.rs", &tests.replace("0.", "1."));
    assert_eq!(project.kane(&["check"]).code, 1);
}

#[test]
fn tests_of_functions_with_names_are_those_of_the_functions() {
    let project = Project::arm();
    let tests = |functions: &str| {
        let arguments = [
            "generate",
            "models/arm.toml",
            "--functions",
            functions,
            "--with-tests",
            "--output",
            "own.rs",
        ];
        let ran = project.kane(&arguments);
        assert_eq!(ran.code, 0, "{ran:?}");
        project.read("own_tests.rs")
    };
    // Names that the tests have for other things.
    let named = tests("system = forward_dynamics, p = inverse_dynamics");
    for called in ["module::system(", "module::p("] {
        assert!(named.contains(called), "{called}");
    }
    let law = "fn forward_undoes_inverse()";
    assert!(tests("forward_dynamics, inverse_dynamics").contains(law));
    assert!(named.contains(law));
}

#[test]
fn files_that_are_no_longer_asked_for_are_told() {
    let project = Project::empty();
    project.write("arm.toml", &model("arm", "2.0"));
    assert_eq!(
        project.kane(&["generate", "arm.toml", "--abi", "c"]).code,
        0
    );
    project.replace("arm.toml", "mass = 2.0", "mass = 2.5");
    let ran = project.kane(&["generate", "arm.toml"]);
    assert_eq!(
        ran.told(),
        "wrote arm.rs
warning: arm_c.rs was generated before and is left as it was: add `--abi c`, or remove it
warning: arm.h was generated before and is left as it was: add `--abi c`, or remove it
"
    );
    let ran = project.kane(&["check", "arm.toml"]);
    assert_eq!(ran.code, 1);
    assert_eq!(
        ran.out,
        "arm_c.rs is produced by nothing asked for: add `--abi c`, or remove it
arm.h is produced by nothing asked for: add `--abi c`, or remove it
"
    );
    assert_eq!(project.kane(&["check", "arm.toml", "--abi", "c"]).code, 1);
    assert_eq!(
        project.kane(&["generate", "arm.toml", "--abi", "c"]).code,
        0
    );
    assert_eq!(project.kane(&["check", "arm.toml", "--abi", "c"]).code, 0);
    // What people wrote is nothing of ours.
    project.write("arm.json", "{}");
    assert_eq!(project.kane(&["check", "arm.toml", "--abi", "c"]).code, 0);
}
