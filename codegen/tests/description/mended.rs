//! XML that readers of robots take though it is none: read with a warning, and every place is that of the text as it stands.

use kane_codegen::{
    description::{self, Description, Reading, urdf},
    diagnostic::{Severity, Source},
};

use crate::mjcf_support::{faults, number, parse, read};

const ARM: &str = "<mujoco><worldbody><body name=\"a\" pos=\"1 2 3\"><joint name=\"j\"/><geom size=\"1\"/></body></worldbody></mujoco>";

fn robot(text: &str) -> Description {
    urdf::parse(&Source::new("robot.urdf", text), &Reading::default())
}

/// The warnings, each with the text at its place.
fn warnings(description: &Description) -> Vec<(&str, &str)> {
    let source = description.source.text();
    let warnings = description.faults.iter();
    let warnings = warnings.filter(|fault| fault.severity == Severity::Warning);
    let shown = warnings.map(|fault| {
        let (span, _) = fault.labels[0];
        (fault.message.as_str(), &source[span.start..span.end])
    });
    shown.collect()
}

#[test]
fn valid_text_is_left_as_it_is() {
    let comment = "<?xml version=\"1.0\"?>\n<!-- a > b - c -->";
    let inside =
        "<!-- <x a=\"1\"b=\"2\"> --> text 'of' \"all\" kinds <![CDATA[<y a=\"1\"b=\"2\">--]]>";
    let text = ARM.replace("<joint", &format!("{inside}<joint"));
    assert!(
        read(&format!("{comment}{text}\n<!-- end -->\n"))
            .faults
            .is_empty()
    );
}

#[test]
fn attributes_without_space_between_them_are_read_where_they_stand() {
    let text = ARM
        .replace(" pos", "pos")
        .replace("size=\"1\"", "size=\"1\"mass='2'type=\"bal\"");
    let model = parse(&text, &[]);
    let message = "no space stands between two attributes";
    assert_eq!(
        warnings(&model),
        [(message, "p"), (message, "m"), (message, "t")]
    );
    let errors = model.faults.iter().find(|fault| fault.is_error());
    let (span, _) = errors
        .map(|fault| fault.labels[0].clone())
        .expect("a type is wrong");
    assert_eq!(&text[span.start..span.end], "bal");
    let model = read(&text.replace("type=\"bal\"", ""));
    assert_eq!(number(model.bodies[0].mass), 2.0);
    assert_eq!(number(model.bodies[0].joint.attachment[1]), 2.0);
}

#[test]
fn text_outside_the_root_element_is_left_out() {
    let model = parse(&format!("before\n{ARM} after </x>"), &[]);
    let message = "text outside the root element is left out";
    assert_eq!(
        warnings(&model)[..2],
        [(message, "before"), (message, "after")]
    );
    assert!(!read(&format!("{ARM} after")).bodies.is_empty());
}

#[test]
fn hyphens_in_comments_do_no_harm() {
    let model = read(&ARM.replace("<joint", "<!-- a -- b ---><joint"));
    assert_eq!(warnings(&model), [("a comment holds `--`", " a -- b -")]);
    assert_eq!(model.bodies.len(), 1);
}

#[test]
fn late_declaration_and_undeclared_prefixes_are_read_in_both_formats() {
    let late = "\n<!-- first -->\n<?xml version=\"1.0\"?>\n";
    let model = read(&format!(
        "{late}{}",
        ARM.replace("<joint", "<d:x d:y=\"1\"/><joint")
    ));
    let text = format!(
        "{late}<robot name=\"r\"><drake:p a=\"1\"/><link name=\"a\"/><drake:q e:b=\"2\"/>\n<link name=\"b\" c:d=\"1\"/></robot>"
    );
    let robot = robot(&text);
    for (description, prefixes) in [(&model, &["d"][..]), (&robot, &["c", "drake", "e"][..])] {
        let told = warnings(description);
        let declaration = (
            "the XML declaration does not stand first",
            "<?xml version=\"1.0\"?>",
        );
        assert_eq!(told[0], declaration, "{}", faults(description));
        let undeclared: Vec<&str> = told
            .iter()
            .filter(|(message, _)| message.ends_with("is not declared"))
            .map(|(_, shown)| *shown)
            .collect();
        assert_eq!(undeclared, prefixes);
        assert!(told.iter().all(|(message, _)| !message.contains("xmlns")));
    }
    let unknown = warnings(&robot);
    assert!(
        unknown.contains(&("unknown attribute `c:d` of link `b`", "c:d")),
        "{unknown:?}"
    );
}

#[test]
fn declared_prefix_is_not_told() {
    let text = "<robot name=\"r\" xmlns:d=\"u\"><d:p/><link name=\"a\"/></robot>";
    let robot = robot(text);
    assert!(
        warnings(&robot)
            .iter()
            .all(|(message, _)| !message.contains("declared"))
    );
}

#[test]
fn what_cannot_be_mended_is_still_told_where_it_stands() {
    let text = ARM
        .replace(" pos", "pos")
        .replace("<geom", "<geom name=\"a\"name=\"b\"");
    let model = parse(&text, &[]);
    let fault = model.faults.iter().find(|fault| fault.is_error());
    let fault = fault.expect("an attribute is given twice");
    assert_eq!(
        fault.message,
        "not valid XML: the attribute `name` is given twice"
    );
    let (span, _) = fault.labels[0];
    assert_eq!(
        (&text[span.start..span.end], span.start),
        ("name", text.rfind("name=\"b\"").expect("it is there"))
    );
}

#[test]
fn nested_include_is_looked_for_beside_the_main_file_and_then_beside_the_one_that_includes_it() {
    let text = "<mujoco><include file=\"parts/one.xml\"/></mujoco>";
    let one = "<mujoco><worldbody><include file=\"two.xml\"/></worldbody></mujoco>";
    let two = |name: &str| format!("<mujoco><body name=\"{name}\"/></mujoco>");
    let beside = parse(
        text,
        &[("parts/one.xml", one), ("parts/two.xml", &two("near"))],
    );
    let both = [
        ("parts/one.xml", one),
        ("parts/two.xml", &*two("near")),
        ("two.xml", &*two("main")),
    ];
    let main = parse(text, &both);
    for (model, name) in [(beside, "near"), (main, "main")] {
        let named = model.bodies[0]
            .name
            .as_ref()
            .map(|name| name.value.as_str());
        assert_eq!(named, Some(name), "{}", faults(&model));
    }
    let circle = one.replace("two", "one");
    let model = parse(text, &[("parts/one.xml", &circle)]);
    let messages: Vec<&str> = model
        .faults
        .iter()
        .map(|fault| fault.message.as_str())
        .collect();
    assert_eq!(messages, ["`one.xml` includes itself"]);
}

#[test]
fn a_model_that_git_lfs_has_not_fetched_is_told_as_such() {
    let pointer = "version https://git-lfs.github.com/spec/v1\noid sha256:656b\nsize 2197848\n";
    for name in ["robot.toml", "robot.urdf", "robot.xml"] {
        let source = Source::new(name, pointer);
        let none = |_: &str| Err(std::io::ErrorKind::NotFound.into());
        let faults = description::read(&source, &Reading::default(), &none).faults;
        let messages: Vec<&str> = faults.iter().map(|fault| fault.message.as_str()).collect();
        assert_eq!(
            messages,
            ["this is a Git LFS pointer, not the file"],
            "{name}"
        );
        assert_eq!(faults[0].help.as_deref(), Some("run `git lfs pull`"));
    }
    let text = "<mujoco><include file=\"one.xml\"/></mujoco>";
    let faults = parse(text, &[("one.xml", pointer)]).faults;
    assert_eq!(faults[0].message, "this is a Git LFS pointer, not the file");
}

#[test]
fn xml_under_another_ending_is_told_which_endings_there_are() {
    let faults_of = |name: &str, text: &str| {
        let source = Source::new(name, text);
        let none = |_: &str| Err(std::io::ErrorKind::NotFound.into());
        let description = description::read(&source, &Reading::default(), &none);
        description
            .faults
            .iter()
            .map(|fault| fault.message.clone() + fault.help.as_deref().unwrap_or_default())
            .collect::<String>()
    };
    let faults = |name: &str| faults_of(name, "<sdf version=\"1.9\"/>");
    assert!(
        faults("robot.world").contains("a model in XML is a URDF, in a file that ends in `.urdf`")
    );
    assert!(faults("robot.sdf").contains("`.sdf` is no model"));
    for name in ["robot.yaml", "./robots.v2/robot.stp"] {
        let told = faults_of(name, "robot: arm");
        assert!(told.contains("is no model; a model ends in"), "{told}");
    }
    let told = faults_of("./robots.v2/robot", "robot: arm");
    assert!(!told.contains("is no model"), "{told}");
    assert!(faults("robot.xacro").contains("expected `robot`"));
    let told = faults_of("robot.urdf", "<mujoco/>");
    assert!(told.contains("end the file's name in `.xml`"), "{told}");
}
