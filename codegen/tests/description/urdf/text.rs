//! Any text: places are right, no depth is too great, and no file stops the program.

use std::path::Path;

use kane_codegen::description::{Reading, urdf};
use kane_codegen::diagnostic::{Diagnostics, Severity, Source};

use super::{body_names, joint_element, link_element, lower_bodies, parse, parse_well, robot};
use kane_test_support::random::Random;

#[test]
fn without_a_tree_every_link_is_still_a_body_to_be_checked() {
    let text = robot(&[
        ("j", "continuous", "a", "b", ""),
        ("k", "continuous", "c", "d", ""),
    ]);
    let description = parse(&text, &Reading::default());
    assert!(description.lower_bodies.is_none());
    assert_eq!(body_names(&description), ["a", "b", "c", "d"]);
    let errors = description.faults.iter();
    let errors = errors.filter(|fault| fault.severity == Severity::Error);
    assert_eq!(errors.count(), 1);
}

#[test]
fn chain_may_be_long() {
    let n = 9_999;
    let mut text = String::from("<robot name=\"chain\"><link name=\"l0\"/>");
    for k in 1..=n {
        let (lower, link) = (format!("l{}", k - 1), format!("l{k}"));
        text += &link_element(&link);
        text += &joint_element(&format!("j{k}"), "fixed", [&lower, &link], "");
    }
    let text = text + "</robot>";
    let description = parse_well(&text, &Reading::default());
    assert!(lower_bodies(&description).into_iter().eq(0..=n));
    // The same as a ring: one fault, of which the message is not as long as the ring.
    let ring = text.replace("<parent link=\"l0\"/>", &format!("<parent link=\"l{n}\"/>"));
    let faults = parse(&ring, &Reading::default()).faults;
    let cycle = faults
        .iter()
        .find(|fault| fault.severity == Severity::Error);
    assert!(cycle.expect("it is no tree").message.contains("9990 more"));
}

/// The first fault that is an error, as it is shown.
fn first_error(text: &str) -> String {
    let source = Source::new("robot.urdf", text);
    let mut faults = urdf::parse(&source, &Reading::default()).faults;
    faults.retain(|fault| fault.severity == Severity::Error);
    faults.truncate(1);
    Diagnostics::new(source, faults).to_string()
}

#[test]
fn places_are_those_of_the_file_whatever_xml_makes_of_the_text() {
    let shown = |origin: &str| {
        let text = robot(&[("gelenkkörper", "fixed", "a", "b", origin)]);
        let place = |text: &str| {
            let shown = first_error(text);
            let line = shown
                .lines()
                .find_map(|l| l.trim_start().strip_prefix("--> "));
            line.map(str::to_owned)
        };
        let unix = place(&text);
        assert_eq!(unix, place(&text.replace('\n', "\r\n")), "{origin}");
        assert_eq!(unix, place(&format!("\u{feff}{text}")), "{origin}");
        unix.expect("it has a place")
    };
    assert_eq!(shown("<origin xyz='0 x 0'/>"), "robot.urdf:4:91");
    assert_eq!(shown("<origin xyz = \"0\t x 0\"/>"), "robot.urdf:4:94");
    assert_eq!(shown("\n<origin\nxyz='0 x 0'/>"), "robot.urdf:6:8");
    // With an entity, words are no longer where they seem: the whole value is shown.
    assert_eq!(shown("<origin xyz='&#48; x 0'/>"), "robot.urdf:4:89");
    // Faults of the XML itself.
    assert_eq!(shown("<origin xyz='0 x <'/>"), "robot.urdf:4:93");
    assert_eq!(shown("<!--ö--><origin ö='1' ö='2'/>"), "robot.urdf:4:98");
}

#[test]
fn entities_stand_for_their_characters() {
    let text = "<robot name='&lt;a&amp;&#x62;&gt;'><link name='a'/></robot>";
    let description = parse_well(text, &Reading::default());
    assert_eq!(description.name.expect("it has one").value, "<a&b>");
}

#[test]
fn names_with_a_prefix_are_other_names() {
    let text = "<robot name='r' xmlns='urn:u' xmlns:x='urn:x'><link name='a' x:name='b'/><x:link name='c'/></robot>";
    let description = parse(text, &Reading::default());
    assert_eq!(body_names(&description), ["a"]);
    let warnings: Vec<&str> = description
        .faults
        .iter()
        .map(|fault| fault.message.as_str())
        .collect();
    assert!(
        warnings.contains(&"unknown attribute `x:name` of link `a`"),
        "{warnings:?}"
    );
    assert!(
        warnings.contains(&"unknown element `x:link` of the robot"),
        "{warnings:?}"
    );
}

#[test]
fn no_file_stops_the_program() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/invalid/urdf");
    let mut files: Vec<_> = std::fs::read_dir(folder)
        .expect("the folder is in the repository")
        .map(|entry| entry.expect("a folder can be read to its end").path())
        .collect();
    files.sort();
    let mut random = Random::new(7);
    let pieces = [
        "<", ">", "\"", "'", "/", "&", "=", "ö", "-", "0", "e999", " ", "\r", "<!", "<?", "]]>",
        "name", "link", "\0",
    ];
    for file in files {
        let text = std::fs::read_to_string(file).expect("the file is there");
        let characters: Vec<char> = text.chars().collect();
        for _ in 0..60 {
            let mut broken: Vec<char> = characters.clone();
            for _ in 0..=random.below(3) {
                let at = random.below(broken.len() + 1);
                let end = (at + random.below(12)).min(broken.len());
                let piece = pieces[random.below(pieces.len())];
                broken.splice(at..end, piece.chars());
            }
            let broken: String = broken.into_iter().collect();
            let source = Source::new("robot.urdf", broken);
            let description = urdf::parse(&source, &Reading::default());
            let faults = Diagnostics::new(source, description.faults);
            assert!(!faults.to_string().is_empty());
        }
    }
}

#[test]
fn elements_may_be_nested_deeply() {
    let n = 100_000;
    let text = format!(
        "<robot name=\"a\"><link name=\"a\"><visual>{}{}</visual></link></robot>",
        "<x>".repeat(n),
        "</x>".repeat(n)
    );
    assert_eq!(body_names(&parse_well(&text, &Reading::default())), ["a"]);
}
