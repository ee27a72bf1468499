//! Numbers that look as if they had another unit, and what is no part of any function.

use kane_codegen::diagnostic::{Diagnostic, Severity};
use kane_test_support::models::{build, system};

use crate::mjcf_support::{faults, parse};

/// One body on another, both with hinges about one axis; what is added is of the second's joint.
fn arm() -> String {
    let hinge = "\"revolute\"\naxis = [0, 1, 0]";
    system("[0, 1]", &[("upper", hinge), ("fore", hinge)])
}

/// The same with this of the first body's joint, too.
fn with(mechanics: &str) -> String {
    let second = "\n[[body]]\nname = \"fore\"";
    arm().replace(second, &format!("{mechanics}{second}"))
}

fn warnings(text: &str) -> Vec<Diagnostic> {
    let told = build(text).expect("only warnings").warnings;
    let warnings = told.list().iter();
    let warnings = warnings.filter(|one| one.severity == Severity::Warning);
    warnings.cloned().collect()
}

#[track_caller]
fn is_accepted(text: &str) {
    assert_eq!(warnings(text), []);
}

#[test]
fn limits_of_turns_and_those_that_stand_for_none_are_accepted() {
    let limits = [
        "6.283185307179586",
        "12.5",
        "15.3",
        "50",
        "100",
        "314.159",
        "1e6",
    ];
    for limit in limits {
        is_accepted(&(arm() + &format!("limits = {{ lower = -{limit}, upper = {limit} }}\n")));
    }
    // Of a translation they are metres.
    let slide = arm().replace("revolute", "prismatic");
    is_accepted(&(slide + "limits = { lower = -15.0, upper = 15.0 }\n"));
}

#[test]
fn one_limit_in_degrees_is_a_warning() {
    let text = arm() + "limits = { lower = 0.0, upper = 145.0 }\n";
    insta::assert_snapshot!(build(&text).unwrap().warnings, @r"
    warning: a limit of body `fore` is 145.0 rad; is it in degrees?
      --> model.toml:21:33
       |
    21 | limits = { lower = 0.0, upper = 145.0 }
       |                                 ^^^^^ expected radians
    ");
}

#[test]
fn all_limits_of_a_model_in_degrees_are_told() {
    let round = "limits = { lower = -150.0, upper = 150.0 }\n";
    // By themselves they stand for none.
    is_accepted(&(arm() + round));
    let text = with(round) + "limits = { lower = -145.0, upper = 145.0 }\n";
    insta::assert_snapshot!(build(&text).unwrap().warnings.brief().lines[0].1);
}

#[test]
fn limits_of_coordinates_are_looked_at_too() {
    let of_list = arm().replace("\"revolute\"\naxis = [0, 1, 0]", "[\"theta2\"]");
    let limits = "limits = { lower = 0.0, upper = 145.0 }\n";
    assert_eq!(warnings(&(of_list.clone() + limits)).len(), 1);
    let of_one = "limits = { theta2 = { lower = 0.0, upper = 145.0 } }\n";
    assert_eq!(warnings(&(of_list.clone() + of_one)).len(), 1);
    // Of a translation they are metres.
    let with_slide = of_list.replace("[\"theta2\"]", "[\"theta2\", \"s1\"]");
    let of_slide = "limits = { s1 = { lower = 0.0, upper = 145.0 } }\n";
    is_accepted(&(with_slide + of_slide));
}

/// With all its lengths a thousand times as long.
fn in_millimetres(text: &str) -> String {
    let text = text.replace("[0.01, 0.02, -0.5]", "[10.0, 20.0, -500.0]");
    text.replace("[0.0, 0.1, 0.3]", "[0.0, 100.0, 300.0]")
}

#[test]
fn lengths_in_millimetres_are_a_warning() {
    insta::assert_snapshot!(build(&in_millimetres(&arm())).unwrap().warnings);
}

#[test]
fn one_length_in_millimetres_among_others_is_a_warning() {
    let text = arm().replacen("[0.01, 0.02, -0.5]", "[10.0, 20.0, -500.0]", 1);
    assert_eq!(warnings(&text).len(), 1);
    insta::assert_snapshot!(build(&text).unwrap().warnings.brief().lines[0].1);
    // A boom of the same length, and what hangs on a tether.
    let thin = "xx = 0.1, yy = 0.1, zz = 0.02, xy = 0.01";
    is_accepted(&text.replacen(thin, "xx = 4e4, yy = 4e4, zz = 0.02, xy = 0.01", 1));
    let tether = arm().replace(
        "attachment = [0.0, 0.1, 0.3]",
        "attachment = [0.0, 0.0, 60.0]",
    );
    is_accepted(&tether);
}

#[test]
fn inertias_in_kilogram_square_millimetres_are_a_warning() {
    let inertia = "xx = 0.1, yy = 0.1, zz = 0.02, xy = 0.01";
    let text = arm().replace(inertia, "xx = 1e5, yy = 1e5, zz = 2e4, xy = 1e4");
    insta::assert_snapshot!(build(&text).unwrap().warnings.brief().lines[0].1);
    // Of a large system they are what they are, and so they are of a body that is there for a joint alone.
    let heavy = arm().replace(inertia, "xx = 1e8, yy = 1e8, zz = 2e7, xy = 1e7");
    is_accepted(&heavy.replace("mass = 2.0", "mass = 4000.0"));
    let dummy = arm().replacen(inertia, "xx = 1.0, yy = 1.0, zz = 1.0, xy = 0.0", 1);
    is_accepted(&dummy.replacen("mass = 2.0", "mass = 1e-3", 1));
}

#[test]
fn gravity_in_millimetres_is_a_warning() {
    let text = arm().replace("gravity = [0, 0, 0]", "gravity = [0.0, 0.0, -9810.0]");
    insta::assert_snapshot!(build(&text).unwrap().warnings.brief().lines[0].1);
}

#[test]
fn long_systems_are_accepted_where_they_are_heavy_or_stand_far_away() {
    is_accepted(&in_millimetres(&arm()).replace("mass = 2.0", "mass = 4000.0"));
    // One long part, and a system far from the inertial frame's origin, on what is fixed there.
    let near = "attachment = [0.0, 0.1, 0.3]";
    let far = "attachment = [0.0, 0.1, 5000.0]";
    is_accepted(&arm().replace(near, far));
    let hinge = "\"revolute\"\naxis = [0, 1, 0]";
    let standing = system(
        "[0, 1, 2]",
        &[
            ("world", "\"fixed\""),
            ("base", "\"fixed\""),
            ("arm", hinge),
        ],
    );
    is_accepted(
        &standing
            .replace(near, far)
            .replace("[0.01, 0.02, -0.5]", "[0.0, 0.0, 0.0]"),
    );
}

/// What is told of friction.
fn told(text: &str) -> String {
    let warnings = build(text).expect("only warnings").warnings;
    let told = warnings.list().iter().map(|one| one.message.clone());
    let told: Vec<String> = told
        .filter(|message| message.contains("friction"))
        .collect();
    told.join("\n")
}

#[test]
fn friction_is_told_to_be_in_no_equation() {
    assert_eq!(told(&(arm() + "friction = 0.0\n")), "");
    let both = with("friction = 0.1\n") + "friction = 0.2\n";
    insta::assert_snapshot!(build(&both).unwrap().warnings.brief().lines[0].1);
    insta::assert_snapshot!(told(&(arm() + "friction = 0.2\n")), @"the friction of `fore` is in no equation of motion; the constant `FRICTION` holds it, for your program to add");
}

#[test]
fn offsets_between_joints_in_millimetres_are_a_warning_whatever_unit_bodies_have() {
    let hinge = "\"revolute\"\naxis = [0, 1, 0]";
    let bodies = ["one", "two", "three", "four"].map(|name| (name, hinge));
    let text = system("[0, 1, 2, 3]", &bodies);
    is_accepted(&text);
    let text = text.replace("[0.0, 0.1, 0.3]", "[0.0, 100.0, 300.0]");
    let told = build(&text).unwrap().warnings.brief().lines[0].1.clone();
    assert!(
        told.contains("most offsets between joints are above 20 m, the longest is 316.2 m"),
        "{told}"
    );
}

#[test]
fn one_offset_in_millimetres_among_others_is_a_warning() {
    let hinge = "\"revolute\"\naxis = [0, 1, 0]";
    let bodies = ["one", "two", "three", "four", "five"].map(|name| (name, hinge));
    let text = system("[0, 1, 2, 3, 4]", &bodies);
    let with = |z: &str| {
        let place = text.rfind("[0.0, 0.1, 0.3]").expect("all bodies have it");
        format!("{}[0.0, 0.0, {z}]{}", &text[..place], &text[place + 15..])
    };
    let found = warnings(&with("120.0"));
    let told = "body `five` is 120.0 m from the origin of its lower body, 379 times the median offset; is it in millimetres?";
    assert_eq!(found.len(), 1);
    assert_eq!(found[0].message, told);
    // A long boom, and a distance in no unit at all.
    is_accepted(&with("9.0"));
    is_accepted(&with("5000.0"));
    // Of a heavy system.
    is_accepted(&with("120.0").replace("mass = 2.0", "mass = 400.0"));
}

#[test]
fn each_of_two_offsets_in_millimetres_is_told_with_its_factor() {
    let hinge = "\"revolute\"\naxis = [0, 1, 0]";
    let bodies = ["one", "two", "three", "four", "five", "six"].map(|name| (name, hinge));
    let text = system("[0, 1, 2, 3, 4, 5]", &bodies);
    let mut parts: Vec<&str> = text.split("[0.0, 0.1, 0.3]").collect();
    let last = parts.pop().expect("units: a text has a part");
    let former = parts.pop().expect("units: all bodies have an offset");
    let first = parts.join("[0.0, 0.1, 0.3]");
    let text = format!("{first}[0.0, 0.0, 120.0]{former}[0.0, 0.0, 240.0]{last}");
    let found: Vec<String> = warnings(&text).into_iter().map(|one| one.message).collect();
    let told = |name: &str, metres: &str, factor: &str| {
        format!(
            "body `{name}` is {metres} m from the origin of its lower body, {factor} times the median offset; is it in millimetres?"
        )
    };
    let expected = [told("five", "120.0", "379"), told("six", "240.0", "759")];
    assert_eq!(found, expected);
}

#[test]
fn a_load_on_a_tether_below_rotors_is_accepted() {
    let hinge = "\"revolute\"\naxis = [0, 0, 1]";
    let hull = "[\"s1\", \"s2\", \"s3\"]";
    let rotors = ["front", "left", "rear", "right"].map(|name| (name, hinge));
    let mut bodies = vec![("hull", hull)];
    bodies.extend(rotors);
    bodies.push(("load", hinge));
    let text = system("[0, 1, 1, 1, 1, 1]", &bodies);
    let text = text.replace("[0.0, 0.1, 0.3]", "[0.15, 0.0, 0.0]");
    let place = text
        .rfind("[0.15, 0.0, 0.0]")
        .expect("units: all bodies have it");
    let with = |z: &str| format!("{}[0.0, 0.0, {z}]{}", &text[..place], &text[place + 16..]);
    is_accepted(&with("-25.0"));
    assert_eq!(warnings(&with("-150.0")).len(), 1);
}

/// Joints of rotation with these limits of velocity, and with what stands before them.
fn with_velocities<const N: usize>(range: &str, velocities: [&str; N]) -> String {
    let hinge = "\"revolute\"\naxis = [0, 1, 0]";
    let joints =
        velocities.map(|velocity| format!("{hinge}\nlimits = {{ {range}velocity = {velocity} }}"));
    let names = ["one", "two", "three", "four"].into_iter();
    let bodies: Vec<(&str, &str)> = names.zip(joints.iter().map(String::as_str)).collect();
    let lower: Vec<String> = (0..N).map(|body| body.to_string()).collect();
    system(&format!("[{}]", lower.join(", ")), &bodies)
}

#[test]
fn limits_of_velocity_in_degrees_are_a_warning_where_all_are() {
    let with = |velocities| with_velocities("lower = -2.0, upper = 2.0, ", velocities);
    let found = warnings(&with(["98.0", "180.0", "360.0"]));
    let told = "all 3 limits of velocity of rotations with a range are between 98.0 and 360.0 rad/s; are they in degrees per second?";
    assert_eq!(found.len(), 1);
    assert_eq!(found[0].message, told);
    for accepted in [
        ["6.0", "180.0", "360.0"],
        ["100.0", "100.0", "100.0"],
        ["180.0", "180.0", "838.0"],
        ["111.0", "111.0", "111.0"],
    ] {
        is_accepted(&with(accepted));
    }
    let slides = with(["98.0", "180.0", "360.0"]).replace("revolute", "prismatic");
    is_accepted(&slides);
}

#[test]
fn fast_wheels_and_propellers_are_accepted() {
    for velocity in ["60.0", "95.0"] {
        assert_eq!(
            warnings(&with_velocities(
                "lower = -2.0, upper = 2.0, ",
                [velocity; 4]
            ))
            .len(),
            1
        );
        is_accepted(&with_velocities("", [velocity; 4]));
        is_accepted(&with_velocities("lower = -2.0, ", [velocity; 4]));
    }
}

#[test]
fn shapes_in_millimetres_are_told_where_masses_follow_from_them() {
    let told = |settings: &str, geom: &str| {
        let text = format!(
            "<mujoco>{settings}<worldbody><geom type=\"box\" size=\"900 900 9\"/><body><joint axis=\"1 0 0\"/>{geom}</body></worldbody></mujoco>"
        );
        let description = parse(&text, &[]);
        assert!(
            !faults(&description).has_error(),
            "{}",
            faults(&description)
        );
        let warnings = description.faults.into_iter();
        let warnings = warnings.filter(|one| one.severity == Severity::Warning);
        warnings.map(|one| one.message).collect::<Vec<_>>()
    };
    let box_of = |size: &str| format!("<geom name=\"link\" type=\"box\" size=\"{size}\"/>");
    let said = told("", &box_of("60 70 80"));
    assert_eq!(
        said,
        [
            "geom `link` has a volume of 3e6 m³, and by its density a mass of 3e9 kg; is it in millimetres?"
        ]
    );
    // The largest ship, and shapes whose mass or density is given.
    let given = |own: &str| box_of("60 70 80").replace("/>", &format!(" {own}/>"));
    for geom in [
        box_of("244 37 22"),
        given("mass=\"1\""),
        given("density=\"1e-6\""),
    ] {
        assert_eq!(told("", &geom), Vec::<String>::new());
    }
    let total = "<compiler settotalmass=\"5\"/>";
    assert!(!told(total, &box_of("60 70 80")).concat().contains("volume"));
}
