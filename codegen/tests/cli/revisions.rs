//! `kane diff` of what git has.

use kane_codegen::limits;
use serde_json::Value;

use super::project::{Project, Ran};

#[test]
fn revisions_are_read_from_git() {
    let project = Project::arm().committed();
    project.replace("models/arm.toml", "mass = 1.5", "mass = 1.25");
    let told = "values\n  changed  fore: mass  1.5 -> 1.25\n";
    for (folder, old, new) in [
        ("", "HEAD:models/arm.toml", "models/arm.toml"),
        ("models", "HEAD:models/arm.toml", "arm.toml"),
        ("models", "HEAD:./arm.toml", "arm.toml"),
        ("models", ":models/arm.toml", "arm.toml"),
    ] {
        let ran = project.kane_in(folder, &["diff", old, new, "--lines"]);
        assert_eq!(ran.code, 1, "{}", ran.err);
        assert!(ran.out.starts_with(told), "{}", ran.out);
        assert!(
            ran.out
                .contains(&format!("--- {old}\told\n+++ {new}\tnew\n"))
        );
    }
    project.commit();
    let both = [
        "diff",
        "HEAD~1:models/arm.toml",
        "HEAD:models/arm.toml",
        "--lines",
    ];
    let ran = project.kane(&both);
    assert!(ran.out.starts_with(told), "{}", ran.out);
    // The functions that kane.toml lists, and no others.
    assert!(ran.out.contains("; formulation: recursive."), "{}", ran.out);
    assert!(!ran.out.contains("forward_dynamics"), "{}", ran.out);
    let ran = project.kane(&["diff", ":models/arm.toml", "models/arm.toml"]);
    assert_eq!((ran.code, ran.out.as_str()), (0, ""));
}

#[test]
fn files_in_hidden_folders_are_read_from_the_root() {
    let project = Project::empty();
    let body = "<body><joint axis='0 0 1'/><geom size='0.1' mass='1.5'/></body>";
    let main = "<mujoco><worldbody><include file='body.xml'/></worldbody></mujoco>";
    project.write(".robots/arm.xml", main);
    project.write(
        ".robots/body.xml",
        &format!("<mujocoinclude>{body}</mujocoinclude>"),
    );
    project.write("below/file", "");
    let project = project.committed();
    project.replace(".robots/body.xml", "1.5", "1.25");
    for (folder, new) in [("", ".robots/arm.xml"), ("below", "../.robots/arm.xml")] {
        let ran = project.kane_in(folder, &["diff", "HEAD:.robots/arm.xml", new]);
        assert_eq!(ran.code, 1, "{}", ran.err);
        assert!(ran.out.contains("1.5 -> 1.25"), "{}", ran.out);
    }
}

/// A repository whose second commit changed the arm, listed a second system and left a third one out.
fn history() -> Project {
    let project = Project::arm();
    let system = |name: &str| {
        format!(
            "[[system]]\nmodel = \"models/arm.toml\"\noutput = \"{name}.rs\"\nfunctions = [\"mass_matrix\"]\nabi = \"c\"\n"
        )
    };
    project.write("kane.toml", &(system("arm") + &system("left")));
    let project = project.committed();
    project.replace("models/arm.toml", "mass = 1.5", "mass = 1.25");
    project.write("kane.toml", &(system("arm") + &system("right")));
    project.commit();
    project
}

#[test]
fn revisions_are_compared_system_by_system() {
    let project = history();
    let told = "BREAKING: files that are gone, or in which places, names, functions or arguments changed\n  removed  left.rs\n  removed  left_c.rs\n  removed  left.h\n\
        files\n  added    right.rs\n  added    right_c.rs\n  added    right.h\n\
        == HEAD~1:arm.rs -> HEAD:arm.rs\nvalues\n  changed  fore: mass  1.5 -> 1.25\n";
    let ran = project.kane(&["diff", "HEAD~1", "HEAD", "--lines"]);
    assert_eq!(ran.code, 1, "{}", ran.err);
    assert!(ran.out.starts_with(told), "{}", ran.out);
    assert!(
        ran.out
            .contains("\n--- HEAD~1:arm.rs\told\n+++ HEAD:arm.rs\tnew\n")
    );

    let ran = project.kane_in("models", &["diff", "HEAD~1", "HEAD", "--format", "json"]);
    let value: Value = serde_json::from_str(&ran.out).unwrap();
    assert_eq!(
        value["added"],
        serde_json::json!(["../right.rs", "../right_c.rs", "../right.h"])
    );
    assert_eq!(
        value["removed"],
        serde_json::json!(["../left.rs", "../left_c.rs", "../left.h"])
    );
    assert_eq!(value["breaking"], true);
    let arm = &value["systems"][0];
    assert_eq!(value["systems"].as_array().unwrap().len(), 1);
    assert_eq!(
        (&arm["old"], &arm["new"]),
        (&"HEAD~1:arm.rs".into(), &"HEAD:arm.rs".into())
    );
    assert_eq!(arm["values"][0]["new"], "1.25");
}

#[test]
fn one_revision_is_compared_with_the_files_as_they_are() {
    let project = history();
    let ran = project.kane(&["diff", "HEAD"]);
    assert_eq!((ran.code, ran.out.as_str()), (0, ""));
    assert_eq!(
        ran.err,
        "nothing differs between HEAD and the files as they are\n"
    );
    project.replace("models/arm.toml", "[\"theta2\"]", "[\"s3\"]");
    let ran = project.kane(&["diff", "HEAD"]);
    assert_eq!(ran.code, 1);
    insta::assert_snapshot!(ran.out.split("== HEAD:arm.rs").next().unwrap(), @"
    BREAKING: files that are gone, or in which places, names, functions or arguments changed
      changed  arm.rs    q, u
      changed  right.rs  q, u
    ");
    let told = "== HEAD:arm.rs -> arm.rs\nBREAKING: the places in q changed\n";
    assert!(ran.out.contains(told), "{}", ran.out);
    assert!(ran.out.contains("== HEAD:right.rs -> right.rs\n"));

    let ran = project.kane(&["diff", "HEAD", "--format", "markdown"]);
    assert!(
        ran.out
            .starts_with("## `HEAD` → `the files as they are`\n\n**BREAKING: files "),
        "{}",
        ran.out
    );
}

#[test]
fn systems_of_a_revision_without_a_list_are_all_new() {
    let project = Project::empty();
    project.write("README.md", "an arm\n");
    let project = project.committed();
    let listed = Project::arm();
    for file in ["kane.toml", "models/arm.toml"] {
        project.write(file, &listed.read(file));
    }
    let ran = project.kane(&["diff", "HEAD"]);
    assert_eq!(ran.code, 1, "{}", ran.err);
    assert!(
        ran.out.starts_with("files\n  added    generated/arm.rs\n"),
        "{}",
        ran.out
    );
}

#[test]
fn list_is_found_wherever_it_is_said_to_stand() {
    let project = history();
    let absolute = project.path("kane.toml").display().to_string();
    let told = |folder: &str, config: &str| {
        let arguments = ["diff", "HEAD~1", "HEAD", "--config", config];
        project.kane_in(folder, &arguments)
    };
    for (folder, config) in [("", absolute.as_str()), ("models", "../kane.toml")] {
        let ran = told(folder, config);
        assert_eq!(ran.code, 1, "{}", ran.err);
        assert!(ran.out.contains("fore: mass  1.5 -> 1.25"), "{}", ran.out);
    }
    for (config, why) in [
        (
            "typo.toml",
            "neither `HEAD~1` nor `HEAD` has a file `typo.toml`",
        ),
        ("../kane.toml", "git knows no file `../kane.toml`"),
    ] {
        let ran = told("", config);
        assert_eq!((ran.code, ran.out.as_str()), (2, ""));
        assert_eq!(ran.err, format!("error: {why}\n"));
    }
}

#[test]
fn what_is_no_revision_and_has_nothing_beside_it_is_said() {
    let project = Project::arm().committed();
    for (arguments, told) in [
        (
            &["main~9"][..],
            "`main~9` is no git revision; expected one, or a second file to compare it with; `kane diff HEAD` compares all systems with the last commit",
        ),
        (
            &["HEAD~1..HEAD"],
            "`HEAD~1..HEAD` is no git revision; expected two revisions apart: `kane diff HEAD~1 HEAD`",
        ),
        (
            &["main..."],
            "`main...` is no git revision; expected two revisions apart: `kane diff main HEAD`",
        ),
        (
            &["HEAD", "models/arm.toml"],
            "`HEAD` is a git revision, `models/arm.toml` is a file; expected two revisions, or two files, of which one may be `REVISION:PATH`",
        ),
        (
            &["gone", "HEAD"],
            "`HEAD` is a git revision, `gone` is neither a revision nor a file; expected two revisions, or two files, of which one may be `REVISION:PATH`",
        ),
    ] {
        let ran = project.kane(&[&["diff"], arguments].concat());
        assert_eq!((ran.code, ran.out.as_str()), (2, ""));
        assert_eq!(ran.err, format!("error: {told}\n"));
    }
}

#[test]
fn folder_in_no_repository_has_no_revisions() {
    let project = Project::arm();
    let mut command = project.command();
    command
        .args(["diff", "HEAD"])
        .env("GIT_CEILING_DIRECTORIES", project.path(".."));
    let ran: Ran = command.output().unwrap().into();
    assert_eq!(
        (ran.code, ran.err.as_str()),
        (
            2,
            "error: `HEAD` is no git revision, for this folder is in no git repository; expected two files\n"
        )
    );
}

#[test]
fn why_git_knows_no_revision_is_told() {
    let project = Project::arm();
    project.git(&["init", "--quiet"]);
    let ran = project.kane(&["diff", "HEAD"]);
    let told = "error: `HEAD` is no git revision, for the repository has no commit yet; expected two files\n";
    assert_eq!((ran.code, ran.err.as_str()), (2, told));
    let mut command = project.command();
    command.args(["diff", "HEAD"]).env("PATH", "/nowhere");
    let ran: Ran = command.output().unwrap().into();
    assert_eq!(ran.code, 2);
    let told = "error: `HEAD` is no git revision, for git cannot be run: ";
    assert!(ran.err.starts_with(told), "{}", ran.err);
}

#[test]
fn generated_modules_of_revisions_are_compared() {
    let project = Project::generated().committed();
    project.replace("models/arm.toml", "[\"theta2\"]", "[\"s3\"]");
    assert_eq!(project.kane(&["generate"]).code, 0);
    let ran = project.kane(&["diff", "HEAD:generated/arm.rs", "generated/arm.rs"]);
    assert_eq!(ran.code, 1);
    assert!(
        ran.out.contains("BREAKING: the places in q changed\n"),
        "{}",
        ran.out
    );
}

#[test]
fn files_that_a_model_includes_are_those_of_its_revision() {
    let project = Project::empty();
    let robot = |mass: &str| {
        format!(
            "<mujoco><worldbody><body name=\"bob\"><joint type=\"hinge\" axis=\"0 1 0\"/>\
             <inertial pos=\"0 0 1\" mass=\"{mass}\" diaginertia=\"1 1 1\"/></body></worldbody></mujoco>"
        )
    };
    project.write(
        "models/arm.xml",
        "<mujoco><include file=\"parts/bob.xml\"/></mujoco>",
    );
    project.write("models/parts/bob.xml", &robot("2"));
    let project = project.committed();
    project.write("models/parts/bob.xml", &robot("3"));
    for old in ["HEAD:models/arm.xml", "HEAD:./models/arm.xml"] {
        let ran = project.kane(&["diff", old, "models/arm.xml"]);
        assert!(
            ran.out
                .starts_with("values\n  changed  bob: mass  2.0 -> 3.0\n"),
            "{ran:?}"
        );
    }
}

#[test]
fn revision_that_cannot_be_read_is_said() {
    let project = Project::arm().committed();
    for (old, why) in [
        ("nowhere:models/arm.toml", "invalid object name"),
        ("HEAD:models/gone.toml", "does not exist in 'HEAD'"),
        ("HEAD:models", "bad file"),
    ] {
        let ran = project.kane(&["diff", old, "models/arm.toml"]);
        assert_eq!((ran.code, ran.out.as_str()), (2, ""));
        let told = format!("error: git has no file `{old}`: fatal: ");
        assert!(
            ran.err.starts_with(&told) && ran.err.contains(why),
            "{}",
            ran.err
        );
    }
    project.write("models/arm.toml", &"#".repeat(limits::INPUT_BYTES + 1));
    project.commit();
    let ran = project.kane(&["diff", "HEAD:models/arm.toml", "HEAD~1:models/arm.toml"]);
    assert_eq!(ran.code, 2);
    let told = "error: cannot access `HEAD:models/arm.toml`: it has more than ";
    assert!(ran.err.starts_with(told), "{}", ran.err);
    let mut command = project.command();
    command.args(["diff", "HEAD:models/arm.toml", "models/arm.toml"]);
    let ran: Ran = command.env("PATH", "").output().unwrap().into();
    assert_eq!(ran.code, 2);
    assert!(
        ran.err
            .starts_with("error: `HEAD:models/arm.toml` is no file here, and git, which would know a revision, cannot be run: "),
        "{}",
        ran.err
    );
}

#[test]
fn faults_of_kane_toml_are_pointed_at_in_each_revision() {
    let project = history();
    let functions = "functions = [\"mass_matrix\"]";
    let faulty = "functions = [\"pose(foer)\"]\nremove = [\"hand\"]";
    let config = project.read("kane.toml").replacen(functions, faulty, 1);
    project.write("kane.toml", &config);
    let ran = project.kane(&["diff", "HEAD"]);
    assert_eq!((ran.code, ran.out.as_str()), (2, ""));
    insta::assert_snapshot!(ran.err);
    project.commit();
    project.write(
        "kane.toml",
        &config.replace("foer", "fore").replace("hand", "hund"),
    );
    let ran = project.kane(&["diff", "HEAD"]);
    assert_eq!((ran.code, ran.out.as_str()), (2, ""));
    insta::assert_snapshot!(ran.err);
}

#[test]
fn options_that_changed_are_told_and_a_model_that_moved() {
    let project = Project::arm().committed();
    let config = project.read("kane.toml");
    project.write("kane.toml", &format!("{config}snap = 1e-5\nfma = true\n"));
    let ran = project.kane(&["diff", "HEAD"]);
    assert_eq!(ran.code, 1, "{}", ran.err);
    let told = "options\n  added    fma   true\n  changed  snap  1e-9 -> 1e-5\n";
    assert!(ran.out.contains(told), "{}", ran.out);
    project.write("models/other.toml", &project.read("models/arm.toml"));
    project.write(
        "kane.toml",
        &config.replace("models/arm.toml", "models/other.toml"),
    );
    let ran = project.kane(&["diff", "HEAD"]);
    let told = "the model was models/arm.toml and is models/other.toml";
    assert!(ran.out.contains(told), "{}", ran.out);
}
