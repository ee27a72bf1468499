//! `kane check` of files that another tool formatted.

use super::project::Project;

#[test]
fn file_that_was_formatted_anew_is_told_from_one_that_changed() {
    let project = Project::generated();
    let layout_only = "differs in layout only";
    project.replace(
        "generated/arm.rs",
        "pub const NB: usize",
        "pub  const  NB :usize",
    );
    let ran = project.kane(&["check"]);
    assert_eq!(
        (ran.code, ran.out.contains(layout_only)),
        (1, true),
        "{}",
        ran.out
    );
    project.replace("models/arm.toml", "mass = 1.5", "mass = 1.25");
    let ran = project.kane(&["check"]);
    assert_eq!(
        (ran.code, ran.out.contains(layout_only)),
        (1, false),
        "{}",
        ran.out
    );
}

#[test]
fn spaces_in_strings_and_files_that_are_no_rust_are_not_told_as_formatted_anew() {
    let project = Project::arm();
    let config = project.read("kane.toml");
    project.write("kane.toml", &format!("{config}manifest = true\n"));
    assert_eq!(project.kane(&["generate"]).code, 0);
    let told = |file: &str, from: &str, to: &str| {
        let text = project.read(file);
        project.replace(file, from, to);
        let told = project.kane(&["check"]).out;
        project.write(file, &text);
        let first = told.lines().next().unwrap_or_default();
        let is_layout = first.ends_with("; only the layout changed");
        (is_layout, told.contains("rustfmt"))
    };
    let module = "generated/arm.rs";
    assert_eq!(told(module, " = \"arm\"", "  = \"arm\""), (true, true));
    assert_eq!(told(module, " = \"arm\"", " = \"arm \""), (false, false));
    let manifest = "generated/arm.json";
    assert_eq!(told(manifest, ": {", ":{"), (true, false));
}
