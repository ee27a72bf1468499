//! Reading URDF: what every element becomes.

mod causes;
mod left_out;
mod limits;
mod robots;
mod text;

use std::f64::consts::FRAC_PI_2;

use kane_codegen::description::{
    Base, Chart, Description, JointKind, Limits, Mimic, PerCoordinate, Reading, Rotation, Scalar,
    WrittenBody, WrittenJoint, read, urdf,
};
use kane_codegen::diagnostic::{Diagnostic, Severity, Source, Spanned};
use kane_test_support::compare::{Tolerance, assert_close};

/// A robot of links without inertia: its joints are `(name, type, parent, child, inside)`.
fn robot(joints: &[(&str, &str, &str, &str, &str)]) -> String {
    let mut links: Vec<&str> = Vec::new();
    let mut text = String::from("<robot name=\"robot\">\n");
    for (name, kind, parent, child, inside) in joints {
        for link in [parent, child] {
            if !links.contains(link) {
                links.push(link);
                text += &link_element(link);
            }
        }
        text += &joint_element(name, kind, [parent, child], inside);
    }
    text + "</robot>\n"
}

fn link_element(name: &str) -> String {
    format!("<link name=\"{name}\"/>\n")
}

fn joint_element(name: &str, kind: &str, [parent, child]: [&str; 2], inside: &str) -> String {
    format!(
        "<joint name=\"{name}\" type=\"{kind}\"><parent link=\"{parent}\"/><child link=\"{child}\"/>{inside}</joint>\n"
    )
}

fn parse(text: &str, reading: &Reading) -> Description {
    urdf::parse(&Source::new("robot.urdf", text), reading)
}

/// Reads a robot in which nothing is wrong, and of which there is nothing to say but that it has no gravity.
fn parse_well(text: &str, reading: &Reading) -> Description {
    let description = parse(text, reading);
    assert_eq!(told(&description), [NO_GRAVITY]);
    description
}

const NO_GRAVITY: &str = "a URDF has no gravity: it is taken as (0, 0, -9.81) m/s^2";

fn told(description: &Description) -> Vec<&str> {
    let faults = description.faults.iter();
    faults.map(|fault| fault.message.as_str()).collect()
}

/// The one joint of a robot, with this type and these elements.
fn joint(kind: &str, inside: &str) -> WrittenJoint {
    let text = robot(&[("j", kind, "a", "b", inside)]);
    let mut description = parse_well(&text, &Reading::default());
    description.bodies.remove(1).joint
}

fn body_names(description: &Description) -> Vec<&str> {
    let names = description.bodies.iter().map(|body| body.name.as_ref());
    names
        .map(|name| name.expect("every link has a name").value.as_str())
        .collect()
}

fn lower_bodies(description: &Description) -> Vec<i64> {
    let array = description
        .lower_bodies
        .as_ref()
        .expect("the links form a tree");
    let lower = array.value.iter();
    lower
        .map(|lower| lower.expect("every link hangs from one").value)
        .collect()
}

fn numbers<const N: usize>(given: &[Option<Spanned<Scalar>>; N]) -> [f64; N] {
    given.map(|number| number.expect("nothing is wrong").value.nominal())
}

fn kind(body: &WrittenBody) -> &JointKind {
    &body.joint.kind.as_ref().expect("nothing is wrong").value
}

#[test]
fn root_element_tells_urdf_from_mjcf() {
    let is_urdf = |text: &str| urdf::is_urdf(&Source::new("model.xml", text));
    assert!(is_urdf("<robot name=\"a\"/>"));
    assert!(is_urdf(
        "\u{feff}<?xml version=\"1.0\"?>\n<!-- <mujoco> -->\r\n <robot\n name='a'>"
    ));
    assert!(is_urdf("<robot"));
    for text in [
        "<mujoco/>",
        "<robots/>",
        "",
        "robot",
        "<!-- <robot/>",
        "<?xml?>",
        "<",
        "< robot>",
    ] {
        assert!(!is_urdf(text), "{text}");
    }
}

#[test]
fn ending_or_root_element_chooses_the_reader() {
    let text = robot(&[("j", "fixed", "a", "b", "")]);
    for name in ["a.urdf", "A.URDF", "robots/a.xml"] {
        let source = Source::new(name, text.as_str());
        let include = |_: &str| Err(std::io::Error::other("a URDF includes nothing"));
        let description = read(&source, &Reading::default(), &include);
        assert_eq!(body_names(&description), ["a", "b"]);
    }
}

#[test]
fn bodies_stand_depth_first_in_the_order_of_the_bytes_of_joint_names() {
    // `Z` before `a`, `a10` before `a2`; the order in the file does not matter, nor do the names of the links.
    let text = robot(&[
        ("a2", "continuous", "base", "left", ""),
        ("inner", "continuous", "middle", "tip", ""),
        ("a10", "continuous", "base", "middle", ""),
        ("Z", "fixed", "base", "right", ""),
        ("y", "fixed", "tip", "end", ""),
        ("ä", "fixed", "base", "last", ""),
    ]);
    let description = parse_well(&text, &Reading::default());
    let names = ["base", "right", "middle", "tip", "end", "left", "last"];
    assert_eq!(body_names(&description), names);
    assert_eq!(lower_bodies(&description), [0, 1, 1, 3, 4, 1, 1]);
    assert_eq!(description.name.expect("it has one").value, "robot");
}

#[test]
fn gravity_is_that_of_the_earth_against_z() {
    let description = parse_well(
        "<robot name=\"r\"><link name=\"a\"/></robot>",
        &Reading::default(),
    );
    assert_eq!(numbers(&description.gravity), [0.0, 0.0, -9.81]);
    assert_eq!(description.faults[0].severity, Severity::Note);
}

#[test]
fn inertia_is_read_with_its_frame_and_its_places() {
    let text = r#"<robot name="r"><link name="a"><inertial>
  <origin xyz="0.1 -0.0 3e-1" rpy="0 0 1.5"/>
  <mass value=" 2.5 "/>
  <inertia ixx="1" ixy="0.1" ixz="0.2" iyy="2" iyz="0.3" izz="2.5"/>
</inertial></link></robot>"#;
    let body = parse_well(text, &Reading::default()).bodies.remove(0);
    let mass = body.mass.expect("it is given");
    assert_eq!(mass.value, Scalar::Baked(2.5));
    assert_eq!(&text[mass.span.start..mass.span.end], "2.5");
    assert_eq!(numbers(&body.mass_center), [0.1, 0.0, 0.3]);
    assert!(numbers(&body.mass_center)[1].is_sign_positive());
    let third = body.mass_center[2].expect("it is given").span;
    assert_eq!(&text[third.start..third.end], "3e-1");
    assert_eq!(numbers(&body.inertia), [1.0, 2.0, 2.5, 0.1, 0.2, 0.3]);
    let (sin, cos) = libm::sincos(1.5);
    let turned = body.inertia_rotation.expect("it is given").value;
    assert_near(turned, [[cos, sin, 0.0], [-sin, cos, 0.0], [0.0, 0.0, 1.0]]);
}

#[test]
fn link_without_inertia_has_none() {
    let body = parse_well(
        "<robot name=\"r\"><link name=\"a\"/></robot>",
        &Reading::default(),
    )
    .bodies
    .remove(0);
    assert_eq!(body.mass.expect("it is zero").value, Scalar::Baked(0.0));
    assert_eq!(numbers(&body.mass_center), [0.0; 3]);
    assert_eq!(numbers(&body.inertia), [0.0; 6]);
    assert!(body.inertia_rotation.is_none());
}

#[test]
fn origin_stands_at_zero_unless_it_is_given() {
    for inside in ["", "<origin/>", "<origin rpy=\"0 -0 0\"/>"] {
        let joint = joint("fixed", inside);
        assert_eq!(numbers(&joint.attachment), [0.0; 3]);
        assert!(joint.attachment_rotation.is_none());
        assert!(joint.body_attachment.is_none() && joint.body_rotation.is_none());
    }
    let joint = joint("fixed", "<origin xyz='1 2 -3'/>");
    assert_eq!(numbers(&joint.attachment), [1.0, 2.0, -3.0]);
}

/// Turned by a quaternion, scalar first: q v q*.
fn turned(q: [f64; 4], v: [f64; 3]) -> [f64; 3] {
    let conjugate = [q[0], -q[1], -q[2], -q[3]];
    let [_, x, y, z] = product(product(q, [0.0, v[0], v[1], v[2]]), conjugate);
    [x, y, z]
}

fn product(a: [f64; 4], b: [f64; 4]) -> [f64; 4] {
    [
        a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
        a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
        a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
        a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0],
    ]
}

fn assert_near(found: Rotation, expected: Rotation) {
    let [found, expected] = [&found, &expected].map(|rotation| rotation.as_flattened());
    // A few roundings of numbers below one.
    assert_close("rotation", found, expected, Tolerance::absolute(1e-15));
}

#[test]
fn rows_of_a_rotation_are_the_axes_turned_about_x_then_y_then_z() {
    let angles = [
        [0.3, 0.0, 0.0],
        [0.0, -0.4, 0.0],
        [0.0, 0.0, 2.5],
        [0.3, -0.4, 2.5],
        [-3.0, 1.2, -0.01],
        [FRAC_PI_2, -FRAC_PI_2, 3.2],
    ];
    for [roll, pitch, yaw] in angles {
        let about = |angle: f64, axis: usize| {
            let mut q = [libm::cos(angle / 2.0), 0.0, 0.0, 0.0];
            q[axis] = libm::sin(angle / 2.0);
            q
        };
        let q = product(about(yaw, 3), product(about(pitch, 2), about(roll, 1)));
        let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let joint = joint("fixed", &format!("<origin rpy='{roll} {pitch} {yaw}'/>"));
        let found = joint.attachment_rotation.expect("it is given").value;
        assert_near(found, axes.map(|axis| turned(q, axis)));
    }
}

#[test]
fn types_become_kinds() {
    let limit = "<limit lower='-1' upper='1' effort='1' velocity='1'/>";
    let kinds = [
        ("fixed", "", JointKind::Fixed),
        ("revolute", limit, JointKind::Revolute),
        ("continuous", "", JointKind::Continuous),
        ("prismatic", limit, JointKind::Prismatic),
        ("planar", "", JointKind::Planar),
        ("floating", "", JointKind::Free),
    ];
    for (name, inside, expected) in kinds {
        let read = joint(name, inside);
        assert_eq!(read.kind.expect("it is given").value, expected);
        assert_eq!(read.name.expect("it is given").value, "j");
        // Whatever is about or along an axis has x unless it is told another.
        let axis = read.axis.map(|axis| axis.value);
        assert_eq!(axis, expected.has_axis().then_some([1.0, 0.0, 0.0]));
        let told = joint(name, &format!("{inside}<axis xyz='0 0.6 -0.8'/>"));
        let axis = told.axis.map(|axis| axis.value);
        assert_eq!(axis, expected.has_axis().then_some([0.0, 0.6, -0.8]));
        let chart = read.chart.map(|chart| chart.value);
        assert_eq!(chart, (name == "floating").then_some(Chart::Quaternion));
    }
    // Where no axis counts, none has to be one.
    assert!(joint("fixed", "<axis xyz='0 0 0'/>").axis.is_none());
}

#[test]
fn axis_without_components_is_told() {
    let told = |inside| {
        let text = robot(&[("j", "continuous", "a", "b", inside)]);
        let faults = parse(&text, &Reading::default()).faults;
        faults.iter().any(|fault| fault.message.contains("`xyz`"))
    };
    assert!(told("<axis/>") && !told("") && !told("<axis xyz='1 0 0'/>"));
}

#[test]
fn root_link_is_fixed_unless_it_is_to_be_free() {
    let text = robot(&[("j", "continuous", "a", "b", "")]);
    for base in [None, Some(Base::Fixed)] {
        let reading = Reading {
            base,
            ..Reading::default()
        };
        let root = parse_well(&text, &reading).bodies.remove(0);
        assert_eq!(kind(&root), &JointKind::Fixed);
        assert_eq!(numbers(&root.joint.attachment), [0.0; 3]);
        assert!(root.joint.chart.is_none());
    }
    for (asked, chart) in [
        (None, Chart::Quaternion),
        (Some(Chart::Quaternion), Chart::Quaternion),
        (Some(Chart::Angles), Chart::Angles),
    ] {
        let reading = Reading {
            base: Some(Base::Free),
            chart: asked,
            ..Reading::default()
        };
        let root = parse_well(&text, &reading).bodies.remove(0);
        assert_eq!(kind(&root), &JointKind::Free);
        assert_eq!(root.joint.chart.expect("it is free").value, chart);
        assert!(root.joint.speeds.is_none());
        assert_eq!(root.joint.name.expect("it has one").value, "root_joint");
    }
}

#[test]
fn root_joint_gives_way_to_joints_of_the_file() {
    let text = robot(&[
        ("root_joint", "continuous", "a", "b", ""),
        ("root_joint_2", "continuous", "b", "c", ""),
    ]);
    let reading = Reading {
        base: Some(Base::Free),
        ..Reading::default()
    };
    let root = parse_well(&text, &reading).bodies.remove(0);
    assert_eq!(root.joint.name.expect("it has one").value, "root_joint_3");
}

#[test]
fn chart_asked_for_is_that_of_floating_joints_too() {
    let text = robot(&[("j", "floating", "a", "b", "")]);
    let reading = Reading {
        chart: Some(Chart::Angles),
        ..Reading::default()
    };
    let body = parse_well(&text, &reading).bodies.remove(1);
    assert_eq!(body.joint.chart.expect("it floats").value, Chart::Angles);
}

/// Lower, upper, velocity, effort.
fn limits(joint: &WrittenJoint) -> Option<[Option<f64>; 4]> {
    match &joint.limits {
        PerCoordinate::Same(limits) => {
            let Limits {
                lower,
                upper,
                velocity,
                effort,
            } = limits.value;
            Some([lower, upper, velocity, effort].map(|limit| limit.map(|limit| limit.value)))
        }
        PerCoordinate::Absent => None,
        PerCoordinate::Each(_) => unreachable!("a URDF has one for all"),
    }
}

#[test]
fn limits_are_kept() {
    let limit = "<limit lower='-1' upper='2' effort='30' velocity='4'/>";
    let all = Some([Some(-1.0), Some(2.0), Some(4.0), Some(30.0)]);
    assert_eq!(limits(&joint("revolute", limit)), all);
    assert_eq!(limits(&joint("prismatic", limit)), all);
    let endless = "<limit effort='30' velocity='4'/>";
    let limits_of = limits(&joint("continuous", endless));
    assert_eq!(limits_of, Some([None, None, Some(4.0), Some(30.0)]));
    assert_eq!(limits(&joint("continuous", "")), None);
    assert_eq!(limits(&joint("fixed", limit)), None);
    // One end of a range alone: the other is zero.
    let half = joint("revolute", "<limit upper='2' effort='30' velocity='4'/>");
    assert_eq!(
        limits(&half),
        Some([Some(0.0), Some(2.0), Some(4.0), Some(30.0)])
    );
}

#[test]
fn range_of_a_continuous_joint_is_left_out_and_that_is_told() {
    let limit = "<limit lower='-1' upper='2' effort='30' velocity='4'/>";
    let text = |limit| robot(&[("j", "continuous", "a", "b", limit)]);
    let description = parse(&text(limit), &Reading::default());
    let warning = "the range of joint `j` is left out: the joint is continuous";
    assert_eq!(told(&description), [NO_GRAVITY, warning]);
    let read = limits(&description.bodies[1].joint);
    assert_eq!(read, Some([None, None, Some(4.0), Some(30.0)]));
    let none = limit.replace("-1", "0").replace("'2'", "'0'");
    assert_eq!(
        told(&parse(&text(&none), &Reading::default())),
        [NO_GRAVITY]
    );
    let unreadable = limit.replace("-1", "abc");
    let faults = parse(&text(&unreadable), &Reading::default()).faults;
    assert!(faults.iter().any(Diagnostic::is_error));
}

#[test]
fn damping_and_friction_are_kept() {
    let both = joint("continuous", "<dynamics damping='0.5' friction='2'/>");
    assert!(matches!(both.damping, PerCoordinate::Same(d) if d.value == Scalar::Baked(0.5)));
    assert!(matches!(both.friction, PerCoordinate::Same(f) if f.value == 2.0));
    let one = joint("continuous", "<dynamics friction='2'/>");
    assert_eq!(one.damping, PerCoordinate::Absent);
    let none = joint("continuous", "");
    assert_eq!(none.friction, PerCoordinate::Absent);
    assert_eq!(none.armature, PerCoordinate::Absent);
    assert_eq!(none.stiffness, PerCoordinate::Absent);
}

#[test]
fn damping_about_all_axes_acts_on_the_angular_velocity_alone() {
    let robot = robot(&[("j", "floating", "a", "b", "<dynamics damping='0.5'/>")]);
    for (chart, n_errors) in [(Chart::Quaternion, 0), (Chart::Angles, 1)] {
        let reading = Reading {
            chart: Some(chart),
            ..Reading::default()
        };
        let faults = parse(&robot, &reading).faults;
        let n_found = faults.iter().filter(|fault| fault.is_error()).count();
        assert_eq!(n_found, n_errors);
    }
}

#[test]
fn mimic_follows_once_and_from_zero_unless_told() {
    let mimic = |inside: &str| -> Mimic {
        joint("continuous", inside)
            .mimic
            .expect("it is given")
            .value
    };
    let plain = mimic("<mimic joint='other'/>");
    assert_eq!((plain.multiplier, plain.offset), (1.0, 0.0));
    assert_eq!(plain.joint.value, "other");
    let told = mimic("<mimic joint='other' multiplier='-2' offset='0.5'/>");
    assert_eq!((told.multiplier, told.offset), (-2.0, 0.5));
    assert!(joint("continuous", "").mimic.is_none());
}

#[test]
fn what_does_not_move_anything_is_passed_over() {
    let inside =
        "<visual/><collision><geometry/></collision><material/><sensor/><gazebo><x/></gazebo>
        <safety_controller soft_lower_limit='1'/><calibration rising='0'/><transmission/>";
    let text = robot(&[("j", "continuous", "a", "b", inside)]);
    let text = text.replace(
        "<link name=\"a\"/>",
        &format!("<link name=\"a\">{inside}</link>{inside}"),
    );
    let description = parse_well(&text, &Reading::default());
    assert_eq!(body_names(&description), ["a", "b"]);
}
