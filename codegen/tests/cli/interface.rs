//! Functions for C beside a module.

use super::project::Project;

/// An arm with its functions for C, generated.
fn arm() -> Project {
    let project = Project::arm();
    let config = project.read("kane.toml");
    project.write("kane.toml", &format!("{config}abi = \"c\"\n"));
    let ran = project.kane(&["generate"]);
    assert_eq!(
        (ran.code, ran.told().as_str()),
        (
            0,
            "wrote generated/arm.rs, generated/arm_c.rs, generated/arm.h\n"
        )
    );
    project
}

#[test]
fn functions_for_c_leave_the_module_as_it_is() {
    let (project, plain) = (arm(), Project::generated());
    assert_eq!(
        project.read("generated/arm.rs"),
        plain.read("generated/arm.rs")
    );
    assert_eq!(project.kane(&["check"]).out, "");
}

#[test]
fn functions_for_c_are_the_same_in_every_folder() {
    let (one, other) = (arm(), arm());
    assert_eq!(one.files().len(), other.files().len());
    for file in ["generated/arm_c.rs", "generated/arm.h"] {
        assert_eq!(one.read(file), other.read(file));
    }
}

#[test]
fn stale_header_is_told() {
    let project = arm();
    project.replace("models/arm.toml", "mass = 2.0", "mass = { runtime = 2.0 }");
    assert_eq!(project.kane(&["generate", "models/arm.toml"]).code, 0);
    project.replace(
        "generated/arm.h",
        "    /// Nominal value 2.0 kg.\n    double upper_mass;\n",
        "    double unused;\n",
    );
    let ran = project.kane(&["check", "--lines"]);
    assert_eq!(ran.code, 1);
    for part in [
        "--- generated/arm.h\tas it is\n",
        "\n-    double unused;\n+    /// Nominal value 2.0 kg.\n+    double upper_mass;\n",
        "\nto bring this up to date, run: kane generate\n",
    ] {
        assert!(ran.out.contains(part), "{}", ran.out);
    }
}

#[test]
fn header_that_nothing_asks_for_any_more_is_stray() {
    let project = arm();
    project.replace("kane.toml", "abi = \"c\"\n", "");
    let stray = ["arm.h", "arm_c.rs"].map(|file| {
        format!(
            "generated/{file} is produced by nothing in kane.toml, or another kane.toml writes here: remove it, or give its system `abi = \"c\"`\n"
        )
    });
    let ran = project.kane(&["check"]);
    assert_eq!((ran.code, ran.out), (1, stray.concat()));
}

#[test]
fn option_is_in_the_command_that_is_printed() {
    let project = Project::generated();
    let ran = project.kane(&["check", "models/arm.toml", "--abi", "c"]);
    assert_eq!(
        (ran.code, ran.out.as_str()),
        (
            1,
            "generated/arm_c.rs is missing\n\
             generated/arm.h is missing\n\
             to bring this up to date, run: kane generate models/arm.toml --abi c\n"
        )
    );
}

#[test]
fn module_whose_name_c_cannot_have_is_refused_and_nothing_written() {
    let project = Project::arm();
    let files = project.files();
    let arguments = ["generate", "models/arm.toml", "--abi", "c", "--output"];
    let ran = project.kane(&[&arguments[..], &["my-arm.rs"]].concat());
    assert_eq!((ran.code, project.files()), (2, files));
    insta::assert_snapshot!(ran.err, @"error: the module is called `my-arm`; the files beside it contain that name: expected ASCII letters, digits and `_`, a letter first, and no keyword of Rust or header of C; nor `kane` for C");
}

/// A project with these systems of its model, each with its functions for C: modules and functions.
fn systems(all: [(&str, &str); 2]) -> Project {
    let project = Project::arm();
    let system = |(module, functions)| {
        format!(
            "[[system]]\nmodel = \"models/arm.toml\"\noutput = \"generated/{module}.rs\"\nfunctions = [{functions}]\nabi = \"c\"\n"
        )
    };
    project.write("kane.toml", &all.map(system).concat());
    project
}

#[test]
fn modules_that_declare_one_function_in_c_are_refused_and_nothing_written() {
    let project = systems([
        ("arm", "\"left_x = bias\""),
        ("arm_left", "\"x = mass_matrix\""),
    ]);
    let files = project.files();
    for command in ["generate", "check"] {
        let ran = project.kane(&[command]);
        assert_eq!((ran.code, project.files()), (2, files.clone()));
        insta::allow_duplicates! {
            insta::assert_snapshot!(ran.err, @r#"
            error: the modules `arm` and `arm_left` both declare `arm_left_x_f32` and 1 more in C
             --> kane.toml:8:10
              |
            3 | output = "generated/arm.rs"
              |          ------------------ the first one
            ...
            8 | output = "generated/arm_left.rs"
              |          ^^^^^^^^^^^^^^^^^^^^^^^ the second one
              |
              = help: names in C begin with that of the module: rename one file, or the function
            "#);
        }
    }
    // The same Rust without C is sound.
    project.replace("kane.toml", "abi = \"c\"\n", "");
    assert_eq!(project.kane(&["generate"]).code, 0);
}

#[test]
fn modules_that_declare_one_constant_in_c_are_refused() {
    let functions = "\"bias\"";
    let project = systems([("arm", functions), ("arm_q", functions)]);
    assert_eq!(project.kane(&["generate"]).code, 0);
    // A coordinate of the one is called as a size of the other.
    project.replace("models/arm.toml", "\"upper\"", "\"nb\"");
    project.replace("kane.toml", "arm_q.rs", "arm_body.rs");
    let ran = project.kane(&["generate"]);
    assert_eq!(ran.code, 2);
    let told = "error: the modules `arm` and `arm_body` both declare `ARM_BODY_NB` in C\n";
    assert!(ran.err.starts_with(told), "{}", ran.err);
}

#[test]
fn module_called_as_what_headers_share_is_refused_for_c_alone() {
    let functions = "\"load = bias\"";
    let project = systems([("arm", functions), ("kane", functions)]);
    let ran = project.kane(&["generate"]);
    assert_eq!(ran.code, 2);
    assert!(ran.err.contains("nor `kane` for C"), "{}", ran.err);
    project.replace("kane.toml", "abi = \"c\"\n", "");
    assert_eq!(project.kane(&["generate"]).code, 0);
}
