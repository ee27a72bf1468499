//! Numbers that look as if they had another unit, and what is no part of any function.

use kane_test_support::models::{build, system};

/// One body on another, both with hinges about one axis; what is added is of the second's joint.
fn arm() -> String {
    let hinge = "\"revolute\"\naxis = [0, 1, 0]";
    system("[0, 1]", &[("upper", hinge), ("fore", hinge)])
}

#[track_caller]
fn is_accepted(text: &str) {
    let warnings = build(text).unwrap().warnings;
    assert!(warnings.is_empty(), "{warnings}");
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
    warning: a limit of body `fore` is 145.0 rad; are these degrees?
      --> model.toml:21:33
       |
    21 | limits = { lower = 0.0, upper = 145.0 }
       |                                 ^^^^^ expected radians
    ");
}

#[test]
fn long_systems_are_accepted_where_they_are_heavy_or_stand_far_away() {
    let (near, far) = (
        "attachment = [0.0, 0.1, 0.3]",
        "attachment = [0.0, 0.1, 40.0]",
    );
    let long = arm().replace(near, far);
    assert_eq!(build(&long).unwrap().warnings.list().len(), 1);
    is_accepted(&long.replacen("mass = 2.0", "mass = 4000.0", 1));
    is_accepted(&arm().replacen(near, far, 1));
}

#[test]
fn friction_is_told_to_be_data() {
    is_accepted(&(arm() + "friction = 0.0\n"));
    let text = arm() + "friction = 0.2\n";
    insta::assert_snapshot!(build(&text).unwrap().warnings, @r"
    note: `friction` of body `fore` is data, the constant `FRICTION`: no function adds it
      --> model.toml:21:12
       |
    21 | friction = 0.2
       |            ^^^ in no equation
    ");
}
