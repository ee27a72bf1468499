//! Whose a file is that would be written: another model's, or another system's of one `kane.toml`.

use super::project::{Project, model, system};

/// Two models, and no `kane.toml`.
fn models() -> Project {
    let project = Project::empty();
    project.write("arm.toml", &model("arm", "1.5"));
    project.write("leg.toml", &model("leg", "3.0"));
    project
}

/// Two systems of an arm and a leg, with these outputs and more lines for both.
fn systems(outputs: [&str; 2], more: &str) -> Project {
    let project = models();
    let [arm, leg] = [("arm.toml", outputs[0]), ("leg.toml", outputs[1])]
        .map(|(model, output)| system(model, output) + more);
    project.write("kane.toml", &(arm + &leg));
    project
}

#[test]
fn file_of_another_model_is_replaced_by_force_alone() {
    let project = models();
    let arm = ["generate", "arm.toml", "-o", "x.rs", "--abi", "c"];
    assert_eq!(project.kane(&arm).code, 0);
    for (output, file) in [("x.rs", "x.rs"), ("x_c.rs", "x_c.rs")] {
        let before = project.read(file);
        let leg = ["generate", "leg.toml", "-o", output];
        let ran = project.kane(&leg);
        let told = format!(
            "error: `{file}` was generated from `arm.toml`; choose another --output, or overwrite it with --force\n"
        );
        assert_eq!((ran.code, ran.err), (2, told));
        assert_eq!(project.read(file), before);
        assert_eq!(project.kane(&[&leg[..], &["--force"]].concat()).code, 0);
        assert_ne!(project.read(file), before);
    }
    // A module that a file of its interface would replace.
    assert_eq!(
        project
            .kane(&["generate", "arm.toml", "-o", "y.rs", "--abi", "c"])
            .code,
        0
    );
    assert_eq!(
        project.kane(&["generate", "leg.toml", "-o", "z_c.rs"]).code,
        0
    );
    assert_eq!(
        project
            .kane(&["generate", "arm.toml", "-o", "z.rs", "--abi", "c"])
            .code,
        2
    );
    assert!(!project.path("z.rs").exists());
}

#[test]
fn listed_model_may_have_moved() {
    let project = Project::generated();
    project.write("models/other.toml", &project.read("models/arm.toml"));
    project.replace("kane.toml", "models/arm.toml", "models/other.toml");
    let ran = project.kane(&["generate"]);
    assert_eq!(ran.code, 0, "{}", ran.err);
    assert!(
        project
            .read("generated/arm.rs")
            .contains("from models/other.toml")
    );
}

#[test]
fn two_systems_that_write_one_file_are_refused_however_its_path_is_written() {
    for (outputs, told) in [
        (
            ["x.rs", "X.rs"],
            "two systems write `x.rs` and `X.rs`, one file where the case of letters does not count",
        ),
        (["x.rs", "sub/../x.rs"], "two systems write `sub/../x.rs`"),
    ] {
        let ran = systems(outputs, "").kane(&["generate"]);
        assert_eq!(ran.code, 2, "{outputs:?}");
        assert!(ran.err.contains(told), "{}", ran.err);
    }
    let project = models();
    let folder = project.path("");
    let name = folder.file_name().unwrap().to_str().unwrap();
    let by_its_folder = format!("../{name}/x.rs");
    let config = system("arm.toml", "x.rs") + &system("leg.toml", &by_its_folder);
    project.write("kane.toml", &config);
    let ran = project.kane(&["generate"]);
    assert_eq!(ran.code, 2);
    assert!(
        ran.err
            .contains("two systems of `kane.toml` write one file"),
        "{}",
        ran.err
    );
    assert!(!project.path("x.rs").exists());
}

#[test]
fn modules_for_c_have_names_of_their_own() {
    let abi = "abi = \"c\"\n";
    for outputs in [["a/arm.rs", "b/arm.rs"], ["a/arm.rs", "b/Arm.rs"]] {
        let ran = systems(outputs, abi).kane(&["generate"]);
        assert_eq!(ran.code, 2);
        assert!(
            ran.err.contains("functions in C begin with that name"),
            "{}",
            ran.err
        );
        assert_eq!(systems(outputs, "").kane(&["generate"]).code, 0);
    }
    let ran = systems(["math.rs", "leg.rs"], abi).kane(&["generate"]);
    assert_eq!(ran.code, 2);
    assert!(ran.err.contains("header of C"), "{}", ran.err);
    assert_eq!(
        systems(["math.rs", "leg.rs"], "").kane(&["generate"]).code,
        0
    );
}

#[test]
fn a_list_of_no_systems_is_refused() {
    let project = models();
    project.write("kane.toml", "system = []\n");
    for command in ["generate", "check"] {
        let ran = project.kane(&[command]);
        assert_eq!(ran.code, 2);
        assert!(ran.err.contains("`system` is an empty list"), "{}", ran.err);
    }
}
