//! `kane convert`.

use super::project::{Project, model};

/// The arm with what a person would write beside what the model says.
fn commented() -> Project {
    let project = Project::empty();
    let text = model("arm", "2.0").replace("mass = 1.5", "mass   =   15e-1 # weighed");
    project.write("arm.toml", &text.replace('\n', "\n# said\n"));
    project
}

#[test]
fn model_is_printed_in_our_own_format() {
    let ran = commented().kane(&["convert", "arm.toml"]);
    assert_eq!((ran.code, ran.err.as_str()), (0, ""));
    assert_eq!(ran.out, model("arm", "2.0"));
}

#[test]
fn converted_model_generates_what_the_model_does() {
    let project = commented();
    let ran = project.kane(&["convert", "arm.toml", "--output", "deep/er/arm.toml"]);
    assert_eq!(
        (ran.code, ran.out.as_str(), ran.err.as_str()),
        (0, "", "wrote deep/er/arm.toml\n")
    );
    let module = |path: &str| project.kane(&["generate", path, "--output", "-"]).out;
    let (before, after) = (module("arm.toml"), module("deep/er/arm.toml"));
    assert!(before.len() > 1000);
    assert_eq!(before, after);
}

#[test]
fn file_that_is_there_is_overwritten_with_force_alone() {
    let project = commented();
    project.write("precious.toml", "# by hand\n");
    let convert = ["convert", "arm.toml", "--output", "precious.toml"];
    let ran = project.kane(&convert);
    assert_eq!(ran.code, 2);
    insta::assert_snapshot!(ran.err, @"error: `precious.toml` is there already; move it away, or overwrite it with --force");
    assert_eq!(project.read("precious.toml"), "# by hand\n");
    let ran = project.kane(&[&convert[..], &["--force"]].concat());
    assert_eq!((ran.code, ran.err.as_str()), (0, "wrote precious.toml\n"));
    assert_eq!(project.read("precious.toml"), model("arm", "2.0"));
    // What is the same already is nobody's loss.
    assert_eq!(project.kane(&convert).err, "precious.toml is up to date\n");
}

#[test]
fn model_is_never_overwritten() {
    let project = commented();
    let before = project.files();
    let ran = project.kane(&["convert", "arm.toml", "--force", "--output", "./arm.toml"]);
    assert_eq!(ran.code, 2);
    insta::assert_snapshot!(ran.err, @"error: `arm.toml` is the model; what it is converted to needs a file of its own");
    assert_eq!(project.files(), before);
}

#[test]
fn faulty_model_is_not_converted() {
    let project = Project::empty();
    project.write(
        "arm.toml",
        &model("arm", "-2.0").replace("theta2", "theta4"),
    );
    let before = project.files();
    let ran = project.kane(&["convert", "arm.toml", "--output", "other.toml"]);
    assert_eq!((ran.code, ran.out.as_str()), (2, ""));
    assert!(
        ran.err.contains("arm.toml:7:8") && ran.err.contains("arm.toml:19:10"),
        "{}",
        ran.err
    );
    assert_eq!(project.files(), before);
}

#[test]
fn nothing_is_renumbered_and_notes_of_modules_are_told_to_those_who_ask() {
    let project = Project::empty();
    let text = model("arm", "2.0").replace("lower_bodies = [0, 1]", "lower_bodies = [2, 0]");
    project.write("arm.toml", &text);
    let ran = project.kane(&["convert", "arm.toml"]);
    assert_eq!((ran.code, ran.out, ran.err.as_str()), (0, text, ""));
    let ran = project.kane(&["convert", "arm.toml", "--verbose"]);
    assert!(ran.err.contains("renumbered outward"), "{}", ran.err);
}

#[test]
fn model_that_says_it_itself_is_not_told_its_base() {
    let ran = commented().kane(&["convert", "arm.toml", "--base", "free"]);
    assert_eq!((ran.code, ran.out.as_str()), (2, ""));
    assert!(
        ran.err
            .starts_with("error: the base can be chosen for a URDF alone: "),
        "{}",
        ran.err
    );
}

#[test]
fn name_of_the_list_of_models_is_refused() {
    let project = Project::arm();
    let before = project.files();
    for path in ["kane.toml", "new/kane.toml"] {
        let ran = project.kane(&["convert", "models/arm.toml", "--force", "--output", path]);
        let said = format!(
            "error: `{path}` is the name of a list of models; expected another name for a model\n"
        );
        assert_eq!((ran.code, ran.err), (2, said));
    }
    assert_eq!(project.files(), before);
}
