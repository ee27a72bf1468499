//! Snapping of rotations: what rounded right angles cost, and what the user is told.

#![expect(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use kane_codegen::description::{no_includes, urdf};
use kane_codegen::diagnostic::Source;
use kane_codegen::generate::{Generated, generate};
use kane_codegen::geometry::IDENTITY;
use kane_codegen::options::Options;
use kane_codegen::rounded_angles;
use kane_codegen::tree::{Alignment, Changes};

/// An arm of three links whose joints are turned by a right angle, written with these digits.
fn arm(right_angle: &str) -> String {
    let link = |name: &str| {
        format!(
            "<link name=\"{name}\"><inertial><origin xyz=\"0.1 0.2 0.3\" rpy=\"0 0 {right_angle}\"/><mass value=\"2\"/>\
             <inertia ixx=\"0.1\" ixy=\"0.01\" ixz=\"0.02\" iyy=\"0.2\" iyz=\"0.03\" izz=\"0.25\"/></inertial></link>\n"
        )
    };
    let joint = |name: &str, parent: &str, child: &str, rpy: &str| {
        format!(
            "<joint name=\"{name}\" type=\"continuous\"><parent link=\"{parent}\"/><child link=\"{child}\"/>\
             <origin xyz=\"0 0.1 0.5\" rpy=\"{rpy}\"/><axis xyz=\"0 0 1\"/></joint>\n"
        )
    };
    [
        "<robot name=\"arm\">\n<link name=\"base\"/>\n".to_owned(),
        link("a"),
        link("b"),
        link("c"),
        joint("one", "base", "a", "0 0 0"),
        joint("two", "a", "b", &format!("{right_angle} 0 0")),
        joint("three", "b", "c", &format!("-{right_angle} 0 0")),
        "</robot>\n".to_owned(),
    ]
    .concat()
}

fn generated(right_angle: &str, snap: f64) -> Generated {
    let options = Options {
        changes: Changes {
            snap,
            ..Changes::default()
        },
        ..Options::default()
    };
    let source = Source::new("arm.urdf", arm(right_angle));
    generate(&source, "arm.urdf", &options, &no_includes).unwrap()
}

/// The operations of inverse dynamics, and what was said of snapping.
fn cost(right_angle: &str, snap: f64) -> (usize, String) {
    let generated = generated(right_angle, snap);
    let (_, operations) = generated
        .functions
        .iter()
        .find(|(name, _)| *name == "inverse_dynamics")
        .unwrap();
    let said = generated.warnings.list().iter();
    let said = said
        .filter(|finding| finding.message.contains("made exact"))
        .map(|finding| finding.message.clone());
    (operations.total(), said.collect())
}

#[test]
fn ten_digits_of_a_right_angle_are_exact_by_default() {
    let exact = cost("1.5707963267948966", 1e-9).0;
    let (rounded, said) = cost("1.57079632679", 1e-9);
    assert_eq!(rounded, exact);
    insta::assert_snapshot!(said, @"entries of constant rotations and axes nearer than 1e-9 to 0, 1 or -1 were made exact, which changed none by more than 4.9e-12: `inertia_rotation` of `a`, `inertia_rotation` of `b`, `attachment_rotation` of `b`, `inertia_rotation` of `c`, `attachment_rotation` of `c`");
}

#[test]
fn four_digits_of_a_right_angle_are_exact_where_asked_for() {
    let exact = cost("1.5707963267948966", 1e-9).0;
    let crumbs = cost("1.5708", 1e-9).0;
    assert_eq!(cost("1.5708", 1e-5).0, exact);
    assert!(
        crumbs > exact,
        "{crumbs} operations with crumbs, {exact} without"
    );
}

#[test]
fn nothing_is_snapped_at_zero() {
    let (operations, said) = cost("1.5707963267948966", 0.0);
    assert!(said.is_empty(), "{said}");
    assert!(operations > cost("1.5707963267948966", 1e-9).0);
}

#[test]
fn an_axis_beside_a_coordinate_axis_stays_as_it_is_beyond_the_tolerance() {
    // Of length 1 to the last digit, and along no coordinate axis.
    let axis = [1.4e-8, 0.0, 1.0];
    let (exact, change) = Alignment::of(axis, 1e-9);
    assert_eq!((exact.place, change), (2, 0.0));
    assert_eq!(exact.rotation[2], axis);
    let (snapped, change) = Alignment::of(axis, 1e-7);
    assert_eq!((snapped.rotation, snapped.place), (IDENTITY, 2));
    assert!(change > 1.3e-8, "{change}");
}

#[test]
fn the_tolerance_stands_in_the_banner() {
    for (snap, shown) in [
        (1e-5, "snap: 1e-5"),
        (1e-9, "snap: 1e-9"),
        (0.0, "snap: 0.0"),
    ] {
        let source = generated("1.5708", snap).source;
        let banner = source.lines().nth(1).unwrap();
        assert!(banner.contains(shown), "{banner}");
    }
}

/// What is said of rounded angles, of the functions by default.
fn advice(robot: &str, snap: f64) -> Option<String> {
    let options = Options {
        changes: Changes {
            snap,
            ..Changes::default()
        },
        ..Options::default()
    };
    let source = Source::new("arm.urdf", robot);
    let description = urdf::parse(&source, &options.reading);
    let note = rounded_angles::note(&description, &options, None)?;
    Some(note.list()[0].message.clone())
}

#[test]
fn what_rounded_right_angles_cost_is_told_with_the_tolerance_that_saves_it() {
    insta::assert_snapshot!(advice(&arm("1.5708"), 1e-9).unwrap());
    insta::assert_snapshot!(advice(&arm("1.57079632"), 0.0).unwrap());
}

#[test]
fn the_parts_that_are_told_are_those_of_the_operations_that_are_needed() {
    let functions = |snap: f64| generated("1.5708", snap).functions;
    let (before, after) = (functions(1e-9), functions(1e-5));
    let told = advice(&arm("1.5708"), 1e-9).unwrap();
    let parts = before.iter().zip(&after).map(|((name, old), (_, new))| {
        let (old, new) = (old.total(), new.total());
        #[expect(clippy::cast_precision_loss, reason = "there are few operations")]
        let percent = 100.0 * (old - new) as f64 / old.max(1) as f64;
        (percent, format!("{percent:.0} % of `{name}`"))
    });
    let mut parts: Vec<(f64, String)> = parts.filter(|(percent, _)| *percent >= 0.5).collect();
    parts.sort_by(|(a, _), (b, _)| b.total_cmp(a));
    let shown: Vec<&str> = parts
        .iter()
        .take(3)
        .map(|(_, text)| text.as_str())
        .collect();
    assert!(
        told.contains(&format!(
            "saves {} and {} more, ",
            shown.join(", "),
            parts.len() - 3
        )),
        "{told}"
    );
}

#[test]
fn nothing_is_told_where_nothing_is_saved() {
    // Exact already, taken already, and too far off to be a right angle.
    for (right_angle, snap) in [
        ("1.5707963267948966", 1e-9),
        ("1.5708", 1e-5),
        ("1.56", 1e-9),
    ] {
        assert_eq!(
            advice(&arm(right_angle), snap),
            None,
            "{right_angle} {snap}"
        );
    }
    // A ball's inertia is the same about all axes, and its mass centre is where it was.
    let ball = "<robot name=\"r\"><link name=\"base\"/><link name=\"a\"><inertial><origin xyz=\"0 0 1\" rpy=\"1.5708 0 0\"/>\
        <mass value=\"1\"/><inertia ixx=\"1\" iyy=\"1\" izz=\"1\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>\
        <joint name=\"j\" type=\"continuous\"><parent link=\"base\"/><child link=\"a\"/></joint></robot>";
    assert_eq!(advice(ball, 1e-9), None);
    // Of what was made exact there, nothing is said either.
    let ball = ball.replace("1.5708", "1.57079632679");
    let options = Options::default();
    let source = Source::new("ball.urdf", ball);
    let warnings = generate(&source, "ball.urdf", &options, &no_includes)
        .unwrap()
        .warnings;
    assert!(!warnings.to_string().contains("made exact"), "{warnings}");
}
