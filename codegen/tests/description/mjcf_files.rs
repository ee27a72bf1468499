//! MJCF of several files, what of it is left out, and files that are none.

use std::fs;

use kane_codegen::diagnostic::SourceFile;

use crate::mjcf_support::{elementary, faults, number, oriented, parse, read};

#[test]
fn included_elements_stand_where_they_are_included() {
    let text = "<mujoco model=\"main\">
      <include file=\"options.xml\"/>
      <worldbody>
        <body name=\"a\"/>
        <include file=\"./parts/bodies.xml\"/>
        <body name=\"e\"/>
      </worldbody>
    </mujoco>";
    let files = [
        (
            "options.xml",
            "<mujoco model=\"other\"><compiler angle=\"radian\"/></mujoco>",
        ),
        (
            "./parts/bodies.xml",
            "<mujocoinclude><body name=\"b\"><include file=\"geoms.xml\"/></body><include file=\"more.xml\"/></mujocoinclude>",
        ),
        (
            "geoms.xml",
            "<mujocoinclude><geom size=\"1\" mass=\"5\"/></mujocoinclude>",
        ),
        (
            "more.xml",
            "<mujocoinclude><body name=\"c\"/><body name=\"d\" axisangle=\"1 0 0 3.0\" mas=\"1\"/></mujocoinclude>",
        ),
    ];
    let model = parse(text, &files);
    let names: Vec<&str> = model
        .bodies
        .iter()
        .map(|body| body.name.as_ref().unwrap().value.as_str())
        .collect();
    assert_eq!(names, ["a", "b", "c", "d", "e"]);
    assert_eq!(model.name.as_ref().unwrap().value, "main");
    assert_eq!(number(model.bodies[1].mass), 5.0);
    oriented(&model.bodies[3], &elementary('x', 3.0));
    let files: Vec<&str> = model.source.files().map(SourceFile::name).collect();
    assert_eq!(
        files,
        [
            "model.xml",
            "options.xml",
            "./parts/bodies.xml",
            "geoms.xml",
            "more.xml"
        ]
    );
    insta::assert_snapshot!(faults(&model), @r#"
    warning: unknown attribute `mas` of body `d`
     --> more.xml:1:69
      |
    1 | <mujocoinclude><body name="c"/><body name="d" axisangle="1 0 0 3.0" mas="1"/></mujocoinclude>
      |                                                                     ^^^ ignored
      |
      = help: the attributes that are read here are `name`, `childclass`, `mocap`, `pos`, `quat`, `axisangle`, `xyaxes`, `zaxis`, `euler`, `gravcomp`, `fuse`
    "#);
}

#[test]
fn what_is_left_out_is_said() {
    let text = "<mujoco>
  <compiler usethread=\"true\" angel=\"radian\"/>
  <option timestep=\"0.01\"/>
  <default>
    <joint dampin=\"1\"/>
    <motor ctrlrange=\"-1 1\"/>
    <sensr/>
  </default>
  <asset><mesh file=\"shell.stl\"/></asset>
  <worldbody>
    <light/>
    <geom type=\"mesh\" mesh=\"shell\"/>
    <body name=\"base\">
      <geom name=\"shell\" type=\"mesh\" mesh=\"shell\"/>
      <site/>
      <body name=\"arm\" mass=\"1\">
        <joint name=\"shoulder\" type=\"ball\" range=\"0 90\"/>
        <geom size=\"1\" color=\"red\"/>
        <bdy/>
      </body>
    </body>
    <body name=\"hand\" mocap=\"true\"/>
  </worldbody>
  <actuators/>
  <actuator><motor joint=\"shoulder\"/></actuator>
  <contact><pair geom1=\"a\" geom2=\"b\"/></contact>
  <contact><exclude body1=\"a\" body2=\"b\"/></contact>
  <tendon><fixed stiffness=\"0\"><joint joint=\"a\" coef=\"1\"/></fixed></tendon>
  <equality><joint joint1=\"a\" active=\"false\"/></equality>
  <sensor><gyro site=\"a\"/></sensor>
  <keyframe><key/></keyframe>
</mujoco>";
    let model = parse(text, &[]);
    assert!(!faults(&model).has_error());
    insta::assert_snapshot!(faults(&model));
}

#[test]
fn fault_of_a_default_is_told_once() {
    let text = "<mujoco><default><joint armature=\"much\"/></default><worldbody>
        <body name=\"a\"><joint/><geom size=\"1\"/></body><body name=\"b\"><joint/><geom size=\"1\"/></body>
      </worldbody></mujoco>";
    insta::assert_snapshot!(faults(&parse(text, &[])), @r#"
    error: `armature` of `joint` of the main default class is `much`; expected a number
     --> model.xml:1:35
      |
    1 | <mujoco><default><joint armature="much"/></default><worldbody>
      |                                   ^^^^ no number
    "#);
}

#[test]
fn flag_makes_equalities_harmless() {
    let equality = "<worldbody/><equality><weld body1=\"a\"/></equality>";
    for flag in ["equality", "constraint"] {
        read(&format!(
            "<mujoco><option><flag {flag}=\"disable\"/></option>{equality}</mujoco>"
        ));
    }
    read(&format!(
        "<mujoco><default><equality active=\"false\"/></default>{equality}</mujoco>"
    ));
}

#[test]
fn deep_files_are_refused_and_wide_ones_read() {
    let deep = |n: usize| {
        let text = format!("{}{}", "<body>".repeat(n), "</body>".repeat(n));
        parse(
            &format!("<mujoco><worldbody>{text}</worldbody></mujoco>"),
            &[],
        )
    };
    assert!(!faults(&deep(498)).has_error());
    assert_eq!(deep(498).bodies.len(), 498);
    let refused = deep(100_000);
    assert!(refused.bodies.is_empty());
    assert_eq!(refused.faults.len(), 1);
    assert!(refused.faults[0].message.contains("500 deep"));
    let wide = "<body><joint/><joint/><geom size=\"1\"/></body>".repeat(5_000);
    let wide = read(&format!("<mujoco><worldbody>{wide}</worldbody></mujoco>"));
    assert_eq!(wide.bodies.len(), 10_000);
}

#[test]
fn no_file_stops_the_program() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/mjcf");
    let names = [
        "legged",
        "inertias",
        "several_joints",
        "orientations",
        "humanoid",
    ];
    let mut random = kane_test_support::random::Random::new(2024);
    let pieces = [
        "\"",
        "<",
        ">",
        "/>",
        " ",
        "1e308",
        "-",
        "nan",
        "default",
        "\u{e4}",
        "<include file=\"a\"/>",
    ];
    for name in names {
        let text = fs::read_to_string(format!("{folder}/{name}/{name}.xml")).unwrap();
        for _ in 0..150 {
            let mut mutant: Vec<char> = text.chars().collect();
            for _ in 0..=random.below(3) {
                let at = random.below(mutant.len());
                let to = (at + random.below(12)).min(mutant.len());
                let piece = pieces[random.below(pieces.len())];
                mutant.splice(at..to, piece.chars());
            }
            let mutant: String = mutant.into_iter().collect();
            let model = parse(&mutant, &[("a", &mutant)]);
            let _ = faults(&model).to_string();
        }
    }
}

#[test]
fn copies_of_copies_are_bounded() {
    let (mut open, mut close) = (String::new(), String::new());
    for _ in 0..4 {
        open.push_str("<replicate count=\"10000\">");
        close.push_str("</replicate>");
    }
    let geoms = "<geom size=\"1\"/>".repeat(100);
    let text = format!("<mujoco><worldbody><body>{open}{geoms}{close}</body></worldbody></mujoco>");
    let model = parse(&text, &[]);
    let errors = model.faults.iter().filter(|fault| fault.is_error());
    let messages: Vec<&str> = errors.map(|fault| fault.message.as_str()).collect();
    assert_eq!(
        messages,
        ["`replicate` and `attach` make more than 1000000 elements"]
    );
}

#[test]
fn attachments_of_attachments_are_bounded() {
    let model = |next: usize| {
        format!(
            "<mujoco><asset><model name=\"n\" file=\"{next}.xml\"/></asset><worldbody>
  <attach model=\"n\" prefix=\"a\"/><attach model=\"n\" prefix=\"b\"/>
</worldbody></mujoco>"
        )
    };
    let leaf = "<mujoco><worldbody><body><joint/><geom size=\"1\"/></body></worldbody></mujoco>";
    let last = 30;
    let texts = (1..=last).map(|number| {
        if number < last {
            model(number + 1)
        } else {
            leaf.to_owned()
        }
    });
    let names = (1..=last).map(|number| format!("{number}.xml"));
    let files: Vec<(String, String)> = names.zip(texts).collect();
    let files: Vec<(&str, &str)> = files
        .iter()
        .map(|(name, text)| (&**name, &**text))
        .collect();
    let model = parse(&model(1), &files);
    let errors = model.faults.iter().filter(|fault| fault.is_error());
    let messages: Vec<&str> = errors.map(|fault| fault.message.as_str()).collect();
    assert_eq!(
        messages,
        ["`replicate` and `attach` make more than 1000000 elements"]
    );
}
