//! What is wrong is said, and nothing of what only follows from it.

use kane_codegen::{description::Reading, diagnostic::Severity, tree};

use super::{joint_element, link_element, parse, robot};

/// The errors of a robot, each by its first line.
fn errors(text: &str) -> Vec<String> {
    let faults = tree::build(&parse(text, &Reading::default())).expect_err("it is wrong");
    let errors = faults.list().iter();
    let errors = errors.filter(|fault| fault.severity == Severity::Error);
    errors.map(|fault| fault.message.clone()).collect()
}

#[test]
fn a_misspelt_child_is_all_that_is_wrong() {
    let text = robot(&[
        ("one", "continuous", "base", "upper", ""),
        ("two", "continuous", "upper", "lower", ""),
    ]);
    let text = text.replace("child link=\"lower\"", "child link=\"lover\"");
    assert_eq!(
        errors(&text),
        ["`child` of joint `two` is link `lover`, which is not defined"]
    );
}

#[test]
fn several_roots_are_all_that_is_wrong() {
    let joint = joint_element("root_joint", "continuous", ["a", "b"], "");
    let links = ["a", "b", "c", "d"].map(link_element).concat();
    let found = errors(&format!("<robot name=\"r\">{links}{joint}</robot>"));
    assert!(
        matches!(&found[..], [only] if only.starts_with("the robot has 3 root links")),
        "{found:?}"
    );
}

#[test]
fn a_base_that_is_free_is_proposed_where_nothing_moves() {
    let description = parse(&robot(&[("j", "fixed", "a", "b", "")]), &Reading::default());
    let faults = tree::build(&description).expect_err("nothing moves");
    let help = faults.list()[0].help.as_deref().unwrap_or_default();
    assert!(help.contains("`--base free`"), "{faults}");
}

#[test]
fn numbers_that_xacro_or_a_space_would_mend_are_told_so() {
    for (number, advice) in [
        ("${length} 0 0", "expand the file first"),
        ("${length}", "expand the file first"),
        ("0,0,1", "without commas"),
        ("0, 0, 1", "without commas"),
    ] {
        let joint = format!("<origin xyz=\"{number}\"/>");
        let text = robot(&[("j", "continuous", "a", "b", &joint)]);
        let faults = tree::build(&parse(&text, &Reading::default())).expect_err("no number");
        let help = faults.list()[0].help.as_deref().unwrap_or_default();
        assert!(help.contains(advice), "{faults}");
    }
}

#[test]
fn elements_of_xacro_that_were_to_become_others_are_refused_wherever_they_count() {
    let found = |inside: &str| errors(&robot(&[("j", "continuous", "a", "b", inside)]));
    let left = |name: &str| [format!("`{name}` is no element of a URDF")];
    let block = "<insert_block name=\"origin\"/>";
    assert_eq!(found(block), left("insert_block"));
    for name in ["xacro:insert_block", "xacro:if", "xacro:unless"] {
        let element = format!("<{name} xmlns:xacro=\"x\"><limit/></{name}>");
        assert_eq!(found(&element), left(name));
        let in_axis = format!("<axis xyz=\"0 0 1\">{element}</axis>");
        assert_eq!(found(&in_axis), left(name));
        // Whatever a joint looks like, it moves as it does.
        let seen = found(&format!("<gazebo>{element}</gazebo>"));
        assert_eq!(seen, found(""));
    }
    assert_eq!(found(&format!("<origin xyz=\"0 0 1\"/>{block}")), found(""));
    let property = "<xacro:property xmlns:xacro=\"x\" name=\"p\" value=\"1\"/>";
    assert_eq!(found(property), found(""));
}
