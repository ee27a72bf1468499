//! Outputs that are links.

use std::{fs, os::unix::fs::symlink};

use super::project::Project;

#[test]
fn link_to_a_module_stays_one() {
    let project = Project::arm();
    project.write("elsewhere/here", "");
    fs::create_dir_all(project.path("generated")).unwrap();
    let asked = [
        "generate",
        "models/arm.toml",
        "--output",
        "elsewhere/real.rs",
    ];
    assert_eq!(project.kane(&asked).code, 0);
    let link = project.path("generated/arm.rs");
    symlink("../elsewhere/real.rs", &link).unwrap();
    project.replace("models/arm.toml", "mass = 1.5\n", "mass = 1.25\n");
    let ran = project.kane(&["generate"]);
    assert_eq!(ran.told(), "wrote generated/arm.rs\n");
    assert!(link.is_symlink());
    assert_eq!(project.kane(&["check"]).code, 0);
}
