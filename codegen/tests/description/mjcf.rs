//! MJCF becomes the description that MuJoCo means: bodies, joints and defaults, each rule on a model of its own.

use std::f64::consts::{FRAC_PI_2, PI};
use std::io;

use kane_codegen::description::{Chart, JointKind, PerCoordinate, Reading, mjcf};
use kane_codegen::diagnostic::{Severity, Source};

use crate::mjcf_support::{
    attachment_rotation, baked, close, elementary, faults, limits, number, only, oriented, parse,
    read, same, vector,
};

#[test]
fn model_without_a_word_has_what_mujoco_gives_it() {
    let model = read("<mujoco><worldbody><body name=\"a\"/></worldbody></mujoco>");
    assert_eq!(model.name.unwrap().value, "MuJoCo Model");
    assert_eq!(vector(model.gravity), [0.0, 0.0, -9.81]);
    assert!(model.faults.is_empty());
    let body = &model.bodies[0];
    assert_eq!(body.joint.kind.as_ref().unwrap().value, JointKind::Fixed);
    assert_eq!(number(body.mass), 0.0);
}

#[test]
fn last_gravity_counts_and_its_flag_switches_it_off() {
    let gravity =
        |options: &str| vector(read(&format!("<mujoco>{options}<worldbody/></mujoco>")).gravity);
    assert_eq!(
        gravity("<option gravity=\"1 2 3\"/><option gravity=\"4 5 6\" timestep=\"1\"/>"),
        [4.0, 5.0, 6.0]
    );
    assert_eq!(
        gravity("<option><flag gravity=\"disable\"/></option><option gravity=\"4 5 6\"/>"),
        [0.0; 3]
    );
}

#[test]
fn bodies_stand_depth_first_on_their_parents() {
    let model = read(
        "<mujoco model=\"tree\"><worldbody>
           <body name=\"a\"><body name=\"b\"><body name=\"c\"/></body><body name=\"d\"/></body>
           <body name=\"e\"/>
         </worldbody><worldbody><body name=\"f\"/></worldbody></mujoco>",
    );
    let names: Vec<&str> = model
        .bodies
        .iter()
        .map(|body| body.name.as_ref().unwrap().value.as_str())
        .collect();
    assert_eq!(names, ["a", "b", "c", "d", "e", "f"]);
    let lower = model.lower_bodies.unwrap().value;
    let lower: Vec<i64> = lower
        .into_iter()
        .map(|lower| lower.unwrap().value)
        .collect();
    assert_eq!(lower, [0, 1, 2, 1, 0, 0]);
}

#[test]
fn class_inherits_and_the_nearest_word_counts() {
    let defaults = "<default>
        <joint damping=\"1\" axis=\"1 0 0\"/>
        <default class=\"inner\">
          <joint damping=\"2\" armature=\"0.5\"/>
          <default class=\"innermost\"><joint frictionloss=\"3\"/></default>
        </default>
        <default class=\"other\"><joint damping=\"4\"/></default>
      </default>";
    let damping = |body: &str| {
        let body = only(defaults, body);
        let joint = &body.joint;
        (
            baked(&joint.damping),
            baked(&joint.armature),
            same(&joint.friction),
        )
    };
    assert_eq!(damping("<body><joint/></body>"), (Some(1.0), None, None));
    assert_eq!(
        damping("<body childclass=\"innermost\"><joint/></body>"),
        (Some(2.0), Some(0.5), Some(3.0))
    );
    assert_eq!(
        damping("<body childclass=\"innermost\"><joint class=\"other\"/></body>"),
        (Some(4.0), None, None)
    );
    assert_eq!(
        damping("<body childclass=\"innermost\"><joint class=\"main\"/></body>"),
        (Some(1.0), None, None)
    );
    assert_eq!(
        damping("<body childclass=\"inner\"><joint damping=\"0\"/></body>"),
        (None, Some(0.5), None)
    );
    assert_eq!(
        damping("<body childclass=\"inner\"><frame childclass=\"other\"><joint/></frame></body>"),
        (Some(4.0), None, None)
    );
    // A free joint of its own element inherits nothing.
    assert_eq!(damping("<body><freejoint/></body>"), (None, None, None));
}

#[test]
fn hinge_sits_at_its_anchor() {
    let body = only(
        "<compiler angle=\"radian\"/>",
        "<body name=\"door\" pos=\"1 2 3\" axisangle=\"0 0 1 1.5707963267948966\">
           <joint name=\"hinge\" pos=\"0.5 0 0\" axis=\"0 0 2\" ref=\"0.25\" range=\"-1 1\" actuatorfrcrange=\"-5 7\"
                  stiffness=\"2\" springref=\"0.1\" damping=\"3\" armature=\"4\" frictionloss=\"6\"/>
         </body>",
    );
    let joint = &body.joint;
    assert_eq!(joint.kind.as_ref().unwrap().value, JointKind::Revolute);
    assert_eq!(joint.name.as_ref().unwrap().value, "hinge");
    assert_eq!(joint.axis.unwrap().value, [0.0, 0.0, 2.0]);
    close(&vector(joint.attachment), &[1.0, 2.5, 3.0]);
    assert_eq!(vector(joint.body_attachment.unwrap()), [0.5, 0.0, 0.0]);
    // A quarter turn, less the reference.
    oriented(&body, &elementary('z', FRAC_PI_2 - 0.25));
    assert_eq!(joint.body_rotation, None);
    assert_eq!(limits(joint), [Some(-1.0), Some(1.0), Some(5.0)]);
    assert_eq!(baked(&joint.stiffness), Some(2.0));
    assert_eq!(baked(&joint.rest), Some(0.1));
    assert_eq!(baked(&joint.damping), Some(3.0));
    assert_eq!(baked(&joint.armature), Some(4.0));
    assert_eq!(same(&joint.friction), Some(6.0));
}

#[test]
fn angles_of_hinges_are_degrees_and_lengths_of_slides_are_not() {
    let attributes = "range=\"-90 180\" ref=\"90\" stiffness=\"1\" springref=\"45\" axis=\"1 0 0\"";
    let hinge = only("", &format!("<body><joint {attributes}/></body>"));
    assert_eq!(limits(&hinge.joint)[..2], [Some(-FRAC_PI_2), Some(PI)]);
    assert_eq!(baked(&hinge.joint.rest), Some(PI / 4.0));
    assert_eq!(
        attachment_rotation(&hinge),
        [[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]]
    );
    let slide = only(
        "",
        &format!("<body pos=\"0 1 0\"><joint type=\"slide\" pos=\"7 7 7\" {attributes}/></body>"),
    );
    assert_eq!(
        slide.joint.kind.as_ref().unwrap().value,
        JointKind::Prismatic
    );
    assert_eq!(limits(&slide.joint)[..2], [Some(-90.0), Some(180.0)]);
    assert_eq!(baked(&slide.joint.rest), Some(45.0));
    assert_eq!(vector(slide.joint.attachment), [-90.0, 1.0, 0.0]);
    assert_eq!(slide.joint.body_attachment, None);
}

#[test]
fn range_is_a_limit_where_it_is_in_force() {
    let lower = |compiler: &str, joint: &str| {
        let compiler = format!("<compiler angle=\"radian\" {compiler}/>");
        limits(&only(&compiler, &format!("<body><joint {joint}/></body>")).joint)[0]
    };
    let manual = "autolimits=\"false\"";
    assert_eq!(lower("", "range=\"1 2\""), Some(1.0));
    assert_eq!(lower("", "range=\"1 2\" limited=\"auto\""), Some(1.0));
    assert_eq!(lower("", "range=\"1 2\" limited=\"false\""), None);
    assert_eq!(lower("", "range=\"2 1\""), None);
    assert_eq!(lower(manual, "range=\"1 2\" limited=\"true\""), Some(1.0));
    assert_eq!(lower(manual, "range=\"1 2\" limited=\"false\""), None);
}

#[test]
fn flags_switch_springs_and_dampers_off() {
    for (flags, springs, dampers) in [
        ("spring=\"disable\"", None, Some(2.0)),
        ("damper=\"disable\"", Some(1.0), None),
        ("passive=\"disable\"", None, None),
    ] {
        let body = only(
            &format!("<option><flag {flags}/></option>"),
            "<body><joint stiffness=\"1\" damping=\"2\"/></body>",
        );
        assert_eq!(baked(&body.joint.stiffness), springs);
        assert_eq!(baked(&body.joint.damping), dampers);
    }
}

#[test]
fn what_no_spring_or_damper_feels_is_no_fault() {
    only("", "<body><joint springyield=\"3\"/></body>");
    only(
        "<option><flag passive=\"disable\"/></option>",
        "<body><joint stiffness=\"1 2\" damping=\"2 0 1\" springyield=\"3\"/></body>",
    );
}

#[test]
fn several_joints_are_a_chain_of_bodies() {
    let model = read(
        "<mujoco><worldbody>
           <body name=\"hip\" pos=\"1 0 0\" euler=\"0 0 90\">
             <joint name=\"yaw\" pos=\"0 0 1\"/>
             <joint type=\"slide\" axis=\"1 0 0\"/>
             <joint name=\"roll\" pos=\"0 2 0\" axis=\"0 1 0\"/>
             <inertial pos=\"0 0 0\" mass=\"3\" diaginertia=\"1 1 1\"/>
             <body name=\"knee\"/>
           </body>
         </worldbody></mujoco>",
    );
    let names: Vec<&str> = model
        .bodies
        .iter()
        .map(|body| body.name.as_ref().unwrap().value.as_str())
        .collect();
    assert_eq!(names, ["hip_yaw", "hip_joint2", "hip", "knee"]);
    let lower = model.lower_bodies.unwrap().value;
    let lower: Vec<i64> = lower
        .into_iter()
        .map(|lower| lower.unwrap().value)
        .collect();
    assert_eq!(lower, [0, 1, 2, 3]);
    let masses: Vec<f64> = model.bodies.iter().map(|body| number(body.mass)).collect();
    assert_eq!(masses, [0.0, 0.0, 3.0, 0.0]);
    let joints: Vec<Option<&str>> = model
        .bodies
        .iter()
        .map(|body| body.joint.name.as_ref().map(|name| name.value.as_str()))
        .collect();
    assert_eq!(joints, [Some("yaw"), None, Some("roll"), None]);
    let [yaw, slide, roll, _] = &model.bodies[..] else {
        unreachable!("there are four")
    };
    assert_eq!(vector(yaw.joint.attachment), [1.0, 0.0, 1.0]);
    assert!(yaw.joint.attachment_rotation.is_some());
    assert_eq!(vector(slide.joint.attachment), [0.0; 3]);
    assert_eq!(slide.joint.attachment_rotation, None);
    assert_eq!(vector(roll.joint.attachment), [0.0, 2.0, 0.0]);
    assert_eq!(vector(roll.joint.body_attachment.unwrap()), [0.0, 2.0, 0.0]);
}

#[test]
fn made_up_names_are_nobody_elses() {
    let model = read(
        "<mujoco><worldbody>
           <body/><body name=\"body2\"/><body/>
           <body name=\"a_joint1\"/>
           <body name=\"a\"><joint/><joint/><geom size=\"1\"/></body>
         </worldbody></mujoco>",
    );
    let names: Vec<&str> = model
        .bodies
        .iter()
        .map(|body| body.name.as_ref().unwrap().value.as_str())
        .collect();
    assert_eq!(
        names,
        ["body1", "body2", "body3", "a_joint1", "a_joint1_2", "a"]
    );
    let notes = model.faults.iter().map(|fault| fault.severity);
    assert!(notes.eq([Severity::Note; 2]));
}

#[test]
fn ball_joint_turns_about_its_anchor() {
    let body = only(
        "",
        "<body pos=\"0 0 1\"><joint type=\"ball\" pos=\"0 0 -0.5\" damping=\"2\" armature=\"3\"/></body>",
    );
    let joint = &body.joint;
    assert_eq!(joint.kind.as_ref().unwrap().value, JointKind::Spherical);
    assert_eq!(joint.chart.unwrap().value, Chart::Quaternion);
    assert_eq!((joint.speeds, joint.axis), (None, None));
    assert_eq!(vector(joint.attachment), [0.0, 0.0, 0.5]);
    assert_eq!(vector(joint.body_attachment.unwrap()), [0.0, 0.0, -0.5]);
    assert_eq!(
        (baked(&joint.damping), baked(&joint.armature)),
        (Some(2.0), Some(3.0))
    );
}

#[test]
fn free_joint_counts_from_the_world() {
    let text = "<mujoco><default><joint damping=\"2\"/></default><worldbody>
        <frame pos=\"1 1 1\"><body name=\"a\" pos=\"1 2 3\" euler=\"10 20 30\"><freejoint name=\"root\"/></body></frame>
        <body name=\"b\" pos=\"1 2 3\"><joint type=\"free\" pos=\"4 5 6\" limited=\"true\"/></body>
      </worldbody></mujoco>";
    for (body, damping) in read(text).bodies.iter().zip([None, Some(2.0)]) {
        let joint = &body.joint;
        assert_eq!(joint.kind.as_ref().unwrap().value, JointKind::Free);
        assert_eq!(vector(joint.attachment), [0.0; 3]);
        assert_eq!(joint.attachment_rotation, None);
        assert_eq!(joint.body_attachment, None);
        assert_eq!(baked(&joint.damping), damping);
        assert_eq!(joint.limits, PerCoordinate::Absent);
    }
}

#[test]
fn user_says_how_orientations_are_described() {
    let text = "<mujoco><worldbody>
        <body name=\"a\"><freejoint/></body><body name=\"b\"><joint type=\"ball\"/></body>
      </worldbody></mujoco>";
    let reading = Reading {
        chart: Some(Chart::Angles),
        ..Reading::default()
    };
    let model = mjcf::parse(&Source::new("model.xml", text), &reading, &|_| {
        Err(io::Error::from(io::ErrorKind::NotFound))
    });
    assert!(model.faults.is_empty());
    for body in &model.bodies {
        assert_eq!(body.joint.chart.unwrap().value, Chart::Angles);
        assert_eq!(body.joint.speeds, None);
    }
    let damped = text.replace("type=\"ball\"", "type=\"ball\" damping=\"1\"");
    let model = mjcf::parse(&Source::new("model.xml", damped), &reading, &|_| {
        Err(io::Error::from(io::ErrorKind::NotFound))
    });
    insta::assert_snapshot!(faults(&model), @r#"
    error: `damping` of a joint of body `b` acts on the angular velocity, but the speeds are rates of angles
     --> model.xml:2:86
      |
    2 |         <body name="a"><freejoint/></body><body name="b"><joint type="ball" damping="1"/></body>
      |                                                                                      ^ expected 0
      |
      = help: with `chart = "quaternion"`, the default, the speeds are components of the angular velocity
    "#);
}

#[test]
fn weight_that_is_lifted_is_a_share_of_each_body() {
    let body = |share: &str| {
        format!("<body name=\"body{share}\" gravcomp=\"{share}\"><joint/><geom size=\"1\"/></body>")
    };
    let bodies = [body("0.25"), body("0"), body("-2")].concat();
    let shares = |option: &str| {
        let text = format!("<mujoco>{option}<worldbody>{bodies}</worldbody></mujoco>");
        let model = parse(&text, &[]);
        assert_eq!(faults(&model).to_string(), "");
        let shares = model.bodies.iter().map(|body| body.gravity_compensation);
        let shares = shares.map(|share| share.map(|share| share.value.nominal()));
        shares.collect::<Vec<_>>()
    };
    assert_eq!(shares(""), [Some(0.25), None, Some(-2.0)]);
    // MuJoCo then has no such forces, and no passive forces at all.
    let text = format!("<mujoco><worldbody>{}</worldbody></mujoco>", body("-2"));
    assert_eq!(parse(&text, &[]).bodies[0].gravity_compensation, None);
    let without = "<option><flag spring=\"disable\" damper=\"disable\"/></option>";
    assert_eq!(shares(without), [None; 3]);
}

#[test]
fn weights_that_actuators_lift_are_refused_where_weights_are_lifted() {
    let model = |share: &str| {
        let text = format!(
            "<mujoco><worldbody><body gravcomp=\"{share}\">
  <joint actuatorgravcomp=\"true\"/><geom size=\"1\"/></body></worldbody></mujoco>"
        );
        let model = parse(&text, &[]);
        model.faults.iter().filter(|fault| fault.is_error()).count()
    };
    assert_eq!([model("1"), model("0")], [1, 0]);
}

#[test]
fn inertials_are_not_copied() {
    let child = "<mujoco><worldbody><frame name=\"f\">
  <inertial pos=\"0 0 0\" mass=\"7\" diaginertia=\"1 1 1\"/><geom size=\"1\" mass=\"2\"/></frame></worldbody></mujoco>";
    let text = "<mujoco><asset><model name=\"m\" file=\"m.xml\"/></asset><worldbody>
  <body><joint/><geom size=\"1\" mass=\"1\"/><attach model=\"m\" frame=\"f\" prefix=\"p_\"/></body>
</worldbody></mujoco>";
    let model = parse(text, &[("m.xml", child)]);
    assert_eq!(number(model.bodies[0].mass), 3.0);
    let told = faults(&model).to_string();
    assert!(told.contains("MuJoCo does not copy it"), "{told}");
}

#[test]
fn numbers_of_copies_have_as_many_digits_as_their_count() {
    let text = "<mujoco><worldbody><replicate count=\"10\" offset=\"1 0 0\">
  <body name=\"b\"><joint/><geom size=\"1\"/></body></replicate></worldbody></mujoco>";
    let model = parse(text, &[]);
    let names: Vec<&str> = model
        .bodies
        .iter()
        .map(|body| &*body.name.as_ref().unwrap().value)
        .collect();
    assert_eq!((names[0], names[9]), ("b00", "b09"));
}

#[test]
fn a_replicate_may_have_no_copies() {
    let model = read(
        "<mujoco><worldbody><replicate count=\"0\"><body><joint/><geom size=\"1\"/></body></replicate>
  <body name=\"only\"><joint/><geom size=\"1\"/></body></worldbody></mujoco>",
    );
    assert_eq!(model.bodies.len(), 1);
}

#[test]
fn names_of_copies_grow_no_longer_than_names_may_be() {
    let long = "p".repeat(300);
    let attach = format!(
        "<mujoco><asset><model name=\"m\" file=\"m.xml\"/></asset><worldbody><attach model=\"m\" prefix=\"{long}\"/></worldbody></mujoco>"
    );
    let child = "<mujoco><worldbody><body name=\"a\"><joint/><geom size=\"1\"/></body></worldbody></mujoco>";
    let replicate = format!(
        "<mujoco><worldbody><replicate count=\"2\" sep=\"{long}\"><body name=\"a\"><joint/><geom size=\"1\"/></body></replicate></worldbody></mujoco>"
    );
    for text in [attach, replicate] {
        let told = faults(&parse(&text, &[("m.xml", child)])).to_string();
        assert!(
            told.contains("characters to names; expected at most 250"),
            "{told}"
        );
    }
}

#[test]
fn attached_models_have_the_mesh_settings_and_groups_that_mujoco_gives_them() {
    let child = "<mujoco><compiler inertiagrouprange=\"2 3\" boundinertia=\"0.5\"/><worldbody>
  <frame name=\"f\" pos=\"0 0 3\"><body name=\"x\"><joint/><geom size=\"1\" mass=\"1\" group=\"0\"/>
    <geom size=\"1\" mass=\"2\" group=\"2\"/></body></frame>
  <frame name=\"g\"><geom size=\"1\" mass=\"4\" group=\"0\"/><geom size=\"1\" mass=\"8\" group=\"2\"/></frame>
</worldbody></mujoco>";
    let text = "<mujoco><compiler inertiagrouprange=\"0 1\"/><asset><model name=\"m\" file=\"m.xml\"/></asset><worldbody>
  <body><joint/><geom size=\"1\" mass=\"16\"/>
    <attach model=\"m\" frame=\"f\" prefix=\"f_\"/><attach model=\"m\" frame=\"g\" prefix=\"g_\"/></body>
</worldbody></mujoco>";
    let model = parse(text, &[("m.xml", child)]);
    let masses: Vec<f64> = model.bodies.iter().map(|body| number(body.mass)).collect();
    // Of a frame's geoms the settings of the body count, of a body's its own.
    assert_eq!(masses, [16.0 + 4.0, 2.0]);
    assert_eq!(vector(model.bodies[1].joint.attachment), [0.0, 0.0, 3.0]);
}

#[test]
fn class_of_a_replicate_is_that_of_what_it_holds() {
    let model = read(
        "<mujoco><default><default class=\"h\"><joint damping=\"3\"/></default></default><worldbody>
  <replicate count=\"2\" childclass=\"h\"><body><joint/><geom size=\"1\"/></body></replicate>
</worldbody></mujoco>",
    );
    assert!(
        model
            .bodies
            .iter()
            .all(|body| baked(&body.joint.damping) == Some(3.0))
    );
}

#[test]
fn geom_too_small_for_a_mass_has_none() {
    let body = only(
        "",
        "<body><geom size=\"1e-5\" mass=\"1\"/><geom size=\"1\" mass=\"2\"/></body>",
    );
    assert_eq!(number(body.mass), 2.0);
}

#[test]
fn inertia_that_a_bound_raises_may_be_absent() {
    let before = "<compiler boundinertia=\"0.01\"/>";
    let body = only(before, "<body><inertial pos=\"0 0 0\" mass=\"1\"/></body>");
    assert_eq!(body.inertia.map(number), [0.01, 0.01, 0.01, 0.0, 0.0, 0.0]);
}

#[test]
fn body_without_a_joint_may_be_a_point_mass() {
    let model = read(
        "<mujoco><worldbody><body name=\"b\"><joint/><geom size=\"1\"/>
           <body name=\"c\"><inertial pos=\"1 0 0\" mass=\"2\"/></body></body></worldbody></mujoco>",
    );
    let body = &model.bodies[1];
    assert_eq!(body.inertia.map(number), [0.0; 6]);
    assert_eq!(number(body.mass), 2.0);
    assert_eq!(body.mass_center.map(number), [1.0, 0.0, 0.0]);
}

#[test]
fn names_of_ours_give_way_to_those_of_the_file() {
    let model = read(
        "<mujoco><worldbody><body name=\"b\"><joint/><geom size=\"1\"/><site name=\"b\"/><site name=\"b_site\"/>
           <body name=\"c\"><joint name=\"b\"/><geom size=\"1\"/></body></body></worldbody></mujoco>",
    );
    let joints = model.bodies.iter().filter_map(|body| body.joint_name());
    let joints: Vec<&str> = joints.map(|name| name.value.as_str()).collect();
    assert_eq!(joints, ["b_2", "b"]);
    let frames = model.frames.iter().filter_map(|frame| frame.name.as_ref());
    let frames: Vec<&str> = frames.map(|name| name.value.as_str()).collect();
    assert_eq!(frames, ["b_site_site", "b_site"]);
    let told = "site `b` is called `b_site_site`: a body has its name";
    assert!(model.faults.iter().any(|note| note.message == told));
    assert!(kane_codegen::tree::build(&model).is_ok());
}
