//! Models that the nearest `kane.toml` does not list, while something is wrong with that file.

use super::project::{Project, model, system};

/// `models/arm.toml` is listed, `models/leg.toml` is not; the file ends with these lines.
fn project(more: &str) -> Project {
    let project = Project::arm();
    project.write("models/leg.toml", &model("leg", "3.0"));
    project.write("kane.toml", &(project.read("kane.toml") + more));
    project
}

/// Commands that look at one model.
fn commands(model: &str) -> [Vec<&str>; 5] {
    let eval = ["eval", model, "-f", "inertial_parameters"];
    let generate = ["generate", model, "--functions", "bias", "--output", "-"];
    let diff = ["diff", model, model];
    [
        vec!["info", model],
        eval.to_vec(),
        generate.to_vec(),
        diff.to_vec(),
        vec![
            "generate",
            model,
            "--output",
            "leg.rs",
            "--functions",
            "bias",
        ],
    ]
}

#[test]
fn faults_that_have_nothing_to_do_with_a_model_are_not_told() {
    let lines = [
        "fna = true\n".to_owned(),
        "formulation = \"newton\"\n".to_owned(),
        // Not even the function is known, nor where it goes.
        "[[system]]\nmodel = \"models/third.toml\"\nfunctions = [\"biass\"]\n".to_owned(),
        system("models/third.toml", "generated/arm.rs"),
    ];
    for lines in lines {
        let (faulty, right) = (project(&lines), project(""));
        assert_eq!(faulty.kane(&["generate"]).code, 2, "{lines}");
        for command in commands("models/leg.toml") {
            let [faulty, right] = [&faulty, &right].map(|project| project.kane(&command));
            assert_eq!(faulty.code, 0, "{command:?}: {}", faulty.err);
            assert_eq!(faulty.out, right.out, "{command:?}");
            assert_eq!(faulty.told(), right.told(), "{command:?}");
        }
    }
}

#[test]
fn file_that_cannot_be_read_is_said_to_have_options() {
    for command in commands("models/leg.toml") {
        let ran = project("[[system\n").kane(&command);
        assert_eq!(ran.code, 2, "{}", ran.err);
        let said = "note: `kane.toml` was read because it may list `models/leg.toml`, with options for it\n";
        assert!(ran.err.ends_with(said), "{command:?}: {}", ran.err);
    }
}

#[test]
fn faults_are_told_if_the_file_lists_the_model() {
    let faulty = project(&(system("models/leg.toml", "generated/leg.rs") + "fna = true\n"));
    for model in ["models/arm.toml", "models/leg.toml"] {
        for command in commands(model) {
            let ran = faulty.kane(&command);
            assert_eq!(ran.code, 2, "{command:?}");
            assert!(ran.err.contains("unknown key `fna`"), "{}", ran.err);
        }
    }
}

#[test]
fn faults_are_told_if_it_is_unknown_what_the_file_lists() {
    for (lines, fault) in [
        ("manifest = = true\n", "not valid TOML"),
        ("manifest = true\nmanifest = true\n", "is given twice"),
        (
            "[[sytem]]\nmodel = \"models/leg.toml\"\n",
            "unknown key `sytem`",
        ),
        ("[[system]]\noutput = \"leg.rs\"\n", "has no `model`"),
        (
            "[[system]]\nmodle = \"models/leg.toml\"\noutput = \"leg.rs\"\n",
            "unknown key `modle`",
        ),
        (
            "[[system]]\nmodel = 'models\\leg.toml'\noutput = \"leg.rs\"\n",
            "backslash",
        ),
    ] {
        let faulty = project(lines);
        for command in commands("models/leg.toml") {
            let ran = faulty.kane(&command);
            assert_eq!(ran.code, 2, "{command:?}\n{lines}");
            assert!(ran.err.contains(fault), "{}", ran.err);
        }
    }
}

#[test]
fn faults_of_a_file_that_is_named_are_told() {
    let faulty = project("fna = true\n");
    let generate = ["generate", "models/leg.toml", "--output", "-", "--config"];
    let ran = faulty.kane(&[&generate[..], &["kane.toml"]].concat());
    assert_eq!(ran.code, 2);
    assert!(ran.err.contains("unknown key `fna`"), "{}", ran.err);
}

#[test]
fn a_list_of_models_is_told_from_a_model_that_is_not_listed() {
    let ran = project("").kane(&["check", "kane.toml"]);
    assert_eq!(ran.code, 2);
    insta::assert_snapshot!(ran.err, @"error: `kane.toml` is a list of models, not a model; pass it with --config");
}

#[test]
fn model_still_needs_an_output_beside_a_file_with_faults() {
    let ran = project("fna = true\n").kane(&["generate", "models/leg.toml"]);
    assert_eq!(ran.code, 2);
    insta::assert_snapshot!(ran.err, @"error: `kane.toml` does not list `models/leg.toml`; say where to write with --output FILE, where `-` is standard output");
}
