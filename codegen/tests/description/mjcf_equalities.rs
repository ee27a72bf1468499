//! Equalities of MJCF: joints that they tie move as MuJoCo's do on the states that obey them; others are refused, or left out.
#![allow(
    clippy::unwrap_used,
    reason = "the tests' own functions, which clippy takes for others"
)]

use std::{collections::BTreeMap, fs};

use kane_codegen::{
    description::{Description, JointKind, Reading, mjcf, no_includes},
    diagnostic::{Severity, Source},
    expr::Input,
    functions::{Argument, Formulation, Parsed},
    recursive::Plan,
    tree::{self, Tree},
};
use kane_test_support::{
    compare::{Tolerance, assert_close},
    json::flat,
};
use serde_json::Value;

use crate::mjcf_support::{faults, number, parse};

fn leaving_out(text: &str, names: &[&str]) -> Description {
    let reading = Reading {
        leave_out: names.iter().map(|name| (*name).to_owned()).collect(),
        ..Reading::default()
    };
    mjcf::parse(&Source::new("model.xml", text), &reading, &no_includes)
}

fn file(name: &str) -> String {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/mjcf_equalities");
    fs::read_to_string(format!("{folder}/{name}")).unwrap()
}

/// Two hinges and a slide, and these equalities.
fn tied(equalities: &str) -> String {
    format!(
        "<mujoco><worldbody>
  <body name=\"m\" mocap=\"true\"><site name=\"s\"/></body>
  <body name=\"one\"><joint name=\"a\" ref=\"90\"/><geom size=\"1\"/></body>
  <body name=\"two\"><joint name=\"b\"/><geom size=\"1\" pos=\"1 0 0\"/></body>
  <body name=\"three\"><joint name=\"c\" type=\"slide\" ref=\"0.5\"/><geom size=\"1\"/></body>
</worldbody><equality>{equalities}</equality></mujoco>"
    )
}

fn errors(description: &Description) -> Vec<&str> {
    let faults = description.faults.iter();
    let errors = faults.filter(|fault| fault.is_error());
    errors.map(|fault| fault.message.as_str()).collect()
}

/// Of each joint that follows: itself, its leader, factor and offset.
fn mimics(description: &Description) -> Vec<(&str, &str, f64, f64)> {
    let joints = description.bodies.iter().map(|body| &body.joint);
    let mimics = joints.filter_map(|joint| {
        let mimic = &joint.mimic.as_ref()?.value;
        let name = &joint.name.as_ref()?.value;
        Some((&**name, &*mimic.joint.value, mimic.multiplier, mimic.offset))
    });
    mimics.collect()
}

fn evaluate(tree: &Tree, function: &str, inputs: &BTreeMap<Input, f64>) -> Vec<f64> {
    let request = Parsed::read(function).unwrap().on(tree).unwrap();
    let derived = request.derive(tree, Formulation::Recursive, &Plan::full(tree));
    derived
        .graph
        .evaluate(&derived.roots, |given| inputs[&given])
}

#[test]
fn tied_joints_move_as_mujocos_on_the_states_that_obey_the_equalities() {
    let description = leaving_out(&file("tied.xml"), &["fluid", "tendons", "loop"]);
    assert_eq!(errors(&description), [""; 0], "{}", faults(&description));
    let tree = tree::build(&description).unwrap().tree;
    assert_eq!(tree.n_speeds, 2);
    let states: Value = serde_json::from_str(&file("reference.json")).unwrap();
    let states = states.as_array().unwrap();
    assert_eq!(states.len(), 4);
    for state in states {
        let mut inputs = BTreeMap::new();
        inputs.extend(Argument::Q.inputs(&tree).zip(flat(&state["q"])));
        inputs.extend(Argument::U.inputs(&tree).zip(flat(&state["u"])));
        for function in ["mass_matrix", "bias"] {
            let found = evaluate(&tree, function, &inputs);
            let tolerance = Tolerance::relative_beyond(1.0, 1e-12);
            assert_close(function, &found, &flat(&state[function]), tolerance);
        }
    }
}

#[test]
fn displacements_are_counted_from_the_reference_pose() {
    let right = std::f64::consts::FRAC_PI_2;
    let text = tied(
        "<joint joint1=\"a\" joint2=\"c\" polycoef=\"0.25 2\"/><joint joint1=\"b\" joint2=\"c\"/>",
    );
    let model = parse(&text, &[]);
    assert_eq!(errors(&model), [""; 0]);
    let expected = [("a", "c", 2.0, right + 0.25 - 1.0), ("b", "c", 1.0, -0.5)];
    assert_eq!(mimics(&model), expected);
    let notes = model.faults.iter().filter(|f| f.severity == Severity::Note);
    assert_eq!(notes.count(), 2);
}

#[test]
fn second_equality_of_a_joint_ties_the_other_one() {
    let text = tied(
        "<joint joint1=\"b\" joint2=\"a\"/><joint joint1=\"b\" joint2=\"c\" polycoef=\"1 4\"/>",
    );
    let model = parse(&text, &[]);
    let right = std::f64::consts::FRAC_PI_2;
    let expected = [("b", "a", 1.0, -right), ("c", "b", 0.25, 0.5 - 0.25)];
    assert_eq!(mimics(&model), expected);
    let held = tied("<joint joint1=\"b\" joint2=\"a\"/><joint joint1=\"b\"/>");
    let model = parse(&held, &[]);
    assert_eq!(
        errors(&model),
        ["a joint equality ties joint `b`, which another one ties already"]
    );
}

#[test]
fn joint_alone_is_held_and_what_follows_it_too() {
    let text = tied(
        "<joint joint1=\"c\" joint2=\"b\" polycoef=\"0 3\"/><joint joint1=\"b\" polycoef=\"0.1 5\"/>",
    );
    let model = parse(&text, &[]);
    assert_eq!(errors(&model), [""; 0]);
    let [_, one, two, three] = &model.bodies[..] else {
        unreachable!("there are four")
    };
    let kind =
        |body: &kane_codegen::description::WrittenBody| body.joint.kind.clone().unwrap().value;
    assert_eq!(kind(one), JointKind::Revolute);
    assert_eq!(
        (kind(two), kind(three)),
        (JointKind::Fixed, JointKind::Fixed)
    );
    // From the reference pose, whatever its coordinate is there.
    assert_close(
        "slide",
        &[number(three.joint.attachment[2])],
        &[3.0 * 0.1],
        Tolerance::relative_beyond(1.0, 1e-15),
    );
    let turn = two.joint.attachment_rotation.unwrap().value;
    assert_eq!(turn[0][1], libm::sin(0.1));
}

#[test]
fn ends_that_are_no_hinge_or_slide_are_refused() {
    let ball = tied("<joint joint1=\"b\" joint2=\"d\"/><joint joint1=\"x\"/>").replace(
        "</worldbody>",
        "<body><joint name=\"d\" type=\"ball\"/><geom size=\"1\"/></body></worldbody>",
    );
    assert_eq!(
        errors(&parse(&ball, &[])),
        [
            "a joint equality ties `d`, which is no hinge and no slide",
            "a joint equality ties `x`, which is no joint"
        ]
    );
}

#[test]
fn ties_to_motion_capture_are_left_out_with_a_warning() {
    for end in [
        "weld body1=\"m\" body2=\"one\"",
        "weld body1=\"one\" body2=\"m\"",
        "connect site1=\"s\" site2=\"t\"",
    ] {
        let model = parse(&tied(&format!("<{end}/>")), &[]);
        assert_eq!(errors(&model), [""; 0], "{end}");
        let warnings = model.faults.iter();
        let warned = warnings.filter(|fault| fault.message.ends_with("motion capture is left out"));
        assert_eq!(warned.count(), 1, "{end}");
    }
    let model = parse(&tied("<weld body1=\"one\" body2=\"two\"/>"), &[]);
    assert_eq!(errors(&model).len(), 1);
}

#[test]
fn bodies_that_follow_motion_capture_are_known_by_the_names_of_their_copies() {
    let text = |end: &str| {
        format!(
            "<mujoco><worldbody><replicate count=\"2\" offset=\"1 0 0\">
  <body name=\"m\" mocap=\"true\"><site name=\"s\"/></body></replicate>
  <body name=\"m\"><joint name=\"a\"/><geom size=\"1\"/></body>
  <body name=\"z\"><joint name=\"b\"/><geom size=\"1\"/></body>
</worldbody><equality>{end}</equality></mujoco>"
        )
    };
    for (end, n_errors) in [
        ("<weld body1=\"z\" body2=\"m0\"/>", 0),
        ("<connect site1=\"s1\" site2=\"t\"/>", 0),
        ("<weld body1=\"z\" body2=\"m\"/>", 1),
    ] {
        assert_eq!(errors(&parse(&text(end), &[])).len(), n_errors, "{end}");
    }
}

#[test]
fn ties_that_say_the_same_are_one() {
    let first = "<joint joint1=\"a\" joint2=\"b\" polycoef=\"0 2 0 0 0\"/>";
    for (second, n_errors) in [
        (first, 0),
        (
            "<joint joint1=\"b\" joint2=\"a\" polycoef=\"0 0.5 0 0 0\"/>",
            0,
        ),
        (
            "<joint joint1=\"b\" joint2=\"a\" polycoef=\"0 2 0 0 0\"/>",
            1,
        ),
        (
            "<joint joint1=\"a\" joint2=\"b\" polycoef=\"1 2 0 0 0\"/>",
            1,
        ),
    ] {
        let model = parse(&tied(&format!("{first}{second}")), &[]);
        assert_eq!(errors(&model).len(), n_errors, "{second}");
        let [(joint, leader, ..)] = mimics(&model)[..] else {
            panic!("{second}: one joint follows");
        };
        assert_eq!((joint, leader), ("a", "b"));
    }
}

#[test]
fn user_leaves_out_all_equalities_a_kind_or_one() {
    let text = tied(
        "<connect name=\"x\" body1=\"one\"/><connect body1=\"two\"/><joint joint1=\"a\" joint2=\"b\"/>",
    );
    for (names, n_errors, n_mimics) in [
        (&[][..], 2, 1),
        (&["x"][..], 1, 1),
        (&["connect"][..], 0, 1),
        (&["equalities"][..], 0, 0),
    ] {
        let model = leaving_out(&text, names);
        assert_eq!(errors(&model).len(), n_errors, "{names:?}");
        assert_eq!(mimics(&model).len(), n_mimics, "{names:?}");
    }
    let model = leaving_out(&text, &["connect", "y"]);
    assert_eq!(errors(&model), ["there is no equality `y` to leave out"]);
    let model = leaving_out(&text, &["connec"]);
    let helps: Vec<&str> = model
        .faults
        .iter()
        .filter_map(|fault| fault.help.as_deref())
        .collect();
    assert!(helps.contains(&"did you mean `connect`?"), "{helps:?}");
}

#[test]
fn user_leaves_out_forces_that_cannot_be_had() {
    let text = "<mujoco><option density=\"1\" viscosity=\"2\"/><worldbody>
        <body name=\"a\" gravcomp=\"1\"><joint name=\"j\"/><geom size=\"1\"/></body>
        <body><joint/><geom size=\"1\"/></body></worldbody>
      <tendon><fixed><joint joint=\"j\" coef=\"1\"/></fixed><fixed stiffness=\"1\" damping=\"2\"/></tendon></mujoco>";
    for (name, n_errors) in [("fluid", 2), ("tendons", 2), ("gravcomp", 4)] {
        let model = leaving_out(text, &[name]);
        assert_eq!(errors(&model).len(), n_errors, "{name}");
    }
    let model = leaving_out(text, &["fluid", "tendons", "gravcomp"]);
    assert_eq!(errors(&model), [""; 0]);
    let warnings = model.faults.iter();
    let told = warnings.filter(|fault| fault.severity == Severity::Warning && fault.kind.is_some());
    // Two of the fluid, two of the tendons, the section that held them, and one of the weight.
    assert_eq!(told.count(), 6);
}

#[test]
fn equalities_of_an_attached_model_hold_where_all_that_they_name_is_attached() {
    let child = "<mujoco><worldbody>
  <body name=\"root\"><joint name=\"a\" type=\"slide\"/><geom size=\"1\"/>
    <body name=\"tip\"><joint name=\"b\" type=\"slide\"/><geom size=\"1\"/></body>
  </body>
</worldbody><equality>
  <joint joint1=\"a\" joint2=\"b\" polycoef=\"0 2\"/>
  <weld body1=\"root\" body2=\"tip\" name=\"hold\"/>
</equality></mujoco>";
    let text = "<mujoco><asset><model name=\"m\" file=\"m.xml\"/></asset><worldbody>
  <replicate count=\"2\" offset=\"9 0 0\"><attach model=\"m\" body=\"root\" prefix=\"x_\"/></replicate>
  <attach model=\"m\" body=\"tip\" prefix=\"y_\"/>
</worldbody></mujoco>";
    let model = parse(text, &[("m.xml", child)]);
    assert_eq!(
        mimics(&model),
        [("x_a0", "x_b0", 2.0, 0.0), ("x_a1", "x_b1", 2.0, 0.0)]
    );
    let welds = ["x_hold0", "x_hold1"].map(|name| {
        format!("weld equality `{name}` is active; constraints like this are not supported")
    });
    assert_eq!(errors(&model), welds);
}

#[test]
fn equalities_hold_once_more_in_an_attached_part_that_holds_all_they_name() {
    let text = "<mujoco><worldbody>
  <body name=\"root\"><joint name=\"a\" type=\"slide\"/><geom size=\"1\"/>
    <body name=\"tip\"><joint name=\"b\" type=\"slide\"/><geom size=\"1\"/></body>
  </body>
  <body name=\"other\"><joint name=\"c\" type=\"slide\"/><geom size=\"1\"/>
    <attach body=\"root\" prefix=\"x_\"/></body>
  <body name=\"last\"><joint name=\"d\" type=\"slide\"/><geom size=\"1\"/>
    <attach body=\"other\" prefix=\"y_\"/></body>
</worldbody><equality>
  <joint joint1=\"a\" joint2=\"b\" polycoef=\"0 2\"/>
  <joint joint1=\"c\" joint2=\"d\"/>
</equality></mujoco>";
    let model = parse(text, &[]);
    assert_eq!(errors(&model), [""; 0]);
    assert_eq!(
        mimics(&model),
        [
            ("a", "b", 2.0, 0.0),
            ("c", "d", 1.0, 0.0),
            ("x_a", "x_b", 2.0, 0.0),
            ("y_x_a", "y_x_b", 2.0, 0.0),
        ]
    );
}

#[test]
fn joint_may_be_called_as_a_fixed_body_before_it() {
    let text = "<mujoco><worldbody><body name=\"j\"><geom size=\"1\"/></body>
  <body name=\"a\"><joint name=\"j\" type=\"slide\"/><geom size=\"1\"/>
    <body name=\"b\"><joint name=\"k\" type=\"slide\"/><geom size=\"1\"/></body></body>
</worldbody><equality><joint joint1=\"k\" joint2=\"j\"/></equality></mujoco>";
    let model = parse(text, &[]);
    assert_eq!(errors(&model), [""; 0]);
    assert_eq!(mimics(&model), [("k", "j", 1.0, 0.0)]);
    let tree = kane_codegen::tree::build(&model).unwrap().tree;
    assert_eq!((tree.n_coordinates, tree.bodies.len()), (1, 2));
}

#[test]
fn equalities_with_the_world_hold_for_all_that_is_copied() {
    let child = "<mujoco><worldbody>
  <body name=\"tip\"><joint name=\"a\" type=\"slide\"/><geom size=\"1\"/>
    <body><joint name=\"b\" type=\"slide\"/><geom size=\"1\"/></body></body>
</worldbody><equality>
  <connect body1=\"tip\" body2=\"world\" anchor=\"0 0 0\"/>
  <weld body1=\"tip\" body2=\"\"/>
  <joint joint1=\"b\" joint2=\"\"/>
</equality></mujoco>";
    let text = "<mujoco><asset><model name=\"m\" file=\"m.xml\"/></asset><worldbody>
  <attach model=\"m\" prefix=\"p_\"/></worldbody></mujoco>";
    let model = parse(text, &[("m.xml", child)]);
    assert_eq!(errors(&model).len(), 2);
    // Held in the reference pose.
    assert!(mimics(&model).is_empty());
    let kinds = model.bodies.iter().map(|body| body.joint.kind.as_ref());
    let kinds: Vec<_> = kinds.map(|kind| &kind.unwrap().value).collect();
    assert_eq!(*kinds[1], JointKind::Fixed);
}

#[test]
fn equality_of_elements_in_a_replicate_holds_in_each_copy() {
    let text = "<mujoco><worldbody><replicate count=\"2\" offset=\"9 0 0\" sep=\"_\">
  <body><joint name=\"a\" type=\"slide\"/><geom size=\"1\"/>
    <body><joint name=\"b\" type=\"slide\"/><geom size=\"1\"/></body></body>
</replicate></worldbody><equality><joint joint1=\"a\" joint2=\"b\"/></equality></mujoco>";
    let model = parse(text, &[]);
    assert_eq!(errors(&model), [""; 0]);
    let expected = [("a_0", "b_0", 1.0, 0.0), ("a_1", "b_1", 1.0, 0.0)];
    assert_eq!(mimics(&model), expected);
}

#[test]
fn equality_of_elements_in_and_outside_of_a_replicate_says_how_copies_are_called() {
    let text = "<mujoco><worldbody><replicate count=\"2\" offset=\"9 0 0\" sep=\"_\">
  <body><joint name=\"a\" type=\"slide\"/><geom size=\"1\"/></body></replicate>
  <body><joint name=\"b\" type=\"slide\"/><geom size=\"1\"/></body>
</worldbody><equality><joint joint1=\"b\" joint2=\"a\"/></equality></mujoco>";
    let told = "a joint equality ties joint `a`, which stands in a `replicate`; the first copy is called `a_0`";
    assert_eq!(errors(&parse(text, &[])), [told]);
    // By their own names all joints can be tied.
    let model = parse(&text.replace("joint2=\"a\"", "joint2=\"a_1\""), &[]);
    assert_eq!(errors(&model), [""; 0]);
    assert_eq!(mimics(&model), [("b", "a_1", 1.0, 0.0)]);
}

#[test]
fn joint_without_a_name_is_told_once_for_all_copies() {
    let text = "<mujoco><worldbody><replicate count=\"2\" offset=\"9 0 0\">
  <body><joint name=\"a\" type=\"slide\"/><geom size=\"1\"/></body></replicate>
</worldbody><equality><joint joint1=\"\"/></equality></mujoco>";
    let model = parse(text, &[]);
    assert_eq!(errors(&model), ["`joint1` of a joint equality is empty"]);
}

#[test]
fn equality_that_holds_the_only_joint_is_pointed_at_where_nothing_moves() {
    let text = "<mujoco><worldbody>
  <body><joint name=\"a\"/><geom size=\"1\"/></body>
</worldbody><equality><joint joint1=\"a\" polycoef=\"0.3 0 0 0 0\"/></equality></mujoco>";
    let found = tree::build(&parse(text, &[])).unwrap_err();
    let [fault] = found.list() else {
        panic!("{found}")
    };
    let labels = fault.labels.iter().map(|(span, label)| {
        let text = &text[span.start..span.end];
        (text.split(' ').next().unwrap(), label.as_str())
    });
    let labels: Vec<(&str, &str)> = labels.collect();
    assert_eq!(
        labels.last().unwrap(),
        &("<joint", "an equality holds its joint"),
        "{found}"
    );
}
